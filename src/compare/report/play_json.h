// What the page plays, as the part "play" of the report's data (docs/report.md).
#pragma once

#include <mrsim/report_html.h>

#include <cstddef>

#include <nlohmann/json.hpp>

namespace mrsim {

/// `files`: number of programs that the report names; those of the run come last. Null where
/// nothing was prepared.
nlohmann::ordered_json play_json(const ReportRun& run, std::size_t files);

}  // namespace mrsim
