// SINUMERIK's milling cycles: pockets, slots, long holes, spigots, faces, milled threads. Their
// final shape is that of the manual; the way to it is one of loops, described in docs/interp.md.
// Private to src/interp.
#pragma once

#include "interp/cycles/chamfering.h"
#include "interp/cycles/cycle_call.h"
#include "interp/cycles/cycle_mover.h"

#include <functional>
#include <string_view>

namespace mrsim {

class MillCycles : public ControlPart {
 public:
  MillCycles(Control& control, ToolChanger& tools, Moves& moves)
      : ControlPart(control), tools_(tools), mover_(control, moves), chamfering_(control, tools) {}

  static bool knows(std::string_view name);
  /// `at_position`: by MCALL, at the place of the tool. False: an error was reported.
  bool run(const CycleCall& call, const Word& where, bool at_position);

 private:
  /// What cuts are made, and where they end.
  struct Levels {
    double top = 0, reference = 0, safe = 0, bottom = 0;  ///< along the normal, mm
    double infeed = 0, finish_infeed = 0;                 ///< the most of one cut; 0 = all
    double side = 0, floor = 0;                           ///< allowances for finishing
    double feed = 0, plunge = 0;
    double width = 0;  ///< between two loops
    bool rough = true, finish = true;
    int entry = 1;                     ///< 0 rapid, 1 feed, 2 helix, 3 swinging
    double helix = 0, helix_lead = 0;  ///< radius and lead; of swinging the angle
    bool clockwise = false;
  };
  /// An area by its loops: all of them, the last one at the wall, `aside` from it.
  struct Area {
    std::function<std::vector<Loop>(double aside)> loops;
    Vec2 entry;        ///< where the tool goes down
    double swing = 0;  ///< half the way that swinging has, along `degrees`
    double degrees = 0;
    double helix = 0;  ///< the largest radius of a helix at the entry
  };

  double value(ValueName name) const { return call_->get(name); }
  bool fail(const char* code, const std::string& text) { return error(code, text, where_); }
  bool levels(Levels& out);
  bool depth(Levels& out);
  bool modes(Levels& out);
  bool chamfer(Levels& out);
  bool reference_point(Vec2& out);
  bool center(double length, double width, double degrees, Vec2& out);
  bool rectangle();
  bool circle();
  bool slots();
  bool arc_slots();
  bool spigot();
  bool face();
  bool open_slot();
  bool thread();
  bool clear(const Levels& l, const Area& area);
  void cut(const Levels& l, const Area& area, const std::vector<Loop>& loops, double infeed,
           double bottom);
  void descend(const Levels& l, const Area& area, double from, double to);
  void swing_down(const Levels& l, const Area& area, double from, double to);
  bool tracks(const Levels& l, const std::vector<std::pair<Vec2, Vec2>>& lines, bool one_way);
  /// Loops from the middle to `last` from it, turned and moved to the pocket; `make` gives the one
  /// at a distance.
  static std::vector<Loop> nested(const Levels& l, double last, Vec2 at, double degrees,
                                  const std::function<Loop(double)>& make);
  int count(double& first, double& step, double whole);

  ToolChanger& tools_;
  CycleMover mover_;
  Chamfering chamfering_;
  const CycleCall* call_ = nullptr;
  Word where_;
  bool at_position_ = false;
  double radius_ = 0;  ///< of the cutter, mm
};

}  // namespace mrsim
