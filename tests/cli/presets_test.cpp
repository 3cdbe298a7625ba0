// The presets of the build: those of one folder (release, ci, demo) follow each other in it.
#include "run_program.h"

#include <fstream>
#include <set>
#include <string>

#include <nlohmann/json.hpp>

namespace mrsim {
namespace {

using namespace mrsim::testing;

// What one preset sets and the next one does not stays as it was: `./setup test` behind
// `./setup demo` found no tests.
TEST(Presets, ThoseOfOneFolderSetTheSameOptions) {
  std::ifstream file(std::string(MRSIM_DATA_DIR) + "/../CMakePresets.json");
  const nlohmann::json presets = nlohmann::json::parse(file);
  std::set<std::string> base, others;
  for (const nlohmann::json& preset : presets["configurePresets"])
    if (preset["name"] == "release" || !preset.contains("binaryDir"))
      for (const auto& [name, value] : preset["cacheVariables"].items())
        (preset["name"] == "release" ? base : others).insert(name);
  EXPECT_GE(others.size(), 3u);
  for (const std::string& name : others) EXPECT_TRUE(base.count(name) > 0) << name;
  for (const nlohmann::json& preset : presets["testPresets"])
    if (preset.contains("execution")) {
      EXPECT_EQ(preset["execution"].value("noTestsAction", ""), "error") << preset["name"];
    }
}

}  // namespace
}  // namespace mrsim
