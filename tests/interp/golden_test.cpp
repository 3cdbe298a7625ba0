// tests/golden/<case>/: case.txt names a program of data/ and its options, expected.txt is the
// trace. scripts/golden.py makes expected.txt anew (it runs this test with MRSIM_GOLDEN_UPDATE=1).
#include "interp/support.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <map>
#include <sstream>

namespace mrsim {
namespace {

using namespace mrsim::testing;

namespace fs = std::filesystem;

std::map<std::string, std::string> read_case(const fs::path& path) {
  std::map<std::string, std::string> out;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    const std::size_t equal = line.find('=');
    if (!line.empty() && line[0] != '#' && equal != std::string::npos)
      out[line.substr(0, equal)] = line.substr(equal + 1);
  }
  return out;
}

InterpOptions options_of(const std::map<std::string, std::string>& fields) {
  InterpOptions options;
  if (const auto at = fields.find("machine"); at != fields.end())
    options.machine = at->second == "mill" ? MachineKind::mill : MachineKind::lathe;
  if (const auto at = fields.find("diameter"); at != fields.end()) {
    Tool tool;
    tool.diameter = std::stod(at->second);
    tool.origin = "--tool";
    options.table.tools.push_back(tool);
  }
  if (const auto at = fields.find("D3"); at != fields.end())
    options.table.offsets.push_back({"D3", std::stod(at->second), 0, 0});
  return options;
}

/// Writes motions and diagnostics in the order they come.
class TraceSink : public MotionSink {
 public:
  explicit TraceSink(std::string& out) : out_(out) {}
  void motion(const Motion& m) override { motions.push_back(m); }
  void diagnostic(const Diagnostic& d) override { found += diagnostic_json(d) + "\n"; }
  void finish(const Program& program) {
    for (const Motion& m : motions) out_ += motion_json(program, m) + "\n";
    out_ += found;
  }
  std::vector<Motion> motions;
  std::string found;

 private:
  std::string& out_;
};

std::string trace(const std::map<std::string, std::string>& fields) {
  std::string out = "# made by scripts/golden.py\n";
  TraceSink sink(out);
  const Program p = interpret(fields.at("program"), options_of(fields), sink);
  out += "# dialect: " + p.dialect_reason + "; machine: " + p.machine_reason + "\n";
  sink.finish(p);
  return out;
}

std::vector<std::string> cases() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(fs::path(MRSIM_DATA_DIR) / "../tests/golden"))
    if (fs::exists(entry.path() / "case.txt")) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

class Golden : public ::testing::TestWithParam<std::string> {};

TEST_P(Golden, TraceIsTheExpectedOne) {
  const fs::path folder = fs::path(MRSIM_DATA_DIR) / "../tests/golden" / GetParam();
  fs::current_path(MRSIM_DATA_DIR);  // paths in the trace are relative to the data
  const std::string actual = trace(read_case(folder / "case.txt"));
  if (std::getenv("MRSIM_GOLDEN_UPDATE")) std::ofstream(folder / "expected.txt") << actual;
  std::stringstream expected;
  expected << std::ifstream(folder / "expected.txt").rdbuf();
  EXPECT_EQ(actual, expected.str());
}

std::string test_name(const ::testing::TestParamInfo<std::string>& tested) {
  std::string name = tested.param;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); },
      '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Programs, Golden, ::testing::ValuesIn(cases()), test_name);

}  // namespace
}  // namespace mrsim
