// Exact parts in closed form for the mesher's tests: a box or a round bar less slots and turned
// regions, as ExactField, without a program, a tool or a grid.
#pragma once

#include "core/numbers/vec.h"
#include "removal/field/field.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace mrsim::testing {

/// One smooth face's distance, out of the material, and its gradient.
struct FaceValue {
  double distance = 0;
  Vec3 gradient;
};

/// A path in the plane z = const: a segment, or an arc of at most half a turn, counter-clockwise.
struct PlanePath {
  bool arc = false;
  Vec2 a, b, center;
  double radius = 0;

  /// Distance of p from the path and its gradient.
  std::pair<double, Vec2> distance(Vec2 p) const {
    Vec2 d;
    if (arc) {
      const Vec2 q = p - center;
      if (cross(a - center, q) >= 0 && cross(q, b - center) >= 0) {
        const double r = length(q);
        const double sign = r >= radius ? 1 : -1;
        return {sign * (r - radius), r > 0 ? (sign / r) * q : Vec2{1, 0}};
      }
      d = length(p - a) <= length(p - b) ? p - a : p - b;
    } else {
      const Vec2 e = b - a;
      const double t = std::clamp(dot(p - a, e) / std::max(dot(e, e), 1e-300), 0.0, 1.0);
      d = p - a - t * e;
    }
    const double r = length(d);
    return {r, r > 0 ? (1 / r) * d : Vec2{1, 0}};
  }
};

struct Cut {
  enum class Kind {
    flat,    ///< cylinder of radius r along the path, from z upwards; faces: wall, floor
    ball,    ///< ball end of radius r, its centre at z; one face
    step,    ///< turned: radius >= r and z >= z; faces: cylinder, shoulder
    round,   ///< turned: as step from (r, z), outside the circle of `size` about it
    fillet,  ///< turned: inside the circle of `size` about (r, z)
    half     ///< all above z, one face
  } kind = Kind::flat;
  PlanePath path;
  double r = 0, z = 0, size = 0;

  static constexpr int faces(Kind k) {
    return k == Kind::flat || k == Kind::step ? 2 : k == Kind::round ? 3 : 1;
  }

  /// Face `patch` of the part that this cut makes (sign of the part's d).
  FaceValue face(const Vec3& p, int patch) const {
    const double rho = std::sqrt(p.x * p.x + p.y * p.y);
    const Vec3 radial = rho > 0 ? Vec3{p.x / rho, p.y / rho, 0} : Vec3{1, 0, 0};
    switch (kind) {
      case Kind::flat: {
        if (patch == 1) return {p.z - z, {0, 0, 1}};
        const auto [d, g] = path.distance({p.x, p.y});
        return {r - d, {-g.x, -g.y, 0}};
      }
      case Kind::ball: {
        const auto [d, g] = path.distance({p.x, p.y});
        if (p.z >= z) return {r - d, {-g.x, -g.y, 0}};
        const double l = std::sqrt(d * d + (p.z - z) * (p.z - z));
        return {r - l, {-g.x * d / l, -g.y * d / l, -(p.z - z) / l}};
      }
      case Kind::half:
        return {p.z - z, {0, 0, 1}};
      case Kind::step:
        return patch == 0 ? FaceValue{rho - r, radial} : FaceValue{p.z - z, {0, 0, 1}};
      default: {
        if (kind == Kind::round && patch > 0)
          return patch == 1 ? FaceValue{rho - r, radial} : FaceValue{p.z - z, {0, 0, 1}};
        const double l = std::max(std::sqrt((rho - r) * (rho - r) + (p.z - z) * (p.z - z)), 1e-12);
        const Vec3 out = (rho - r) / l * radial + Vec3{0, 0, (p.z - z) / l};
        return kind == Kind::round ? FaceValue{l - size, out} : FaceValue{size - l, -out};
      }
    }
  }

  /// Minus the signed distance of the cut region, and the face that decides it.
  std::pair<double, int> value(const Vec3& p) const {
    const int n = faces(kind);
    double g[3] = {};
    int best = 0;
    for (int k = 0; k < n; ++k) {
      g[k] = face(p, k).distance;
      if (g[k] < g[best]) best = k;
    }
    if (n == 2 && g[0] < 0 && g[1] < 0) return {-std::sqrt(g[0] * g[0] + g[1] * g[1]), best};
    return {g[best], best};
  }
};

class AnalyticField final : public ExactField {
 public:
  /// A box, or with `round` the bar of radius hi.x about the Z axis from lo.z to hi.z.
  AnalyticField(const Box3& box, bool round, std::vector<Cut> cuts)
      : box_(box), round_(round), cuts_(std::move(cuts)) {}

  Candidates all() const override {
    Candidates ids(cuts_.size());
    std::iota(ids.begin(), ids.end(), 0u);
    return ids;
  }

  Region restrict_to(const Box3& box, double band, std::span<const std::uint32_t> in,
                     Candidates& out) const override {
    out.clear();
    const Vec3 c = 0.5 * (box.lo + box.hi);
    const double radius = 0.5 * length(box.hi - box.lo);
    const double reach = radius + band + 1e-9, stock = stock_value(c).first;
    if (stock > reach) return Region::air;
    double most = -std::numeric_limits<double>::infinity();
    for (const std::uint32_t i : in) most = std::max(most, cuts_[i].value(c).first);
    if (most > reach) return Region::air;
    for (const std::uint32_t i : in) {
      const double v = cuts_[i].value(c).first;
      if (v >= -reach && v >= most - 2 * radius - 1e-9) out.push_back(i);
    }
    return out.empty() && stock < -reach ? Region::material : Region::mixed;
  }

  FieldSample sample(const Vec3& p, std::span<const std::uint32_t> candidates) const override {
    const auto [stock, side] = stock_value(p);
    FieldSample s{stock, kStockOwner, side};
    for (const std::uint32_t i : candidates) {
      const auto [v, patch] = cuts_[i].value(p);
      if (v > s.distance) s = {v, static_cast<std::int32_t>(i), patch};
    }
    return s;
  }

  Vec3 gradient(const Vec3& p, const FieldSample& at) const override {
    return face(p, at).gradient;
  }
  double patch_distance(const Vec3& p, const FieldSample& at) const override {
    return face(p, at).distance;
  }
  bool expand_packs(const Box3&, double, std::span<const std::uint32_t> candidates,
                    Candidates& out) const override {
    out.assign(candidates.begin(), candidates.end());
    return true;
  }
  std::uint32_t candidate(std::int32_t owner) const override {
    return static_cast<std::uint32_t>(owner);
  }
  Box3 bounds() const override {
    return round_ ? Box3{{-box_.hi.x, -box_.hi.x, box_.lo.z}, {box_.hi.x, box_.hi.x, box_.hi.z}}
                  : box_;
  }

  FaceValue face(const Vec3& p, const FieldSample& at) const {
    return at.owner == kStockOwner ? stock_face(p, at.patch)
                                   : cuts_[static_cast<std::size_t>(at.owner)].face(p, at.patch);
  }

 private:
  FaceValue stock_face(const Vec3& p, int side) const {
    if (round_ && side == 0) {
      const double rho = std::sqrt(p.x * p.x + p.y * p.y);
      return {rho - box_.hi.x, rho > 0 ? Vec3{p.x / rho, p.y / rho, 0} : Vec3{1, 0, 0}};
    }
    const int axis = round_ ? 2 : side / 2;
    const bool high = round_ ? side == 2 : side % 2 == 1;
    Vec3 n;
    component(n, axis) = high ? 1 : -1;
    return {high ? component(p, axis) - component(box_.hi, axis)
                 : component(box_.lo, axis) - component(p, axis),
            n};
  }

  std::pair<double, int> stock_value(const Vec3& p) const {
    const int n = round_ ? 3 : 6;
    int best = 0;
    double most = -std::numeric_limits<double>::infinity(), squares = 0;
    for (int k = 0; k < n; ++k) {
      const double v = stock_face(p, k).distance;
      if (v > 0) squares += v * v;
      if (v > most) {
        most = v;
        best = k;
      }
    }
    return {most > 0 ? std::sqrt(squares) : most, best};
  }

  Box3 box_;
  bool round_;
  std::vector<Cut> cuts_;
};

inline Cut flat_arc(Vec2 center, double path_radius, bool lower, double tool, double floor) {
  Cut c{Cut::Kind::flat, {}, tool, floor, 0};
  const Vec2 left{center.x - path_radius, center.y}, right{center.x + path_radius, center.y};
  c.path = lower ? PlanePath{true, left, right, center, path_radius}
                 : PlanePath{true, right, left, center, path_radius};
  return c;
}
inline Cut flat_line(Vec2 a, Vec2 b, double tool, double floor) {
  return {Cut::Kind::flat, {false, a, b, {}, 0}, tool, floor, 0};
}
inline Cut ball_line(Vec2 a, Vec2 b, double tool, double center_z) {
  return {Cut::Kind::ball, {false, a, b, {}, 0}, tool, center_z, 0};
}

/// PRIMER_2F: three half circles of an end mill of 5 mm, 2 mm deep in a block 100 x 60 x 10.
inline AnalyticField primer_2f() {
  return {{{0, -60, 0}, {100, 0, 10}},
          false,
          {flat_arc({27.5, -30}, 15, true, 2.5, 8), flat_arc({50, -30}, 7.5, false, 2.5, 8),
           flat_arc({72.5, -30}, 15, true, 2.5, 8)}};
}
inline constexpr double kPrimer2fVolume = 60000 - 1217.3671532660448;  // 2 (187.5 + 6.25) pi

/// PRIMER_2S: the finished profile of the turned part in a bar of 50 mm, Z 0 .. 51.
inline AnalyticField primer_2s() {
  return {{{-25, -25, 0}, {25, 25, 51}},
          true,
          {{Cut::Kind::half, {}, 0, 50, 0},
           {Cut::Kind::round, {}, 10, 45, 5},
           {Cut::Kind::step, {}, 15, 31, 0},
           {Cut::Kind::fillet, {}, 21, 31, 6},
           {Cut::Kind::step, {}, 21, 25, 0}}};
}
inline constexpr double kPrimer2sVolume = 67084.031;

}  // namespace mrsim::testing
