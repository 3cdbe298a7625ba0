// The receiver of the interpreter's results.
#pragma once

#include <mrsim/types.h>

namespace mrsim {

/// Receives motions and events in program order.
class MotionSink {
 public:
  virtual ~MotionSink() = default;
  /// Called once before all others. `program` stays valid while interpret runs; its files, calls
  /// and tools grow before the motions that name them come.
  virtual void begin(const Program& program) { (void)program; }
  virtual void motion(const Motion& motion) = 0;
  /// The control does something after the motions so far. The receiver fills Event::before if it
  /// counts motions.
  virtual void event(const Event& event) { (void)event; }
  /// Asked before each block is carried out: a number above 0 comes back by mark(), behind the
  /// motions and events of the blocks before it. `file` and `call`: indices into Program::files and
  /// Program::calls.
  virtual int mark_before(int file, int line, int call) {
    (void)file, (void)line, (void)call;
    return 0;
  }
  virtual void mark(int number) { (void)number; }
  virtual void diagnostic(const Diagnostic& diagnostic) = 0;
  /// A variable got a value (InterpOptions::trace_variables): its name as written, and the value.
  virtual void assignment(const SourcePlace& place, const std::string& name,
                          const std::string& value) {
    (void)place, (void)name, (void)value;
  }
};

/// Adds a dwell to the one before it, `last`, where no motion lies between: so a loop of dwells
/// takes no memory. False: it is an event of its own.
inline bool joins(const Event& dwell, Event& last) {
  if (dwell.kind != EventKind::dwell || last.kind != EventKind::dwell || dwell.tool != last.tool)
    return false;
  last.seconds += dwell.seconds;
  return true;
}

}  // namespace mrsim
