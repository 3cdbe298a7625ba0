// Small vector arithmetic on mrsim::Vec3 and Vec2, double. Everything here is + - * / sqrt, so that
// results are the same to the last bit on every IEEE-754 machine (ARCHITECTURE.md, Same bytes).
#pragma once

#include <mrsim/types.h>

#include <cmath>

namespace mrsim {

struct Vec2 {
  double x = 0, y = 0;
  friend bool operator==(const Vec2&, const Vec2&) = default;
};

inline Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
inline Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
inline Vec2 operator*(double s, Vec2 a) { return {s * a.x, s * a.y}; }
inline double dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
inline double cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }
inline double length(Vec2 a) { return std::sqrt(dot(a, a)); }

inline Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec3 operator-(const Vec3& a) { return {-a.x, -a.y, -a.z}; }
inline Vec3 operator*(double s, const Vec3& a) { return {s * a.x, s * a.y, s * a.z}; }
inline Vec3& operator+=(Vec3& a, const Vec3& b) { return a = a + b; }
inline double dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(const Vec3& a) { return std::sqrt(dot(a, a)); }
inline double distance(const Vec3& a, const Vec3& b) { return length(a - b); }
/// Unit vector of a; a itself when its length is 0.
inline Vec3 normalized(const Vec3& a) {
  const double n = length(a);
  return n > 0 ? (1 / n) * a : a;
}
inline Vec3 lerp(const Vec3& a, const Vec3& b, double t) { return a + t * (b - a); }
inline double& component(Vec3& a, int i) { return i == 0 ? a.x : i == 1 ? a.y : a.z; }
inline double component(const Vec3& a, int i) { return i == 0 ? a.x : i == 1 ? a.y : a.z; }
inline Vec3 min(const Vec3& a, const Vec3& b) {
  return {a.x < b.x ? a.x : b.x, a.y < b.y ? a.y : b.y, a.z < b.z ? a.z : b.z};
}
inline Vec3 max(const Vec3& a, const Vec3& b) {
  return {a.x > b.x ? a.x : b.x, a.y > b.y ? a.y : b.y, a.z > b.z ? a.z : b.z};
}

inline bool is_empty(const Box3& b) {
  return b.lo.x > b.hi.x || b.lo.y > b.hi.y || b.lo.z > b.hi.z;
}
inline void extend(Box3& b, const Vec3& p) {
  b.lo = min(b.lo, p);
  b.hi = max(b.hi, p);
}
inline void extend(Box3& b, const Box3& o) {
  b.lo = min(b.lo, o.lo);
  b.hi = max(b.hi, o.hi);
}
inline Box3 inflated(const Box3& b, double by) {
  return {b.lo - Vec3{by, by, by}, b.hi + Vec3{by, by, by}};
}

}  // namespace mrsim
