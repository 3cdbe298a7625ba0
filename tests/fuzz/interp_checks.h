// What fuzz targets of the interpreter demand of a program: no motion that is not finite, an arc is
// an arc, every diagnostic has a code and a text. The program lies in a folder of its own, so that
// no subprogram is found by accident.
#pragma once

#include "fuzz_files.h"
#include "interp/interpreter.h"
#include "interp/show/motion_text.h"

#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>

namespace mrsim::fuzz {

inline bool finite(const Vec3& v) {
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

inline std::string program_path() { return folder() + "/program"; }

inline void write_program(std::string_view text) { write("program", text); }

/// `i` from 0 to 9: five dialects, as mills and as lathes.
inline InterpOptions options_of(int i) {
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

inline void read_program(const InterpOptions& options) {
  CheckingSink sink;
  try {
    interpret(program_path(), options, sink);
  } catch (const Error&) {  // an empty program, a machine that cannot be told
  }
}

}  // namespace mrsim::fuzz
