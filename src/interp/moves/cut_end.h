// Whether the tool has left the part where a program's text ends: a file that ends in a cut may
// have been cut off.
#pragma once

#include "core/numbers/rounding.h"
#include <mrsim/types.h>

#include <optional>

namespace mrsim {

class CutEnd {
 public:
  void see(const Motion& motion, bool lathe);
  /// The tool goes to a place that only the machine knows.
  void leave() { in_cut_ = false; }
  bool in_cut() const { return in_cut_; }

 private:
  bool leaves(const Motion& motion, bool lathe) const;

  bool in_cut_ = false;
  double highest_ = -kInfinity, deepest_ = kInfinity;  ///< Z of all moves; of cuts
  std::optional<double> travel_;    ///< mill: the lower Z of the last rapid in the plane
  std::optional<double> approach_;  ///< lathe: X where the last rapid has ended
};

}  // namespace mrsim
