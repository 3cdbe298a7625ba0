// Lengths of tools that a program sets: G10 L10 and L11, #10001 and #11001, $TC_DP3. Positions of
// programs are those of the tip, so a length has no effect here, unless it changes between two cuts
// of its tool: that makes the second cut deeper. Private to src/interp.
#pragma once

#include <mrsim/types.h>

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace mrsim {

class SetLengths {
 public:
  /// Whose length: the tool, 0 where numbers of lengths are not tied to tools, and H or D.
  using Register = std::pair<double, double>;
  struct Setting {
    double mm = 0;
    bool relative = false;  ///< `mm` counts from a length that is not known
    std::string name;       ///< "H1 (G10 L11)"
    Motion at;              ///< only its place counts
  };

  /// `kind`: which of the lengths of the register. `before`: what it was until the first setting.
  void set(const Register& which, int kind, std::optional<double> before, Setting setting);
  /// What the program has set last, else null.
  const Setting* find(const Register& which, int kind) const;
  /// False: the cut before had this tool and number, and no length was set since.
  bool unmet(int tool, double number) const {
    return fresh_ || tool != last_.first || number != last_.second;
  }
  /// A cut. Gives what was set behind another cut of the same register to another value.
  std::vector<Setting> cut(int tool, double number, const Register& which);

 private:
  struct Length {
    std::optional<double> at_cut;  ///< mm, at the last cut, or before the first
    Setting now;
  };
  std::map<Register, std::map<int, Length>> set_;
  std::set<Register> cutters_;  ///< registers that were in force at a cut
  std::pair<int, double> last_{-1, -1};
  bool fresh_ = true;
};

}  // namespace mrsim
