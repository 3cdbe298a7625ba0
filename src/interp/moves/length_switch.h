// Cuts of one tool with its length (G43) and without it (G49): on the machine they are as far apart
// as the tool is long, and here they are not, where that length is unknown. Private to src/interp.
// Does not: ask what a length is; `mode` is one number for each way of counting it.
#pragma once

#include <mrsim/types.h>

#include <map>

namespace mrsim {

class LengthSwitch {
 public:
  /// After each motion of the tool, in absolute coordinates or not. True: it ends in a place that
  /// the tool has cut at by another mode.
  bool contradicts(int tool, int mode, const Motion& motion, bool incremental);

 private:
  void change(int tool, int mode);

  std::map<int, std::map<int, double>> tops_;  ///< highest start of cuts, mm, by mode
  int tool_ = -2, mode_ = -1;
  bool told_ = false;      ///< Z was programmed since tool and mode are these
  double* top_ = nullptr;  ///< of this mode, once it has cut
  double others_ = 0;      ///< of the other modes
};

}  // namespace mrsim
