// Reads the stock that a program states: by WORKPIECE(...) of SINUMERIK, or by comments of CAM
// programs. Private to src/interp.
#pragma once

#include "interp/comments/stock_comment.h"
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

class CommentedStock : public ControlPart {
 public:
  explicit CommentedStock(Control& control) : ControlPart(control) {}
  void read_comments();
  /// Called behind the first cut, whose zero and unit hold for the comments: sets
  /// Program::workpiece.
  void settle();
  /// Called at the end of the program. Warns where its lengths are probably inches:
  /// `tools_in_inches` says that tools of sizes in inches have cut, `farthest` how far from the
  /// zero (mm), `slowest` the lowest speed on a lathe (rev/min).
  void compare_units(bool tools_in_inches, double farthest, double slowest);
  bool is_settled() const { return settled_; }

 private:
  bool may_mean_inches() const;
  void compare_typed_tools();

  StockComments comments_;
  bool settled_ = false, says_inches_ = false;
};

}  // namespace mrsim
