// What stands where in the records of closed forms (LineRecord, ArcRecord, ProfileRow), which the
// loops of removal/simd read as plain columns of numbers.
#pragma once

namespace mrsim {

/// A ball on any straight line: centre of the ball at the start, unit direction in plan, length in
/// plan, rise for each mm of it, radius. Segments of a path's heights are alike: lower end of the
/// tip's path, slope >= 0, and how far the segment strays in place of the radius.
struct BallSlot {
  enum : int { x, y, z, ux, uy, length, slope, radius, error = radius };
};

/// A horizontal line: start and the way to its end in plan; then the tool's section at its height:
/// a disc of radius `core` at `low`, thickened by `round`, cut off at `top`.
struct LineSlot {
  enum : int { x, y, dx, dy, low, core, round, top };
};

/// A horizontal arc: centre and radius, unit vector to its middle, cosine and sine of half its
/// sweep; then the section as above, and the arc's length.
struct ArcSlot {
  enum : int { x, y, radius, mx, my, cosine, sine, low, core, round, top, length };
};

/// The wall of a bore: axis and radius of a helix, the tool's section, height of `low` at the first
/// and at the last position; 1 for a whole turn, 0 for less.
struct BoreSlot {
  enum : int { x, y, radius, core, round, first_low, last_low, whole };
};

/// Columns of candidate lists, floats about the list's origin. `inverse`: of the square of the
/// way's length (of a strip: for each mm in plan); `z`: of the tip; `height_number`: equal for
/// equal heights.
struct StripColumn {
  enum : int { x, y, z, ux, uy, length, slope, inverse };
};
struct LineColumn {
  enum : int { x, y, dx, dy, inverse, z, height_number };
};
struct ArcColumn {
  enum : int { x, y, radius, mx, my, cosine, sine, z, height_number };
};

}  // namespace mrsim
