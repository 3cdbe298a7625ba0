// Lengths of tools that a program sets: G10 L10 and L11, #10001 and #11001, $TC_DP3, G43.1.
// Positions of programs are those of the tip, so a length has no effect here, unless it changes
// between two cuts of its tool: that makes the second cut deeper. Private to src/interp.
#pragma once

#include <mrsim/types.h>

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace mrsim {

class SetLengths {
 public:
  /// Whose length: the tool, 0 where numbers of lengths are not tied to tools, and H or D.
  using Register = std::pair<double, double>;
  static constexpr double kTable = -1;    ///< in place of the tool: LinuxCNC's table, read by G43
  static constexpr double kDynamic = -1;  ///< in place of H: G43.1, G43.2
  struct Setting {
    double mm = 0;
    bool relative = false;  ///< `mm` counts from a length that is not known
    std::string name;       ///< "H1 (G10 L11)"
    Motion at;              ///< only its place counts
    char axis = 'Z';        ///< along which it lies
  };

  /// `kind`: which of the lengths of the register. `before`: what it was until the first setting.
  void set(const Register& which, int kind, std::optional<double> before, Setting setting);
  /// To a length that is not known, and another than before.
  void set_another(const Register& which, int kind, Setting setting);
  /// What the program has set last, else null.
  const Setting* find(const Register& which, int kind) const;
  /// False: the cut before had this tool and number, and no length was set since.
  bool unmet(int tool, double number) const {
    return fresh_ || tool != last_.first || number != last_.second;
  }
  /// A cut, by the tool `id`. Gives the lengths that are others than at a cut of this tool before,
  /// with the same register or, where the program has set both, with another one.
  std::vector<Setting> cut(int tool, double number, const std::string& id, const Register& which);

 private:
  struct Length {
    std::optional<double> before;  ///< mm, until the first setting
    Setting now;
  };
  using Lengths = std::map<int, Length>;
  struct Cutter {
    std::map<Register, Lengths> cuts;  ///< as the last cut of each register met them
    Register last;
  };
  static std::vector<Setting> between(const Lengths& then, const Lengths& now);

  std::map<Register, Lengths> set_;
  std::map<std::string, Cutter> cutters_;
  std::pair<int, double> last_{-1, -1};
  bool fresh_ = true;
};

}  // namespace mrsim
