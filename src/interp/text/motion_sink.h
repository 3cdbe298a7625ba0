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
  /// The control does something behind the motions so far; `before` is left to who counts them.
  virtual void event(const Event& event) { (void)event; }
  virtual void diagnostic(const Diagnostic& diagnostic) = 0;
  /// A variable got a value (InterpOptions::trace_variables): its name as written, and the value.
  virtual void assignment(const SourcePlace& place, const std::string& name,
                          const std::string& value) {
    (void)place, (void)name, (void)value;
  }
};

/// A dwell behind another one, with no motion between, makes that one longer: a loop of them takes
/// no memory. False: it is an event of its own.
inline bool joins(const Event& dwell, Event& last) {
  if (dwell.kind != EventKind::dwell || last.kind != EventKind::dwell || dwell.tool != last.tool)
    return false;
  last.seconds += dwell.seconds;
  return true;
}

}  // namespace mrsim
