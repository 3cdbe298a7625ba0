// SINUMERIK cycles along contours of the program: CYCLE62 names them, CYCLE72 mills along one,
// CYCLE63 clears a pocket or the surroundings of a spigot, CYCLE95 and CYCLE952 turn down to one.
// The contours' blocks are read like any others with their motions kept; then the passes follow
// from them. Private to src/interp.
#pragma once

#include "interp/cycles/chamfering.h"
#include "interp/cycles/cycle_call.h"
#include "interp/cycles/cycle_mover.h"
#include "interp/milling/region_cutter.h"
#include "interp/path/rough_contour.h"
#include "interp/statements/statements.h"

#include <optional>
#include <vector>

namespace mrsim {

class SinumerikContours : public ControlPart {
 public:
  SinumerikContours(Control& control, BlockReader& reader, Statements* statements,
                    ToolChanger& tools, Moves& moves, MotionEmitter& out)
      : ControlPart(control),
        reader_(reader),
        statements_(statements),
        tools_(tools),
        moves_(moves),
        mover_(control, moves),
        cutter_(control, moves),
        chamfering_(control, tools),
        out_(out) {}

  static bool knows(std::string_view name);
  /// False: an error was reported.
  bool run(const CycleCall& call, const Word& where);
  /// The blocks now read are the contour of a cycle.
  bool reads_contour() const { return out_.captures(); }
  /// Goes on with the contour, after the block is done.
  void end_block();
  /// The program ends.
  void end_program();

 private:
  /// CYCLE72 along the contour: where it is, in the plane and along its normal.
  struct Along {
    double top = 0, reference = 0, safe = 0, bottom = 0, infeed = 0;
    double side = 0;  ///< 1 the cutter is to the left, -1 right, 0 on the contour
    double aside = 0, allowance = 0;
    double feed = 0, plunge = 0;
  };
  /// CYCLE95 and CYCLE952: levels in u, cuts in v.
  struct Removal {
    int u = 0, v = 2;
    double down = -1, run = -1;
    double clear = 1;             ///< mm
    double top = 0, start = 0;    ///< the first level's u less a pass; v where passes begin
    std::optional<double> blank;  ///< u of its surface, where the cycle is told
    Vec3 allowance;
    double parallel = 0;                         ///< allowance along the contour's normal
    double depth = 0;                            ///< of a pass, mm
    double feed = 0, plunge = 0, last_feed = 0;  ///< roughing, into a relief cut, finishing
    bool rough = true, finish = true, reliefs = true;
  };

  bool name_contour();
  bool find_contours();
  bool find_contour(const std::string& name, CallRequest& request);
  void enter_contour();
  void begin_contour();
  void end_contour();
  void finish_contours();
  bool pocket();
  bool pocket_levels(RegionCutter::Levels& out);
  bool surroundings(double radius, const Loop& blank, Loop& out);
  bool mill_along();
  bool mill_levels(Along& out);
  void pass_along(const Along& along, double from, double level);
  void approach(const Along& along, double level, double from, bool leaving);
  bool turn_down();
  bool turn_modes(Removal& out);
  bool removal_modes(Removal& out);
  bool removal_values();
  bool removal_ways(Removal& out);
  void removal_allowances(Removal& out);
  void removal_blank(Removal& out);
  void turn_contour();
  void orient(const Removal& r);
  bool beside(const Removal& r, double allowance);
  double before_contour(const Removal& r) const;
  bool roughing(Removal& r);
  bool levels(const Removal& r, const RoughContour& shape, double whole, int n);
  void level(const Removal& r, double at, double from, double to);
  void follow_contour(const Vec3& shift);
  void go(const Vec3& physical, MotionKind kind, double feed);

  BlockReader& reader_;
  Statements* statements_;
  ToolChanger& tools_;
  Moves& moves_;
  CycleMover mover_;
  RegionCutter cutter_;
  Chamfering chamfering_;
  MotionEmitter& out_;
  CycleCall call_;
  Word where_;
  std::vector<std::string> named_;  ///< by the last calls of CYCLE62
  bool named_used_ = false;         ///< a cycle has run with them: the next CYCLE62 begins anew
  std::vector<CallRequest> requests_;
  bool waits_ = false;  ///< the contours of call_ come next
  std::vector<Motion> contour_;
  std::vector<std::vector<Motion>> contours_;  ///< those read so far
  std::vector<Motion> path_;                   ///< of the tool's point along contour_, in turning
  Modal modal_before_;
  Position position_before_;
  std::size_t errors_before_ = 0;
};

}  // namespace mrsim
