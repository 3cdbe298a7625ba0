// Any bytes as a program, recognised and in three of ten dialects and machines that its bytes
// choose: no crash, no hang, no motion that is not finite, and an arc is an arc.
#include "interp/interpreter.h"
#include "interp/show/motion_text.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <string_view>

#include <unistd.h>

namespace {

using namespace mrsim;

void require(bool condition) {
  if (!condition) std::abort();
}

bool finite(const Vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

class CheckingSink : public MotionSink {
 public:
  void motion(const Motion& m) override {
    require(finite(m.start) && finite(m.end) && finite(m.center));
    require(m.line > 0 && m.column > 0);
    if (m.kind == MotionKind::arc)
      require(m.radius > 0 && std::isfinite(m.sweep) && m.sweep != 0 && std::isfinite(m.rise));
  }
  void diagnostic(const Diagnostic& d) override {
    require(!d.code.empty() && !d.text.empty());
    require(diagnostic_json(d).size() > 2);
  }
};

// One file per process, beside nothing else, so that no subprogram is found by accident.
const std::string& program_path() {
  static const std::string path = [] {
    std::string folder = "/tmp/mrsim-fuzz-XXXXXX";
    require(::mkdtemp(folder.data()) != nullptr);
    return folder + "/program";
  }();
  return path;
}

InterpOptions options_of(int i) {
  InterpOptions options;
  options.dialect = static_cast<Dialect>(1 + i % 5);
  options.machine = i < 5 ? MachineKind::mill : MachineKind::lathe;
  options.max_blocks = 3000;
  Tool tool;
  tool.diameter = 2;
  tool.nose_radius = 0.4;
  if (i >= 5) tool.type = ToolType::turning;
  if (i % 2) options.table.tools.push_back(tool);
  if (i % 2) options.start = Vec3{};
  options.table.offsets.push_back({"D3", 5, 0, 0});
  return options;
}

void read_program(const InterpOptions& options) {
  CheckingSink sink;
  try {
    interpret(program_path(), options, sink);
  } catch (const Error&) {  // an empty program, a machine that cannot be told
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::FILE* file = std::fopen(program_path().c_str(), "wb");
  require(file != nullptr);
  if (size > 0) std::fwrite(data, 1, size, file);
  std::fclose(file);
  InterpOptions options;
  options.max_blocks = 3000;
  read_program(options);
  const std::size_t chosen =
      std::hash<std::string_view>()({reinterpret_cast<const char*>(data), size});
  for (int i = 0; i < 3; ++i) read_program(options_of(static_cast<int>((chosen + 3 * i) % 10)));
  return 0;
}
