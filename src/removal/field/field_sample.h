// What an exact field (field.h) answers of a point, a triangle and a stock.
#pragma once

#include <mrsim/types.h>

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace mrsim {

/// Material is where d < -kInsideTolerance (mm): coincident surfaces are decided, not left to
/// rounding.
inline constexpr double kInsideTolerance = 1e-6;

inline constexpr std::int32_t kStockOwner = -1;
/// Candidate number that means the uncut stock; never part of a list of candidates.
inline constexpr std::uint32_t kStockDecides = ~std::uint32_t(0);

struct FieldSample {
  double distance = 0;  ///< mm
  std::int32_t owner =
      kStockOwner;         ///< index of the motion whose sweep decides d here, or kStockOwner
  std::int32_t patch = 0;  ///< smooth face of the owner (a mill's wall or floor, a side of the box)
};

/// A plane that touches one smooth face near a point: its unit normal out of the material and the
/// point's distance from it, mm.
struct FacePlane {
  Vec3 normal;
  double distance = 0;
};

using Corners3 = std::array<Vec3, 3>;  ///< of a triangle

/// Values that a function does not leave; infinite where nothing is known.
struct FaceRange {
  double lo = -std::numeric_limits<double>::infinity();
  double hi = std::numeric_limits<double>::infinity();
};

using Candidates = std::vector<std::uint32_t>;  ///< indices of sweeps, ascending

/// The curved faces of a stock that is a mesh, as its triangles draw them.
struct StockFacets {
  double area = 0;   ///< mm^2, without large flat faces
  double bend = 0;   ///< mm: length times angle, radians, of all edges of less than 30 degrees
  double edges = 0;  ///< how many these are
};

/// Whether a point at that distance (mm, signed) counts as material.
inline bool is_inside(double distance) { return distance < -kInsideTolerance; }

}  // namespace mrsim
