// An area between contours, as cutters clear it: inside of one contour and outside of islands, both
// of lines and arcs. Guarantees: the loops of inset() keep their distance from every contour to
// within 0.1 um and are exact lines and arcs; where the pieces do not close to loops, inset() says
// so. Does not check whether a contour crosses itself. Cost: the square of the number of pieces.
#pragma once

#include "interp/path/clearing.h"

#include <optional>
#include <vector>

namespace mrsim {

/// The signed area of a closed loop, counter-clockwise positive, mm^2.
double signed_area(const Loop& loop);

/// The same loop, begun at its place nearest to `p`.
Loop begun_near(const Loop& loop, Vec2 p);

struct PieceBounds {
  Vec2 low, high;
};

class Region {
 public:
  /// Closed contours in either direction. Without an outer one the area has no end.
  Region(const std::optional<Loop>& outer, const std::vector<Loop>& islands);

  /// The border of all places that keep `distance` from the contours; these places lie to its left.
  /// False: its pieces could not be joined.
  bool inset(double distance, std::vector<Loop>& out) const;
  /// Whether the straight way between two places of an inset also keeps `distance`.
  bool keeps(Vec2 from, Vec2 to, double distance) const;
  std::size_t pieces() const;

 private:
  bool contains(Vec2 p, const std::vector<std::vector<Vec2>>& polygons) const;
  double distance_from_contours(Vec2 p, double enough) const;

  std::vector<Loop> contours_;       ///< with the area to their left; an outer one comes first
  std::vector<PieceBounds> bounds_;  ///< of the contours' pieces
  bool has_outer_ = false;
};

/// The loops by which a cutter of `radius` clears the region to within `aside` of its contours, the
/// inner ones first, each followed by the one around it. Their distance from one another is at most
/// `step` and the radius, so that nothing stays between them. False: see Region::inset().
bool clearing_loops(const Region& region, double radius, double aside, double step,
                    std::vector<Loop>& out);

}  // namespace mrsim
