/// job.toml: all options of a run in one file (docs/job.md).
#pragma once

#include <mrsim/types.h>

#include <string>
#include <vector>

namespace mrsim {

/// One key of the file, as the option of the command line that it stands for.
struct JobOption {
  std::string option;               ///< "--voxel"
  std::vector<std::string> values;  ///< one for each time it would be typed; none: a flag
  int line = 0, column = 0;         ///< of its value in the file; 0: not known
};

struct JobFile {
  std::string program;
  int line = 0, column = 0;        ///< of the program's name
  std::vector<JobOption> options;  ///< in the order of mrsim --help
};

/// Reads a job; relative paths become relative to its folder, and may lead out of it (..) only
/// where `allow_outside` says so; absolute ones always may. Throws Error for a file that cannot be
/// read, and PlacedError "job-syntax", "job-key", "job-value", "job-outside" with line and column.
MRSIM_API JobFile load_job(const std::string& path, bool allow_outside = false);

}  // namespace mrsim
