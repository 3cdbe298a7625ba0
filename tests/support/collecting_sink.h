// Keeps what the interpreter hands out.
#pragma once

#include "interp/interpreter.h"

#include <vector>

namespace mrsim::testing {

class CollectingSink : public MotionSink {
 public:
  void motion(const Motion& m) override { motions.push_back(m); }
  void event(const Event& e) override {
    events.push_back(e);
    events.back().before = motions.size();
  }
  void diagnostic(const Diagnostic& d) override { diagnostics.push_back(d); }
  std::vector<Motion> motions;
  std::vector<Event> events;
  std::vector<Diagnostic> diagnostics;
};

}  // namespace mrsim::testing
