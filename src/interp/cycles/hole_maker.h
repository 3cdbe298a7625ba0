// The motions of one hole: rapids to it, strokes into it, the way out, for the cycles of all
// controls. It does not know words. Each motion names the line of the cycle, as called from the
// line of the point. Private to src/interp.
#pragma once

#include "interp/calls/block_reader.h"
#include "interp/moves/moves.h"

#include <vector>

namespace mrsim {

/// mm: a rapid back into the hole ends so far above the last depth; to break a chip the tool goes
/// back so far.
inline constexpr double kPeckClearance = 0.254;
/// The most strokes in one hole; more of them are a fault of the program.
inline constexpr std::size_t kMostStrokes = 100'000;

/// One hole. Levels are heights along the normal of the plane, in the frame in force, mm.
struct Hole {
  double safe = 0;  ///< where feeding begins
  double bottom = 0;
  double end = 0;               ///< level to which the tool goes after the hole
  std::vector<double> strokes;  ///< levels of the strokes before the last
  bool chips_out = true;        ///< after a stroke the tool goes to `safe`, else it breaks the chip
  double out_every = 0;         ///< it also goes to `safe` after so much depth, mm; 0: never
  double clearance = kPeckClearance;
  bool feed_out = false;           ///< the tool goes back to `safe` with the feed
  bool feed_to_end = false;        ///< ... and on to `end` as well
  double dwell = 0;                ///< dwell at the bottom, s
  double dwell_stroke = 0;         ///< dwell at the end of other strokes than the last, s
  double dwell_safe = 0;           ///< dwell at `safe` after a stroke, s
  double dwell_out = 0;            ///< dwell at the end of the way back with the feed, s
  double lead = 0;                 ///< of a tap, mm per revolution
  double feed = 0, feed_back = 0;  ///< 0: the feed in force
  Vec3 lift;                       ///< a move before the way out, by which the edge leaves the wall
};

class HoleMaker : public ControlPart {
 public:
  HoleMaker(Control& control, BlockReader& reader, Moves& moves)
      : ControlPart(control), reader_(reader), moves_(moves) {}

  /// A rapid in the plane to `point`, at the current level.
  void approach(const Vec3& point, AxisSet named, const Word& where);
  /// A rapid along the normal to a level.
  void move_to(double level, const Word& where);
  /// Drills the hole at the current position.
  void drill(const Hole& hole, const BlockPlace& place, const Word& where);
  double level() const;

 private:
  double strokes(const Hole& hole, double down);
  void to_level(double level, MotionKind kind, double lead, double feed);

  BlockReader& reader_;
  Moves& moves_;
  const Word* where_ = nullptr;
};

}  // namespace mrsim
