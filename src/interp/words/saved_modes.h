// M70 to M73 of LinuxCNC save the modes in force for the running subprogram, and restore them.
// Private to src/interp.
#pragma once

#include "interp/control/control.h"

#include <map>

namespace mrsim {

class SavedModes : public ControlPart {
 public:
  explicit SavedModes(Control& control) : ControlPart(control) {}

  /// Carries out M70 to M73 (`m`) in the subprogram at `level`. False: an error was reported.
  bool run(int m, std::size_t level, const Word& word);
  /// The subprogram at `level` returns.
  void leave(std::size_t level);

 private:
  struct Saved {
    Modal modal;
    std::string work;
    bool automatic = false;  ///< M73
  };
  bool restore(const Saved& saved, const Word* word);

  std::map<std::size_t, Saved> saved_;  ///< by level
};

}  // namespace mrsim
