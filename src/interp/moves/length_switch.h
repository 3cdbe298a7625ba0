// Finds tools that cut both with their length (G43) and without it (G49). On the machine these cuts
// are as far apart as the tool is long; here they are not, because that length is unknown. It does
// not ask what a length is: `mode` is a number for each way of counting it. Private to src/interp.
#pragma once

#include <mrsim/types.h>

#include <limits>
#include <map>
#include <vector>

namespace mrsim {

class LengthSwitch {
 public:
  /// Called after each motion of the tool; `incremental`: it was not in absolute coordinates. True:
  /// it goes down to where the tool has cut in another mode. A motion that goes up, or stays above
  /// the cuts of that mode, contradicts nothing.
  bool contradicts(int tool, int mode, const Motion& motion, bool incremental);

 private:
  /// Heights of cuts, mm.
  struct Depths {
    double low = std::numeric_limits<double>::infinity();   ///< lowest end
    double top = -std::numeric_limits<double>::infinity();  ///< highest start of a way down
  };
  void change(int tool, int mode);

  std::map<int, std::map<int, Depths>> cuts_;  ///< by tool and mode
  int tool_ = -2, mode_ = -1;
  bool told_ = false;           ///< Z was programmed since the last change of tool or mode
  Depths* own_ = nullptr;       ///< the depths of this mode, once it has cut
  std::vector<Depths> others_;  ///< the depths of the other modes
};

}  // namespace mrsim
