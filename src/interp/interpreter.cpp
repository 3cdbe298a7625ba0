#include "interp/interpreter.h"

#include "interp/control/start_modes.h"
#include "interp/engine.h"
#include "interp/recognise/recognise.h"

#include <fmt/format.h>

namespace mrsim {

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
  return program;
}

}  // namespace mrsim
