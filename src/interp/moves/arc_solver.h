// Circular blocks: which form a block uses, and what each control does with bad data. Makes the
// words of the block an arc in the frame in force, and changes no state. Private to src/interp.
#pragma once

#include "interp/moves/arc_turns.h"
#include "interp/moves/center_hints.h"
#include "interp/moves/point_arcs.h"

namespace mrsim {

class ArcSolver : public ControlPart {
 public:
  ArcSolver(Control& control, AxisWords& axes)
      : ControlPart(control), axes_(axes), points_(control), hints_(control), turns_(control) {}

  /// The arc that begins at `from`. False: an error was reported.
  bool solve(const Vec3& from, const Frame& frame, SolvedArc& out);

 private:
  bool solve_form(ArcBlock& arc, SolvedArc& out);
  bool straight(const char* code, const std::string& text, const ArcBlock& arc, SolvedArc& out);
  bool center_words(const ArcBlock& arc, Vec2& center, bool& given);
  bool center_complete(const ArcBlock& arc);
  const Word* okuma_radius();
  bool radius_arc(ArcBlock& arc, const Word& word, SolvedArc& out);
  bool same_point_radius(ArcBlock& arc, const Word& word, double radius, SolvedArc& out);
  bool near_half_circle(const PlaneArc& arc, const Word& word);
  bool center_arc(ArcBlock& arc, Vec2 center, SolvedArc& out);
  void keep_center(ArcBlock& arc, Vec2 center, SolvedArc& out);
  bool check_center(ArcBlock& arc, Vec2 c, SolvedArc& out);
  bool angle_arc(ArcBlock& arc, const Word& word, bool centered, Vec2 center, SolvedArc& out);
  bool turned_arc(ArcBlock& arc, Vec2 center, double angle, SolvedArc& out);
  bool codesys_angle_arc(ArcBlock& arc, const Word& t, bool centered, Vec2 center, SolvedArc& out);
  std::optional<PlaneArc> arc_of_radius(const ArcBlock& arc, double radius, const Word& word);

  AxisWords& axes_;
  PointArcs points_;
  CenterHints hints_;
  ArcTurns turns_;
};

}  // namespace mrsim
