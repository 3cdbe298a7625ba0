// job.toml: all options of a run from one file (docs/job.md).
#pragma once

#include <mrsim/job_file.h>

#include <string>
#include <string_view>

namespace mrsim {

/// Reads a job from TOML. `name` stands in errors; relative paths become relative to its folder;
/// they lead out of it only where that is allowed. Throws PlacedError "job-syntax", "job-key",
/// "job-value", "job-outside"; unknown keys are errors.
JobFile parse_job(std::string_view text, const std::string& name, bool allow_outside = false);

/// parse_job() of a file. Throws what read_file throws, too.
JobFile load_job_file(const std::string& path, bool allow_outside = false);

}  // namespace mrsim
