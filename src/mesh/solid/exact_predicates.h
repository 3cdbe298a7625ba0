// Signs of determinants of vertex coordinates, exact: coordinates are multiples of 2^-20 mm below
// 4096 mm in size, so that differences have 33 bits and a 3 x 3 determinant fits 128.
#pragma once

#include "core/numbers/vec.h"
#include "mesh/solid/vertex_lattice.h"

#include <cstdint>

namespace mrsim::detail {

struct ExactPoint {
  std::int64_t x = 0, y = 0, z = 0;
};

inline ExactPoint exact(const Vec3& p) {
  return {static_cast<std::int64_t>(p.x / kQuantum), static_cast<std::int64_t>(p.y / kQuantum),
          static_cast<std::int64_t>(p.z / kQuantum)};
}

__extension__ using Wide = __int128;

inline int sign(Wide x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

/// Sign of the volume of (b - a, c - a, d - a): positive where d lies on the side from which a, b,
/// c run counter-clockwise.
inline int orientation_exact(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const ExactPoint o = exact(a), p = exact(b), q = exact(c), r = exact(d);
  const std::int64_t ux = p.x - o.x, uy = p.y - o.y, uz = p.z - o.z;
  const std::int64_t vx = q.x - o.x, vy = q.y - o.y, vz = q.z - o.z;
  const std::int64_t wx = r.x - o.x, wy = r.y - o.y, wz = r.z - o.z;
  const Wide nx = Wide(uy) * vz - Wide(uz) * vy, ny = Wide(uz) * vx - Wide(ux) * vz,
             nz = Wide(ux) * vy - Wide(uy) * vx;
  return sign(nx * wx + ny * wy + nz * wz);
}

/// The side of a triangle on which points lie; for more than one of them.
class TriangleSide {
 public:
  TriangleSide(const Vec3& a, const Vec3& b, const Vec3& c) : a_(a), b_(b), c_(c) {
    const Vec3 u = b - a, v = c - a;  // differences of floats: exact or rounded once
    normal_ = cross(u, v);
    scale_ = 4e-15 * magnitude(u) * magnitude(v);
  }
  /// orientation_exact(a, b, c, d).
  int operator()(const Vec3& d) const {
    const Vec3 w = d - a_;
    const double det = dot(normal_, w), bound = scale_ * magnitude(w);
    if (det > bound) return 1;
    if (det < -bound) return -1;
    return orientation_exact(a_, b_, c_, d);
  }

 private:
  static double magnitude(const Vec3& e) {
    return (e.x < 0 ? -e.x : e.x) + (e.y < 0 ? -e.y : e.y) + (e.z < 0 ? -e.z : e.z);
  }
  const Vec3 &a_, &b_, &c_;
  Vec3 normal_;
  double scale_ = 0;
};

inline int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return TriangleSide(a, b, c)(d);
}

/// Sign of the area of (b - a, c - a) seen along the given axis.
inline int orientation2(const Vec3& a, const Vec3& b, const Vec3& c, int axis) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  const auto q = [](const Vec3& p, int i) {
    return static_cast<std::int64_t>(mrsim::component(p, i) / kQuantum);
  };
  const std::int64_t ax = q(a, u), ay = q(a, v);
  return sign(Wide(q(b, u) - ax) * (q(c, v) - ay) - Wide(q(b, v) - ay) * (q(c, u) - ax));
}

/// True for a triangle without area.
inline bool is_degenerate(const Vec3& a, const Vec3& b, const Vec3& c) {
  return orientation2(a, b, c, 0) == 0 && orientation2(a, b, c, 1) == 0 &&
         orientation2(a, b, c, 2) == 0;
}

}  // namespace mrsim::detail
