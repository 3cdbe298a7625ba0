// Regions of a plane bounded by segments and arcs, united exactly: CGAL's general polygons with
// rational circles. The oracle for what tools sweep in a plane, with no code of mrsim in it.
//
// Coordinates and radii are taken as the doubles they are. Directions (of a bar, of an arc's ends)
// become rational unit vectors within 1e-15 of what was asked, so that every piece is a valid
// polygon; unions and intersections are then free of rounding. Areas are summed in double over the
// exact boundary: good to 1e-12 of the region's box.
#pragma once

#include "core/numbers/vec.h"

#include <memory>
#include <span>

namespace mrsim::testing {

class ExactRegion {
 public:
  ExactRegion();
  ExactRegion(ExactRegion&&) noexcept;
  ExactRegion& operator=(ExactRegion&&) noexcept;
  ~ExactRegion();

  void add_disc(Vec2 center, double radius);
  /// All within `radius` of the segment.
  void add_bar(Vec2 a, Vec2 b, double radius);
  /// All within `width` of the arc about `center`; angles in radians, sweep signed.
  void add_arc(Vec2 center, double radius, double begin, double sweep, double width);
  /// A convex polygon, either way round.
  void add_polygon(std::span<const Vec2> corners);
  /// All segments a + c, b + c with c on the arc of `radius` about the origin.
  void add_drawn_segment(Vec2 a, Vec2 b, double radius, double begin, double sweep);
  /// The mirror image, x against -x, of all that was added so far.
  void add_mirrored();

  /// The part of it within a box.
  struct Measure {
    double area = 0;     ///< mm^2
    double moment = 0;   ///< integral of x over it, mm^3
    double outline = 0;  ///< length of its boundary, mm
    double turns = 0;    ///< angles of all its arcs, rad
    int pieces = 0;      ///< of its boundary
  };
  Measure within(Vec2 lo, Vec2 hi) const;
  /// Some of it has x < 0.
  bool crosses_axis() const;
  /// p lies inside, not on the boundary.
  bool contains(Vec2 p) const;

 private:
  struct Pieces;
  std::unique_ptr<Pieces> pieces_;
};

}  // namespace mrsim::testing
