// A project of CAMotics as a job: program, tools and stock.
#pragma once

#include <mrsim/job_file.h>

#include <string>

namespace mrsim {

/// The first file of the project, its workpiece as a box, its tools. Throws Error "job-value" for a
/// project that names no program or several, and what parse_json() throws.
JobFile load_camotics_project(const std::string& path);

}  // namespace mrsim
