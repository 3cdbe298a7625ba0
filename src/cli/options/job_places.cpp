#include "cli/options/job_places.h"

#include <algorithm>
#include <string_view>

namespace mrsim::cli {
namespace {

// "--voxel 0 must be above 0", "voxel ...", "--until: no motion ...", and the codes of stages:
// "until-beyond", "stock-spec".
bool is_option_meant(const Error& fault, std::string_view option) {
  if (option.empty()) return false;  // the program, which is known by its file
  const std::string_view what = fault.what(), code = fault.code(), name = option.substr(2);
  const auto begins = [&](std::string_view word) {
    return what.starts_with(word) && what.size() > word.size() &&
           (what[word.size()] == ' ' || what[word.size()] == ':');
  };
  // "output-full" speaks of any output.
  const bool by_code = option != "--output" && code.starts_with(name) &&
                       code.size() > name.size() && code[name.size()] == '-';
  return begins(option) || begins(name) || by_code;
}

// "a.stl: no such file", "cannot write a/b.json: ...", "a.nc (--report) would overwrite ...".
bool is_file_meant(const Error& fault, const std::string& file) {
  const std::string_view what = fault.what(), code = fault.code();
  if (!code.starts_with("file-") && !code.starts_with("output-") && code != "mesh-format")
    return false;
  const std::size_t at = what.find(file), end = at + file.size();
  return !file.empty() && at != what.npos && (at == 0 || what[at - 1] == ' ') &&
         (end == what.size() || what[end] == ':' || what[end] == ' ');
}

}  // namespace

void show_in_job(const Error& fault, const JobPlaces& job) {
  for (const JobOption& option : job.options) {
    if (option.line == 0) continue;  // a job that is made from another file
    const bool is_meant =
        is_option_meant(fault, option.option) ||
        std::any_of(option.values.begin(), option.values.end(),
                    [&](const std::string& v) { return is_file_meant(fault, v); });
    if (!is_meant) continue;
    Diagnostic diagnostic;
    diagnostic.code = fault.code();
    diagnostic.text = fault.what();
    diagnostic.place = {job.path, option.line, option.column};
    throw PlacedError(diagnostic, fault.kind());
  }
}

}  // namespace mrsim::cli
