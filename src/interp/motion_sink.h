// What the interpreter hands its results to.
#pragma once

#include <mrsim/types.h>

namespace mrsim {

/// Takes what the interpreter finds, in program order.
class MotionSink {
 public:
  virtual ~MotionSink() = default;
  /// Called once before all others. `program` stays valid while interpret runs; its files, calls
  /// and tools grow before the motions that name them come.
  virtual void begin(const Program& program) { (void)program; }
  virtual void motion(const Motion& motion) = 0;
  /// The tool stays behind the motions so far; `after` is left to who counts them.
  virtual void dwell(const Dwell& dwell) { (void)dwell; }
  virtual void diagnostic(const Diagnostic& diagnostic) = 0;
  /// A variable got a value (InterpOptions::trace_variables): its name as written, and the value.
  virtual void assignment(const SourcePlace& place, const std::string& name,
                          const std::string& value) {
    (void)place, (void)name, (void)value;
  }
};

}  // namespace mrsim
