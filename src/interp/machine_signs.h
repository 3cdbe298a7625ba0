// Signs of a mill or a lathe in a program's text.
#pragma once

#include "interp/line_scan.h"
#include "interp/recognise.h"

namespace mrsim {

class MachineSigns {
 public:
  void line(const LineScan& s, int n, Dialect dialect);
  /// A sign was seen that needs no other.
  bool settled() const { return !mill_.empty() || !lathe_.empty(); }
  /// Y and J say no more.
  bool knows_mill() const { return !mill_.empty(); }
  /// Sets machine and reason for the dialect of `out`.
  void judge(const InterpOptions& options, Recognition& out) const;

 private:
  void fanuc_line(const std::string& code, int n);

  std::string mill_, lathe_;  ///< where the first such sign is
  std::string turning_;       ///< counts if nothing moves in Y
  std::string
      turret_;  ///< the same, if nothing is changed by M6 and no comment names a mill's tool
  std::string turning_tool_, milling_tool_;
  bool changes_ = false;  ///< M6
};

}  // namespace mrsim
