#include "cli/job_words.h"

#include "core/option_table.h"
#include <mrsim/job_file.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

namespace mrsim::cli {
namespace {

// Before parsing: "--voxel 1" and "--voxel=1", "-o x" and "-ox".
bool is_typed(const std::string& option, const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    if (word == option || word.starts_with(option + "=")) return true;
    if (option == "--output" && word.starts_with("-o")) return true;
  }
  return false;
}

// Pictures of a run take its options, but for its files and the moments of its parts.
bool is_for_pictures(const std::string& option) {
  static constexpr std::array<std::string_view, 5> kOthers = {"--output", "--frames", "--until",
                                                              "--history", "--rest"};
  return find_option(option, kUseFilm) != nullptr &&
         std::find(kOthers.begin(), kOthers.end(), option) == kOthers.end();
}

}  // namespace

bool is_job(const std::vector<std::string>& inputs) {
  if (inputs.size() != 1) return false;
  const std::string extension = std::filesystem::path(inputs[0]).extension().string();
  return extension == ".toml" || extension == ".camotics";
}

std::vector<std::string> job_words(const std::string& path, int argc, const char* const* argv,
                                   JobUse use) {
  const std::vector<std::string> typed(argv + 1, argv + argc);
  const bool outside = std::find(typed.begin(), typed.end(), "--allow-outside") != typed.end();
  const JobFile job = load_job(path, outside);
  std::vector<std::string> words = {argv[0], job.program};
  for (const JobOption& option : job.options) {
    if (is_typed(option.option, typed)) continue;
    if (use == JobUse::pictures && !is_for_pictures(option.option)) continue;
    if (option.values.empty()) words.push_back(option.option);
    for (const std::string& value : option.values) words.push_back(option.option + "=" + value);
  }
  bool dropped = false;  // the job itself gives way to its program
  for (const std::string& word : typed)
    if (dropped || word != path)
      words.push_back(word);
    else
      dropped = true;
  return words;
}

}  // namespace mrsim::cli
