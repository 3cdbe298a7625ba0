#include "mesh/contour_certify.h"

#include <algorithm>
#include <cmath>

namespace mrsim::detail {
namespace {

constexpr double kCubicRoom = 4;       ///< multiple of the centroid's deviation from the quadratic
constexpr double kSmoothAngle = 0.05;  ///< sine below which a crease is measured from its faces

// Largest |q| of the quadratic that vanishes at the corners and is m[i] in the middle of side i
// (between corners i and i + 1), on a lattice of an eighth, with the rest a lattice can miss.
double largest_quadratic(const double (&m)[3]) {
  double most = 0;
  for (int i = 0; i <= 8; ++i)
    for (int j = 0; i + j <= 8; ++j) {
      const double x = i / 8.0, y = j / 8.0, z = 1 - x - y;
      most = std::max(most, std::abs(4 * (m[0] * x * y + m[1] * y * z + m[2] * z * x)));
    }
  return 1.02 * most;
}

}  // namespace

double triangle_bound(const ExactField& field, const FieldSample& face, const Vec3& a,
                      const Vec3& b, const Vec3& c, double limit) {
  const Vec3* p[3] = {&a, &b, &c};
  double at_corner[3], m[3], corner = 0, side = 0, total = 0;
  for (int i = 0; i < 3; ++i) {
    at_corner[i] = field.patch_distance(*p[i], face);
    corner = std::max(corner, std::abs(at_corner[i]));
  }
  if (corner > limit) return corner;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    m[i] = field.patch_distance(0.5 * (*p[i] + *p[j]), face) - 0.5 * (at_corner[i] + at_corner[j]);
    side = std::max(side, std::abs(m[i]));
    total += m[i];
  }
  if (corner + side > limit) return corner + side;
  const double center = field.patch_distance((1.0 / 3) * (a + b + c), face) -
                        (at_corner[0] + at_corner[1] + at_corner[2]) / 3;
  const double cubic = kCubicRoom * std::abs(center - 4.0 / 9 * total);
  return corner + largest_quadratic(m) + cubic;
}

double crease_bound(const ExactField& field, const FieldSample& f, const FieldSample& g,
                    const Vec3& a, const Vec3& b) {
  const Vec3 p = 0.5 * (a + b);
  const Vec3 n = field.gradient(p, f), m = field.gradient(p, g);
  const double x = field.patch_distance(p, f), y = field.patch_distance(p, g);
  const double ab = dot(n, m), det = 1 - ab * ab;
  if (det < kSmoothAngle * kSmoothAngle) return std::max(std::abs(x), std::abs(y));
  return std::sqrt(std::max((x * x - 2 * ab * x * y + y * y) / det, 0.0));
}

}  // namespace mrsim::detail
