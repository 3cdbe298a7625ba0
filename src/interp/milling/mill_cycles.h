// SINUMERIK's milling cycles: pockets, slots, long holes, spigots, faces, milled threads. Their
// final shape is that of the manual. docs/interp.md describes the loops by which the cutter gets
// there. Private to src/interp.
#pragma once

#include "interp/milling/mill_values.h"

#include <functional>
#include <string_view>
#include <vector>

namespace mrsim {

class MillCycles : public MillValues {
 public:
  MillCycles(Control& control, ToolChanger& tools, Moves& moves)
      : MillValues(control, tools, moves), cutter_(control, mover_) {}

  /// Whether run() knows the name.
  static bool knows(std::string_view name);
  /// Carries out the cycle. `at_position`: MCALL runs it at the place of the tool. False: an error
  /// was reported.
  bool run(const CycleCall& call, const Word& where, bool at_position);

 private:
  bool rectangle();
  bool circle();
  bool slots();
  bool arc_slots();
  bool spigot();
  bool face();
  bool open_slot();
  bool thread();
  bool clear(const MillPlan& plan, const MillArea& area);
  /// Loops from the middle to the distance `last` from it, turned and moved to the pocket. `make`
  /// gives the loop at a distance.
  static std::vector<Loop> nested(const MillPlan& plan, double last, Vec2 at, double degrees,
                                  const std::function<Loop(double)>& make);
  int count(double& first, double& step, double whole);
  bool has_corner(double side);
  void tell_overlap(int count, double width, const std::function<double(int)>& between);

  AreaCutter cutter_;
};

}  // namespace mrsim
