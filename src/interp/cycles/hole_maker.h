// The motions of one hole: rapids to it, strokes into it, the way out. Knows no words; cycles of
// all controls come to this. Each motion names the cycle's line, called from the point's. Private
// to src/interp.
#pragma once

#include "interp/calls/block_reader.h"
#include "interp/moves/moves.h"

#include <vector>

namespace mrsim {

/// How far above the last depth a rapid back into the hole ends, and how far a chip is broken: mm.
inline constexpr double kPeckClearance = 0.254;
/// Strokes in one hole; more is a fault of the program.
inline constexpr std::size_t kMostStrokes = 100'000;

/// Levels are along the normal of the plane, in the frame in force.
struct Hole {
  double safe = 0;  ///< where feeding begins
  double bottom = 0;
  double end = 0;               ///< level after the hole
  std::vector<double> strokes;  ///< levels of the strokes before the last
  bool chips_out = true;        ///< a stroke ends at `safe`; else its chip is broken
  double out_every = 0;         ///< or at `safe` after so much depth, mm; 0: never
  double clearance = kPeckClearance;
  bool feed_out = false;           ///< back to `safe` with the feed
  bool feed_to_end = false;        ///< ... and on to `end`
  double dwell = 0;                ///< at the bottom, s
  double dwell_stroke = 0;         ///< at the end of a stroke before the last, s
  double dwell_safe = 0;           ///< where the chips of a stroke come out, s
  double dwell_out = 0;            ///< at the end of the way back with the feed, s
  double lead = 0;                 ///< of a tap, mm per revolution
  double feed = 0, feed_back = 0;  ///< 0 = that of the program
  Vec3 lift;                       ///< before the way out, the edge leaves the wall
};

class HoleMaker : public ControlPart {
 public:
  HoleMaker(Control& control, BlockReader& reader, Moves& moves)
      : ControlPart(control), reader_(reader), moves_(moves) {}

  /// Rapid in the plane to `point`, at the level of now.
  void approach(const Vec3& point, unsigned named, const Word& where);
  /// Rapid along the normal.
  void move_to(double level, const Word& where);
  /// The hole at the position of now.
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
