// NC text to motions, as the control would read it: streaming, one motion per cutting block, every
// fault a Diagnostic.
#pragma once

#include <mrsim/options.h>
#include <mrsim/types.h>

#include <string>

namespace mrsim {

/// Takes what the interpreter finds, in program order.
class MotionSink {
 public:
  virtual ~MotionSink() = default;
  /// Called once before all others. `program` stays valid while interpret runs; its files, calls
  /// and tools grow before the motions that name them come.
  virtual void begin(const Program& program) { (void)program; }
  virtual void motion(const Motion& motion) = 0;
  virtual void diagnostic(const Diagnostic& diagnostic) = 0;
};

/// Reads the program at `path`, hands motions and diagnostics to `sink` as they come and returns
/// the rest of Program (its motions and diagnostics are empty). Memory does not grow with the
/// length of the program. Throws Error "file-...", "program-empty", "machine-unclear" (kind usage).
Program interpret(const std::string& path, const InterpOptions& options, MotionSink& sink);

}  // namespace mrsim
