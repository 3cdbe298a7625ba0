#include "mesh/cells/cell_halvings.h"

#include "core/numbers/vec.h"
#include "core/process/error.h"
#include "mesh/solid/vertex_lattice.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mrsim::detail {
namespace {

double largest_coordinate(const Box3& bounds) {
  double largest = 0;
  for (int a = 0; a < 3; ++a)
    largest = std::max({largest, std::abs(mrsim::component(bounds.lo, a)),
                        std::abs(mrsim::component(bounds.hi, a))});
  return largest;
}

}  // namespace

int voxel_halvings(const Box3& bounds, double voxel, double tolerance) {
  const Vec3 size = bounds.hi - bounds.lo;
  const double longest = std::max({size.x, size.y, size.z});
  const double wanted = tolerance > 0 ? 0.5 * tolerance : voxel / 8;
  const double least = 64 * coordinate_step(largest_coordinate(bounds));
  int halvings = 0;
  while (halvings < 12 && voxel / (1 << halvings) > wanted && voxel / (2 << halvings) > least)
    ++halvings;
  while (halvings > 0 && 2 * longest / voxel * (1 << halvings) > (1 << 20)) --halvings;
  return halvings;
}

void require_tolerance(const Box3& bounds, double tolerance) {
  const double largest = largest_coordinate(bounds), least = coordinate_step(largest);
  if (tolerance < least)
    throw Error("tolerance-invalid",
                fmt::format("a tolerance of {:.3g} mm is too small: the mesh's coordinates, up to "
                            "{:.6g} mm, are floats; --tolerance {:.2g} or more",
                            tolerance, largest, 1.1 * least),
                Error::Kind::usage);
}

void require_resolved(const Box3& bounds, double voxel) {
  constexpr double kSteps = 4;  // planes of the lattice are floats, too
  const double largest = largest_coordinate(bounds), least = kSteps * coordinate_step(largest);
  if (voxel < least)
    throw Error("voxel-invalid",
                fmt::format("a voxel of {:.3g} mm is too small: the mesh's coordinates, up to "
                            "{:.6g} mm, are floats; --voxel {:.2g} or more",
                            voxel, largest, 1.1 * least),
                Error::Kind::usage);
}

}  // namespace mrsim::detail
