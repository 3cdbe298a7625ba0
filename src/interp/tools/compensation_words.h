// Radius compensation as the program switches it: start, end, radius in force. The offset itself is
// made by CompensationStage. Private to src/interp.
#pragma once

#include "interp/path/corners.h"
#include "interp/tools/tool_changer.h"

namespace mrsim {

class CompensationWords : public ControlPart {
 public:
  CompensationWords(Control& control, ToolChanger& tools) : ControlPart(control), tools_(tools) {}

  /// G40 G41 G42 and what says how the path is moved. False: another word.
  bool select(Code code, const Word& word);
  /// LinuxCNC and Mach: what must not change while the path is moved. False: an error was reported.
  bool allows_block();
  /// Before a move is given on: G40 G41 G42 take effect with a straight move in the plane.
  /// False: an error was reported.
  bool begin_move(const Motion& motion, const Word& where);
  /// After the block. SINUMERIK: G41 and G42 count only in a block that moves in the plane.
  void end_block(bool move_waits);
  /// What CompensationStage needs to know about the next move.
  Compensation for_move() const;
  bool started() const { return started_; }
  /// At the end of the program: whether a radius was asked for, and depended on --comp.
  bool was_on() const { return was_on_; }
  bool asked_option() const { return asked_option_; }
  /// For a cycle that moves its contour aside by itself: radius and point of the tool in force.
  Compensation of_tool();
  /// The tool's radius by the register in force, mm.
  double register_radius(const Word& where) {
    tools_.require(where, true);
    set_radius(where);
    return radius_;
  }

 private:
  void set_radius(const Word& where);
  bool work_selected() const;
  std::string edge_name() const;
  const Tool* tool_of_edge() const;
  static Vec2 tip_vector(const Tool& tool, double radius);

  ToolChanger& tools_;
  bool started_ = false;
  bool was_on_ = false, asked_option_ = false;
  double radius_ = 0;
  Vec2 tip_;
  std::string key_;  ///< register and tool that `radius_` was made of
  int changes_ = 0;  ///< Control::register_changes when radius_ was found
  int tool_ = -2;
};

}  // namespace mrsim
