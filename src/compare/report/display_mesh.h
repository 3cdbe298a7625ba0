// Meshes to look at: colours right inside of long triangles, not too many triangles.
#pragma once

#include "compare/distance/nominal.h"
#include <mrsim/compare.h>

#include <vector>

namespace mrsim {

struct DisplayMesh {
  TriMesh mesh;
  std::vector<float> deviation;  ///< #V, mm
};

/// Splits edges, both triangles of an edge alike so that the mesh stays closed, where they are
/// longer than 1/64 of the size, or where the deviation at their middle differs from the mean of
/// their ends by more than `band` (mm), down to 1/500 of the size. At most `most` triangles, or
/// those of `part`. Owners are kept.
DisplayMesh refine_for_display(const TriMesh& part, const NominalSurface& nominal, double band,
                               std::size_t most, int threads);

/// Merges the vertices in each cell of a grid that is as fine as `most` triangles allow. A cell
/// keeps the vertex nearest to the mean, and the deviation farthest from 0. For looking only: the
/// result need not be manifold.
DisplayMesh cluster_for_display(const DisplayMesh& fine, std::size_t most);

/// Pairs of vertices: edges where faces meet at more than `angle` radians.
std::vector<std::array<std::uint32_t, 2>> crease_lines(const TriMesh& mesh, double angle);

/// Colour of a deviation, sRGB: constant within the band, deepening to three times its width.
std::array<std::uint8_t, 3> deviation_color(double deviation, const Acceptance& band,
                                            DeviationScheme scheme);

/// The colours of that scheme with the distances they stand for, from excess to gouge.
std::vector<ColorLabel> deviation_legend(const Acceptance& band, DeviationScheme scheme);

}  // namespace mrsim
