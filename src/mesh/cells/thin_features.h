// Walls and gaps that pass between neighbouring samples (docs/mesh.md, Thin features).
#pragma once

#include "mesh/cells/cells.h"
#include "mesh/cells/mesh_report.h"
#include "mesh/points/surface_search.h"
#include "removal/field/field.h"

#include <optional>
#include <span>
#include <vector>

namespace mrsim::detail {

/// Edge of a block, voxels: thin features of the same owners in two blocks are two features.
inline constexpr int kThinBlock = 8;

/// A thin feature and what identifies it: its owners and its block.
struct FoundThin {
  ThinFeature feature;
  std::uint64_t block = 0;
};

/// The wall or gap between two points on the same side of the surface that have different owners,
/// if it is found.
std::optional<ThinFeature> thin_between(const Probe& probe, const Vec3& low, const Vec3& high);

/// Thin walls and gaps on the doubtful edges, in their order.
std::vector<FoundThin> thin_features(const ExactField& field, const SurfaceCells& cells,
                                     std::span<const MinimalEdge> doubtful);

/// The doubtful edges' features that a mesh of the part does not hold within `tolerance` mm, on the
/// edge or on lines beside it, in the order of the edges; those at least `thinnest` mm thick where
/// they are met. Requires: the mesh is closed and oriented. Costs some hundred samples and searches
/// in the mesh for each such feature.
std::vector<FoundThin> lost_features(const ExactField& field, const SurfaceCells& cells,
                                     std::span<const MinimalEdge> doubtful, const TriMesh& mesh,
                                     double tolerance, double thinnest, int threads);

/// Material of the part, if blocks down to a voxel (mm) show any that is thicker than an eighth of
/// it. Costs a few samples for each block that the surface may pass.
std::optional<ThinFeature> find_material(const ExactField& field, double voxel);

/// The first of the found features for each pair of owners in each block.
std::vector<FoundThin> one_of_each(std::span<const FoundThin> found);
/// one_of_each(), without what identifies them.
std::vector<ThinFeature> distinct(std::span<const FoundThin> found);

}  // namespace mrsim::detail
