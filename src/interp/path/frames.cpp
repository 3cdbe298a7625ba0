#include "interp/path/frames.h"

#include "core/numbers/rounding.h"
#include "core/numbers/trig.h"

#include <cmath>

namespace mrsim {

Vec3 turn(const Frame& f, const Vec3& v) {
  if (f.plain) return v;
  return v.x * f.axis[0] + v.y * f.axis[1] + v.z * f.axis[2];
}

Vec3 apply(const Frame& f, const Vec3& p) { return turn(f, p) + f.shift; }

double determinant(const Frame& f) { return dot(f.axis[0], cross(f.axis[1], f.axis[2])); }

Vec3 turn_inverse(const Frame& f, const Vec3& v) {
  if (f.plain) return v;
  const double d = determinant(f);
  return {dot(v, cross(f.axis[1], f.axis[2])) / d, dot(v, cross(f.axis[2], f.axis[0])) / d,
          dot(v, cross(f.axis[0], f.axis[1])) / d};
}

Vec3 apply_inverse(const Frame& f, const Vec3& p) { return turn_inverse(f, p - f.shift); }

Frame inverse(const Frame& f) {
  Frame out;
  out.shift = apply_inverse(f, {});
  out.plain = f.plain;
  for (int i = 0; i < 3; ++i) {
    Vec3 unit;
    component(unit, i) = 1;
    out.axis[static_cast<std::size_t>(i)] = turn_inverse(f, unit);
  }
  return out;
}

Frame compose(const Frame& outer, const Frame& inner) {
  Frame f;
  f.shift = apply(outer, inner.shift);
  f.plain = outer.plain && inner.plain;
  if (!f.plain)
    for (std::size_t i = 0; i < 3; ++i) f.axis[i] = turn(outer, inner.axis[i]);
  return f;
}

Frame shift_frame(const Vec3& shift) {
  Frame f;
  f.shift = shift;
  return f;
}

Frame rotation_frame(int axis, double degrees) {
  const SinCos sc = sincos_deg(degrees);
  const int a = (axis + 1) % 3, b = (axis + 2) % 3;
  Frame f;
  f.plain = false;
  Vec3 first, second;
  component(first, a) = sc.cos;
  component(first, b) = sc.sin;
  component(second, a) = -sc.sin;
  component(second, b) = sc.cos;
  f.axis[static_cast<std::size_t>(a)] = first;
  f.axis[static_cast<std::size_t>(b)] = second;
  return f;
}

Frame scale_frame(const Vec3& factors) {
  Frame f;
  f.plain = false;
  f.axis = {Vec3{factors.x, 0, 0}, Vec3{0, factors.y, 0}, Vec3{0, 0, factors.z}};
  return f;
}

Frame about(const Frame& frame, const Vec3& center) {
  Frame f = frame;
  f.shift = frame.shift + center - turn(frame, center);
  return f;
}

double plane_scale(const Frame& frame, const Vec3& u, const Vec3& v) {
  if (frame.plain) return 1;
  const Vec3 a = turn(frame, u), b = turn(frame, v);
  const double factor = length(a);
  const bool round = std::abs(factor - length(b)) <= kTurnRounding * factor &&
                     std::abs(dot(a, b)) <= kTurnRounding * factor * factor;
  return round ? factor : 0;
}

Basis plane_basis(int plane) {
  if (plane == kPlaneZX) return {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}};
  if (plane == kPlaneYZ) return {{0, 1, 0}, {0, 0, 1}, {1, 0, 0}};
  return {};
}

Basis normal_basis(const Vec3& normal) {
  // The first axis is the coordinate axis that is farthest from the normal, made square to it.
  const double ax = std::abs(normal.x), ay = std::abs(normal.y), az = std::abs(normal.z);
  Vec3 helper{1, 0, 0};
  if (ay < ax && ay <= az) helper = {0, 1, 0};
  if (az < ax && az < ay) helper = {0, 0, 1};
  Basis b;
  b.w = normal;
  b.u = normalized(helper - dot(helper, normal) * normal);
  b.v = cross(b.w, b.u);
  return b;
}

}  // namespace mrsim
