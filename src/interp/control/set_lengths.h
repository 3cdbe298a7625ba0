// Lengths of tools that a program sets: G10 L10 and L11, #10001 and #11001, $TC_DP3, G43.1.
// Positions of a program are those of the tip, so a length has no effect here. But if the program
// changes it between two cuts of one tool, the second cut is deeper. Private to src/interp.
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
  /// Whose length it is: the tool (0 where numbers of lengths belong to no tool), and H or D.
  using Register = std::pair<double, double>;
  static constexpr double kTable = -1;    ///< instead of a tool: LinuxCNC's table, read by G43
  static constexpr double kDynamic = -1;  ///< instead of H: G43.1, G43.2
  struct Setting {
    double mm = 0;
    bool relative = false;  ///< `mm` counts from a length that is not known
    std::string name;       ///< "H1 (G10 L11)"
    Motion at;              ///< only its place counts
    char axis = 'Z';        ///< along which the length lies
  };

  /// The program sets a length. `kind`: which one of the register. `before`: what it was until the
  /// first setting, mm, if known.
  void set(const Register& which, int kind, std::optional<double> before, Setting setting);
  /// The program sets a length to an unknown value, which differs from the one before.
  void set_another(const Register& which, int kind, Setting setting);
  /// What the program has set last; null if nothing.
  const Setting* find(const Register& which, int kind) const;
  /// Whether cut() has to be called. False: the cut before had this tool and number, and no length
  /// was set since.
  bool unmet(int tool, double number) const {
    return fresh_ || tool != last_.first || number != last_.second;
  }
  /// The tool `id` cuts. Gives the lengths that differ from those of an earlier cut of this tool:
  /// with the same register, or with another one if the program has set both.
  std::vector<Setting> cut(int tool, double number, const std::string& id, const Register& which);

 private:
  struct Length {
    std::optional<double> before;  ///< mm, until the first setting
    Setting now;
  };
  using Lengths = std::map<int, Length>;
  struct Cutter {
    std::map<Register, Lengths> cuts;  ///< at the last cut with each register
    Register last;
  };
  static std::vector<Setting> between(const Lengths& then, const Lengths& now);

  std::map<Register, Lengths> set_;
  std::map<std::string, Cutter> cutters_;
  std::pair<int, double> last_{-1, -1};
  bool fresh_ = true;
};

}  // namespace mrsim
