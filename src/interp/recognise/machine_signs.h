// Signs of a mill or a lathe in a program's text. A comment alone decides nothing: it only supports
// a sign in the program's words.
#pragma once

#include "interp/recognise/recognise.h"
#include "interp/text/line_scan.h"

namespace mrsim {

class MachineSigns {
 public:
  /// Looks at line number n.
  void line(const LineScan& s, int n);
  /// Whether a sign was seen that is enough alone.
  bool settled() const { return !mill_.empty() || !lathe_.empty(); }
  /// Whether it is known to be a mill, so that Y and J need not be looked for.
  bool knows_mill() const { return !mill_.empty(); }
  /// Sets machine and reason for the dialect of `out`.
  void judge(const InterpOptions& options, Recognition& out) const;

 private:
  void fanuc_line(const std::string& code, int n);
  void weak_signs(const std::string& code, int n);
  std::string turret() const;
  std::string weak_lathe(bool fanuc, const std::string& turret_sign, bool table) const;
  std::string weak_mill(bool tool_in_table, bool commented) const;
  bool is_transformed(const std::string& code);

  // The line of the first such sign, as text; empty: there is none.
  std::string mill_, lathe_;
  std::string level_;                        ///< Y0, which lathes with an axis Y also write
  std::string ngc_lathe_;                    ///< G7, G8: diameters of LinuxCNC
  std::string fanuc_lathe_;                  ///< words of FANUC's lathes: G71 with P and Q
  std::string fanuc_turning_;                ///< FANUC's words, if nothing moves in Y
  std::string turning_;                      ///< G18, if nothing moves in Y
  std::string turret_;                       ///< T0101, if nothing is changed by M6
  std::string short_turret_;                 ///< T101, beside a comment about a turning tool
  std::string rotary_;                       ///< an axis C
  std::string per_revolution_;               ///< G95; supports a comment about a turning tool
  std::string milling_cycle_;                ///< POCKET3 and its kin, beside no turning word
  std::string change_, length_, plane_;      ///< M6, G43, G17: two of them make a mill
  std::string turning_tool_, milling_tool_;  ///< comments
  bool mills_ = false;                       ///< a milling tool that is no drill and no tap
  bool turns_ = false;                       ///< G97, which few mills need
  bool transformed_ = false;                 ///< behind TRANSMIT, G12.1 and their kin
};

}  // namespace mrsim
