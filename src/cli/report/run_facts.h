// What the page of a report says of a run.
#pragma once

#include <mrsim/mrsim.h>
#include <mrsim/report_html.h>

#include <string>
#include <vector>

namespace mrsim::cli {

/// The lines of a run that collide, the deepest first.
std::vector<ReportCollision> collisions_of(const JobResult& result);
/// The facts of a run for its report.
ReportFacts facts_of(const JobResult& result, const std::string& program);

}  // namespace mrsim::cli
