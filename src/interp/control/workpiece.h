// WORKPIECE(...) of SINUMERIK, which states the stock. Private to src/interp.
#pragma once

#include "interp/control/control.h"

#include <array>

namespace mrsim {

class WorkpieceWords : public ControlPart {
 public:
  explicit WorkpieceWords(Control& control) : ControlPart(control) {}
  /// Sets Program::workpiece. False: an error was reported.
  bool run();

 private:
  bool set(const std::string& type, const std::array<double, 12>& v, const Word& where);
};

}  // namespace mrsim
