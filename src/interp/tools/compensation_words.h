// Radius compensation as the program switches it: start, end, radius in force. CompensationStage
// computes the offset path. Private to src/interp.
#pragma once

#include "interp/path/corners.h"
#include "interp/tools/tool_changer.h"

namespace mrsim {

class CompensationWords : public ControlPart {
 public:
  CompensationWords(Control& control, ToolChanger& tools) : ControlPart(control), tools_(tools) {}

  /// Takes G40 G41 G42 and the words that say how the path is offset. False: it is another word.
  bool select(Code code, const Word& word);
  /// LinuxCNC and Mach forbid some words while compensation is on. False: an error was reported.
  bool allows_block();
  /// Called before a move is emitted: G40 G41 G42 take effect with a straight move in the plane.
  /// False: an error was reported.
  bool begin_move(const Motion& motion, const Word& where);
  /// Called after the block. On SINUMERIK G41 and G42 count only in a block that moves in the
  /// plane.
  void end_block(bool move_waits);
  /// The compensation of the next move, for CompensationStage.
  Compensation for_move() const;
  bool started() const { return started_; }
  /// Whether the program has asked for a radius, so that --comp had an effect.
  bool was_on() const { return was_on_; }
  bool asked_option() const { return asked_option_; }
  /// Radius and point of the tool in force, for a cycle that offsets its contour by itself.
  Compensation of_tool();
  /// The tool's radius that the register in force gives, mm.
  double register_radius(const Word& where) {
    tools_.require(where, true);
    set_radius(where);
    return radius_;
  }

 private:
  void set_radius(const Word& where);
  void warn_of_register(const Word& where, const Tool* tool, double own);
  bool work_selected() const;
  std::string edge_name() const;
  const Tool* tool_of_edge() const;
  void use_told_tip(const Word& where);
  static Vec2 tip_vector(int tip, double radius);

  ToolChanger& tools_;
  bool started_ = false;
  bool was_on_ = false, asked_option_ = false;
  double radius_ = 0;
  Vec2 tip_;
  std::string key_;  ///< register and tool from which `radius_` was found
  int changes_ = 0;  ///< Control::register_changes when radius_ was found
  int tool_ = -2;
};

}  // namespace mrsim
