// Cuts of one tool with its length (G43) and without it (G49): on the machine they are as far apart
// as the tool is long, and here they are not, where that length is unknown. Private to src/interp.
// Does not: ask what a length is; `mode` is one number for each way of counting it.
#pragma once

#include <mrsim/types.h>

#include <limits>
#include <map>
#include <vector>

namespace mrsim {

class LengthSwitch {
 public:
  /// After each motion of the tool, in absolute coordinates or not. True: it goes down to where the
  /// tool has cut by another mode. What goes up, or stays above the cuts of that mode, is none.
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
  bool told_ = false;           ///< Z was programmed since tool and mode are these
  Depths* own_ = nullptr;       ///< of this mode, once it has cut
  std::vector<Depths> others_;  ///< of the other modes
};

}  // namespace mrsim
