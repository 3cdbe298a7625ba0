// What states the stock: WORKPIECE(...) of SINUMERIK, and comments of CAM programs. Private to
// src/interp.
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
  /// Behind the first cut, whose zero and unit count: sets Program::workpiece.
  void settle();
  /// The program ends: `tools_in_inches` have cut no farther than `farthest` mm from the zero, on a
  /// lathe at `slowest` rev/min and more.
  void compare_units(bool tools_in_inches, double farthest, double slowest);
  bool is_settled() const { return settled_; }

 private:
  bool may_mean_inches() const;
  void compare_typed_tools();

  StockComments comments_;
  bool settled_ = false, says_inches_ = false;
};

}  // namespace mrsim
