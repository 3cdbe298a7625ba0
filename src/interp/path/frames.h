// Coordinate frames: p -> linear part * p + shift, from programmed coordinates to those of the
// stock.
#pragma once

#include "core/numbers/vec.h"

#include <array>

namespace mrsim {

struct Frame {
  /// Images of the unit vectors.
  std::array<Vec3, 3> axis{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  Vec3 shift;
  bool plain = true;  ///< the linear part is the identity: coordinates stay exact
  friend bool operator==(const Frame&, const Frame&) = default;
};

/// Image of a direction or displacement.
Vec3 turn(const Frame& frame, const Vec3& v);
/// Image of a place.
Vec3 apply(const Frame& frame, const Vec3& p);
/// Requires: determinant(frame) != 0.
Vec3 apply_inverse(const Frame& frame, const Vec3& p);
Vec3 turn_inverse(const Frame& frame, const Vec3& v);
/// Requires: determinant(frame) != 0.
Frame inverse(const Frame& frame);
/// The determinant of the linear part: the factor on volumes, below 0 where the frame mirrors.
double determinant(const Frame& frame);

/// The factor by which the frame scales the plane of two unit vectors that are square to each
/// other; 0: unequally, so that circles become ellipses.
double plane_scale(const Frame& frame, const Vec3& u, const Vec3& v);

/// The frame that applies first `inner`, then `outer`.
Frame compose(const Frame& outer, const Frame& inner);

/// A frame that moves everything by a vector, mm.
Frame shift_frame(const Vec3& shift);
/// A rotation about coordinate axis 0, 1 or 2, degrees, counter-clockwise seen from its positive
/// end.
Frame rotation_frame(int axis, double degrees);
/// A frame that scales each axis by a factor.
Frame scale_frame(const Vec3& factors);
/// `frame` with `center` as its fixed point instead of the origin.
Frame about(const Frame& frame, const Vec3& center);

/// The axes of an arc's plane: u first, v second, w normal; u x v = w unless mirrored.
struct Basis {
  Vec3 u{1, 0, 0}, v{0, 1, 0}, w{0, 0, 1};
};

/// The planes of G17, G18 (Z first) and G19, and the one across a normal that the program gives.
inline constexpr int kPlaneXY = 0, kPlaneZX = 1, kPlaneYZ = 2, kPlaneOfNormal = 3;

/// The axes of a plane, not that of a normal.
Basis plane_basis(int plane);
/// A right-handed basis about a unit normal.
Basis normal_basis(const Vec3& normal);
inline Vec2 in_plane(const Basis& basis, const Vec3& p) {
  return {dot(p, basis.u), dot(p, basis.v)};
}
inline Vec3 from_plane(const Basis& basis, Vec2 p, double height) {
  return p.x * basis.u + p.y * basis.v + height * basis.w;
}

}  // namespace mrsim
