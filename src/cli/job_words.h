// job.toml beside the command line.
#pragma once

#include <string>
#include <vector>

namespace mrsim::cli {

/// Whether the input of a run is a job and not a program.
bool is_job(const std::vector<std::string>& inputs);

/// Pictures of a job's run leave out what it says of files and of a comparison.
enum class JobUse { run, pictures };

/// The command line that stands for job.toml and what is typed beside it; the first word is
/// argv[0]. An option that is typed replaces the file's, all of them where it may be repeated.
std::vector<std::string> job_words(const std::string& path, int argc, const char* const* argv,
                                   JobUse use);

}  // namespace mrsim::cli
