#include "interp/interpreter.h"

#include "interp/control/start_modes.h"
#include "interp/engine.h"
#include "interp/recognise/recognise.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace mrsim {
namespace {

void tell(const Program& program, Severity severity, const char* code, std::string text,
          MotionSink& sink) {
  Diagnostic finding;
  finding.severity = severity;
  finding.code = code;
  finding.text = std::move(text);
  finding.place.file = program.files.front();
  sink.diagnostic(finding);
}

std::string_view without_zeros(std::string_view id) {
  return id.substr(std::min(id.find_first_not_of('0'), id.size()));
}

bool calls(const Program& program, const std::string& id) {
  return std::any_of(program.tools.begin(), program.tools.end(),
                     [&](const Tool& tool) { return without_zeros(tool.id) == without_zeros(id); });
}

// Tells of options that have no meaning for this program.
void tell_idle_options(const InterpOptions& options, const Program& program, MotionSink& sink) {
  if (options.least_increments && program.dialect != Dialect::fanuc)
    tell(program, Severity::warning, "least-increments",
         "--least-increments is for FANUC: numbers without a point are read as this control reads "
         "them",
         sink);
  for (const Tool& tool : options.table.tools)
    if (tool.origin == "--tool" && !tool.id.empty() && !calls(program, tool.id))
      tell(program, Severity::note, "tool-unused",
           fmt::format("--tool {}: the program moves no tool of that name", tool.id), sink);
}

}  // namespace

Program interpret(const std::string& path, const InterpOptions& options, MotionSink& sink) {
  const Recognition found = recognise(path, options);
  if (found.empty) throw Error("program-empty", fmt::format("{} is empty", path));
  Program program;
  program.files.push_back(path);
  program.dialect = found.dialect;
  program.dialect_reason = found.dialect_reason;
  program.machine = found.machine;
  program.machine_reason = found.machine_reason;
  if (program.machine == MachineKind::automatic)
    throw Error(
        "machine-unclear",
        fmt::format("{}: is this for a mill or a lathe? ({}) Say --machine mill or --machine "
                    "lathe",
                    path, found.machine_reason),
        Error::Kind::usage);
  program.start_modes = start_mode_names(program.dialect, program.machine);
  sink.begin(program);
  Engine engine(options, program, found.leader_lines, found.okuma, sink);
  engine.run();
  tell_idle_options(options, program, sink);
  return program;
}

}  // namespace mrsim
