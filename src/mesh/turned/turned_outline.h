// The outline of a turned part: the boundary of its section with the half plane y = 0, x >= 0, as
// exact points and what the part does between them (docs/mesh.md, Turned parts).
#pragma once

#include "mesh/cells/thin_features.h"
#include "removal/field/field.h"

#include <cstddef>
#include <vector>

namespace mrsim::detail {

/// A point of the outline and the chord that begins there, and the curve that it stands
/// for.
struct OutlinePoint {
  Vec3 at;            ///< mm, on the surface; y = 0, x the distance from the axis
  FieldSample face;   ///< what the chord belongs to
  double height = 0;  ///< mm: no point of the curve is farther from the chord, nor the reverse
  double excess = 0;  ///< mm^2 that lie between them, positive where the chord runs in the air
  double bend = 0;    ///< length of the difference of the unit normals before and after the point
};

/// The material lies on the left of the way. Not closed: from a point of the axis to another one,
/// whose chord means nothing.
struct Outline {
  std::vector<OutlinePoint> points;
  bool closed = false;
};

struct TurnedSection {
  std::vector<Outline> outlines;
  std::vector<FoundThin> lost;  ///< walls and gaps that are not in the outlines
  std::size_t squares = 0;      ///< voxels that were looked at
};

/// The outlines of the part, of chords whose height is at most `height` mm, but for those a few
/// times as long as `finest` mm. Walls and gaps as thin as that are found where they pass a line of
/// the voxel lattice, or wherever cells are that small. Requires: field.is_turned(field.all()).
/// Costs some 40 samples a voxel along the outline; same result for any number of threads.
TurnedSection turned_section(const ExactField& field, double voxel, double height, double finest,
                             int threads);

}  // namespace mrsim::detail
