// Runs program text through the interpreter and keeps what comes out.
#pragma once

#include "core/numbers/units.h"
#include "interp/interpreter.h"
#include "interp/show/motion_text.h"
#include "support/collecting_sink.h"
#include "support/temp_folder.h"

#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace mrsim::testing {

inline Program read_program(const std::string& path, const InterpOptions& options) {
  CollectingSink sink;
  Program program = interpret(path, options, sink);
  program.motions = std::move(sink.motions);
  program.events = std::move(sink.events);
  program.diagnostics = std::move(sink.diagnostics);
  return program;
}

inline std::vector<Event> dwells_of(const Program& program) {
  std::vector<Event> out;
  for (const Event& event : program.events)
    if (event.kind == EventKind::dwell) out.push_back(event);
  return out;
}

/// Options of a test: everything known, a tool in the spindle, the tool at the origin.
inline InterpOptions at_origin(Dialect dialect, MachineKind machine = MachineKind::mill) {
  InterpOptions options;
  options.dialect = dialect;
  options.machine = machine;
  options.start = Vec3{};
  options.comp = CompRadius::radius;
  Tool tool;
  tool.diameter = 10;
  tool.origin = "test";
  if (machine == MachineKind::lathe) tool.type = ToolType::turning;
  options.table.tools.push_back(tool);
  return options;
}

/// Most texts of tests are pieces of programs, with no word at their end: that is not kept.
inline Program read_text(const std::string& text, const InterpOptions& options,
                         const std::string& name = "program.nc") {
  const TempFolder scratch;
  Program program = read_program(scratch.write(name, text), options);
  std::erase_if(program.diagnostics, [](const Diagnostic& d) {
    return d.code == "program-end-missing" && d.text.starts_with("the file ends here");
  });
  return program;
}

/// A program's first cut, behind a tool change.
inline const char* const kCut = "G0 X0 Y0 Z5\nG1 Z-1 F100\nX5\n";

inline std::string codes(const Program& program, Severity least = Severity::warning) {
  std::string out;
  for (const Diagnostic& d : program.diagnostics)
    if (d.severity >= least) out += (out.empty() ? "" : " ") + d.code;
  return out;
}

inline std::string listing(const Program& program) {
  std::string out;
  for (const Motion& m : program.motions) out += motion_text(program, m) + "\n";
  for (const Diagnostic& d : program.diagnostics) out += diagnostic_json(d) + "\n";
  return out;
}

/// "l X,Y,Z" for a line, "a" for an arc, "r" for a rapid, with the codes behind a bar.
inline std::string path_text(const Program& program) {
  std::string out;
  for (const Motion& m : program.motions)
    out += fmt::format("{}{:.4g},{:.4g},{:.4g} ", "rla"[static_cast<int>(m.kind)], m.end.x + 0.0,
                       m.end.y + 0.0, m.end.z + 0.0);
  if (!out.empty()) out.pop_back();
  return out + (codes(program).empty() ? "" : " | " + codes(program));
}

/// path_text() of a mill's program that begins at the origin.
inline std::string mill(const std::string& text, Dialect dialect = Dialect::fanuc) {
  return path_text(read_text(text, at_origin(dialect)));
}

inline void expect_near(const Vec3& actual, const Vec3& expected, double tolerance = 1e-9) {
  EXPECT_NEAR(actual.x, expected.x, tolerance);
  EXPECT_NEAR(actual.y, expected.y, tolerance);
  EXPECT_NEAR(actual.z, expected.z, tolerance);
}

}  // namespace mrsim::testing
