#include "setup/camotics_project.h"

#include "core/process/error.h"
#include "core/text/text_io.h"
#include "setup/json_reader.h"

#include <array>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace mrsim {
namespace {

constexpr std::size_t kProjectFileLimit = std::size_t(16) << 20;

[[noreturn]] void fail(const std::string& path, const std::string& what) {
  throw Error("job-value", fmt::format("{}: {}", path, what));
}

std::array<double, 3> corner(const Json& bounds, const char* key, const std::string& path) {
  const Json& list = json_at(bounds, key);
  std::array<double, 3> out{};
  if (!list.is_array() || list.size() != 3) fail(path, "the workpiece's bounds are incomplete");
  for (std::size_t i = 0; i < 3; ++i) {
    if (!list[i].is_number() || !(std::fabs(list[i].get<double>()) < 1e5))
      fail(path, "the workpiece's bounds are no numbers below 100 m");
    out[i] = list[i].get<double>();
  }
  return out;
}

std::string program_of(const Json& root, const std::string& path) {
  const Json& files = json_at(root, "files");
  std::vector<std::string> names;
  if (files.is_array())
    for (const Json& file : files)
      if (file.is_string()) names.push_back(file.get<std::string>());
  if (names.empty()) fail(path, "the project names no program");
  if (names.size() > 1)
    fail(path, fmt::format("the project has {} programs: run them one after the other, with "
                           "--tools {} and the part before as --stock",
                           names.size(), path));
  if (std::filesystem::path(names[0]).extension() == ".tpl")
    fail(path, fmt::format("{} is a script of CAMotics: save its G-code and name that", names[0]));
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  return (folder / names[0]).lexically_normal().string();
}

}  // namespace

JobFile load_camotics_project(const std::string& path) {
  const Json root = parse_json(read_file(path, kProjectFileLimit), path);
  JobFile job;
  job.program = program_of(root, path);
  const Json& workpiece = json_at(root, "workpiece");
  const Json& automatic = json_at(workpiece, "automatic");
  const Json& bounds = json_at(workpiece, "bounds");
  const bool fitted = automatic.is_boolean() && automatic.get<bool>();
  if (!fitted && bounds.is_object()) {
    const auto low = corner(bounds, "min", path), high = corner(bounds, "max", path);
    job.options.push_back({"--stock",
                           {fmt::format("box:{},{},{},{},{},{}", low[0], low[1], low[2], high[0],
                                        high[1], high[2])}});
  }
  if (json_at(root, "tools").is_object() && !json_at(root, "tools").empty())
    job.options.push_back({"--tools", {path}});
  return job;
}

}  // namespace mrsim
