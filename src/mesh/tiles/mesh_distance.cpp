#include "mesh/tiles/mesh_distance.h"

#include "core/numbers/vec.h"
#include "removal/field/face_range.h"

#include <algorithm>
#include <cmath>

namespace mrsim::detail {
namespace {

constexpr double kFirstStep = 1e-6;  ///< mm: upper end of the first bin
/// The mean over a triangle of what a quadratic function that is 0 at its corners has at its
/// middle.
constexpr double kMeanOfMiddle = 0.75;

// The upper ends of the bins: 1, 1.5, 2, 3, 4, 6 .. times the first.
double upper_end(std::size_t bin) {
  double end = kFirstStep;
  for (std::size_t k = 1; k < bin; k += 2) end *= 2;
  return bin % 2 ? 1.5 * end : end;
}

bool holds(const Box3& box, const Vec3& p) {
  return p.x >= box.lo.x && p.y >= box.lo.y && p.z >= box.lo.z && p.x <= box.hi.x &&
         p.y <= box.hi.y && p.z <= box.hi.z;
}

// The one of the cells about the edge in which p lies, or the smallest.
std::int32_t cell_at(const SurfaceCells& cells, const MinimalEdge& edge, const Vec3& p) {
  for (const std::int32_t cell : edge.cells)
    if (holds(cells.box(cell), p)) return cell;
  return edge.smallest_cell();
}

}  // namespace

void MeshDistance::count(double distance) {
  largest_ = std::max(largest_, distance);
  std::size_t low = 0, high = kBins - 1;
  while (low < high) {
    const std::size_t middle = (low + high) / 2;
    if (distance <= upper_end(middle))
      high = middle;
    else
      low = middle + 1;
  }
  ++bins_[low];
}

void MeshDistance::add(const ExactField& field, const SurfaceCells& cells, const MinimalEdge& edge,
                       const FieldSample& face, const Corners3& t) {
  const auto& [a, b, c] = t;
  const Vec3 middle = (1.0 / 3) * (a + b + c);
  const double d = field.sample(middle, cells.candidates(cell_at(cells, edge, middle))).distance;
  double found = std::abs(d);
  if (const FaceRange range = field.patch_range(t, face); std::isfinite(range.hi - range.lo)) {
    found = std::max({found, range.hi, -range.lo});
  } else {
    ++sampled_;
    for (const Vec3& p : {0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a)})
      found = std::max(found, std::abs(field.patch_distance(p, face)));
  }
  // Corners are exact, whatever the face.
  const double longest = std::max({distance(a, b), distance(b, c), distance(c, a)});
  const double most = kNearestCorner * longest;
  count(std::min(found, most));
  excess_ += kMeanOfMiddle * std::clamp(d, -most, most) * 0.5 * length(cross(b - a, c - a));
}

void MeshDistance::add(const MeshDistance& other) {
  largest_ = std::max(largest_, other.largest_);
  sampled_ += other.sampled_;
  excess_ += other.excess_;
  for (std::size_t k = 0; k < kBins; ++k) bins_[k] += other.bins_[k];
}

double MeshDistance::quantile(double share) const {
  std::uint64_t all = 0, below = 0;
  for (const std::uint64_t n : bins_) all += n;
  for (std::size_t k = 0; k < kBins; ++k) {
    below += bins_[k];
    if (static_cast<double>(below) >= share * static_cast<double>(all))
      return std::min(largest_, upper_end(k));
  }
  return largest_;
}

}  // namespace mrsim::detail
