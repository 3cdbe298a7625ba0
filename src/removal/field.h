// The exact part as a function: d(p) = max(d_stock(p), -min_i d_i(p)), and its restriction to a
// ball.
//
// d is negative in the material and 1-Lipschitz; |d| is a lower bound of the distance to the
// surface, exact near it. Nothing here knows a grid: the carver samples this function into OpenVDB,
// the mesher asks it for crossings and normals.
//
// Candidates. A caller that works its way down from large blocks to small ones keeps, for each, the
// list of sweeps that can matter in it (restrict_to). Every query takes such a list; a longer list
// never changes a result inside the ball it was made for.
#pragma once

#include <mrsim/types.h>

#include <cstdint>
#include <span>
#include <vector>

namespace mrsim {

/// Material is where d < -kInsideTolerance (mm): coincident surfaces are decided, not left to
/// rounding.
inline constexpr double kInsideTolerance = 1e-6;

inline constexpr std::int32_t kStockOwner = -1;

struct FieldSample {
  double distance = 0;  ///< mm
  std::int32_t owner =
      kStockOwner;         ///< index of the motion whose sweep decides d here, or kStockOwner
  std::int32_t patch = 0;  ///< smooth face of the owner (a mill's wall or floor, a side of the box)
};

using Candidates = std::vector<std::uint32_t>;  ///< indices of sweeps, ascending

class ExactField {
 public:
  enum class Region : std::uint8_t { air, material, mixed };

  ExactField() = default;
  ExactField(const ExactField&) = delete;
  ExactField& operator=(const ExactField&) = delete;
  virtual ~ExactField() = default;

  /// All sweeps: the candidates of the whole space.
  virtual Candidates all() const = 0;

  /// Which of `in` can decide d within `radius` mm of `center`, or within `band` beyond the surface
  /// there. Region air (or material): d > band (or < -band) in the whole ball, `out` is then empty.
  /// `out` may not alias `in`.
  virtual Region restrict_to(const Vec3& center, double radius, double band,
                             std::span<const std::uint32_t> in, Candidates& out) const = 0;

  /// d, its owner and the owner's face at p. Ties: stock before sweep, then the least index.
  virtual FieldSample sample(const Vec3& p, std::span<const std::uint32_t> candidates) const = 0;

  /// out[k] = sample(points[k], candidates).distance, the same bits.
  virtual void distances(std::span<const Vec3> points, std::span<const std::uint32_t> candidates,
                         double* out) const {
    for (std::size_t k = 0; k < points.size(); ++k) out[k] = sample(points[k], candidates).distance;
  }

  /// Gradient of d at p for the owner and patch that sample(p) gave: unit length, out of the
  /// material.
  virtual Vec3 gradient(const Vec3& p, const FieldSample& at) const = 0;

  /// Signed distance of p from the surface of one smooth face (`at.owner`, `at.patch`), which is
  /// continued smoothly beyond its creases: equal to d where the nearest point of the part's
  /// surface lies on that face, negative on the material's side. gradient(p, at) is its gradient.
  /// The mesher solves for edges and corners as common zeros of two or three of these, so p may lie
  /// on the other side of the crease (a box's side: the distance of its plane; a slot's wall: R -
  /// rho; its floor: z - z_floor, all with d's sign).
  virtual double patch_distance(const Vec3& p, const FieldSample& at) const = 0;

  /// A box that holds the whole part.
  virtual Box3 bounds() const = 0;
};

inline bool is_inside(double distance) { return distance < -kInsideTolerance; }

}  // namespace mrsim
