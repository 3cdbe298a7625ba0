// Threads that turning tools cut: no bodies of revolution, so a part has none of them.
#pragma once

#include <mrsim/mrsim.h>

#include <map>
#include <vector>

namespace mrsim {

class ThreadPasses {
 public:
  /// Takes note of a motion of the program, if it is such a pass.
  void add(const Program& program, const Motion& motion);
  /// A warning for each tool, at its first pass.
  std::vector<Diagnostic> warnings(const Program& program) const;

 private:
  struct Passes {
    Motion first;
    std::size_t count = 0;
  };
  std::map<int, Passes> by_tool_;
};

}  // namespace mrsim
