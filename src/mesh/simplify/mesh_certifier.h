// Certifies the triangles of a mesh: how far they are from the exact part, each and all together,
// and which cells are to blame for one that is too far (docs/mesh.md, Tolerance).
#pragma once

#include "mesh/cells/octree.h"
#include "mesh/cells/thin_features.h"
#include "mesh/simplify/labelled_mesh.h"
#include "mesh/simplify/simplify.h"
#include "mesh/simplify/triangle_bounds.h"
#include "mesh/surface/dual_surface.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace mrsim::detail {

class MeshCertifier {
 public:
  /// Tolerance in mm.
  MeshCertifier(const ExactField& field, const CellOctree& tree, double tolerance, int threads)
      : field_(field), tree_(tree), tolerance_(tolerance), threads_(threads) {}

  /// Triangles that follow one another and are certified by one thread.
  static constexpr std::size_t kChunk = 256;

  /// Upper bound in mm of the distance of a triangle from the part: from the face that it is
  /// measured by or, where that is less, from its nearest corner, as corners lie on the part. Above
  /// `limit` it may be a distance that was found instead of a bound.
  TriangleBound certified(const Corners3& t, const FieldSample& face, double limit,
                          FaceDistances& distances) const;

  struct Total {
    double bound = 0;         ///< mm: the largest of the triangles
    std::size_t sampled = 0;  ///< triangles whose bound is not proven
  };
  /// A triangle that is not within the tolerance of the face of its label gets another label, that
  /// of the face at its middle, where that one is nearer. Where it is not within the tolerance
  /// since it passes a wall or gap that the mesh has lost, it does not count. Costs a product of
  /// their numbers.
  Total total(LabelledMesh& mesh, std::span<const FoundThin> lost) const;
  /// The volume of the mesh less that of the part, mm^3: the integral of d over the mesh.
  double volume_excess(const LabelledMesh& mesh) const;

 private:
  TriangleBound bound(const Corners3& t, const FieldSample& face, double limit,
                      FaceDistances& distances) const;
  TriangleBound least_bound(const Corners3& t, const FieldSample& face,
                            FaceDistances& distances) const;
  bool passes_lost(const Corners3& t, double bound, std::span<const FoundThin> lost) const;

  const ExactField& field_;
  const CellOctree& tree_;
  double tolerance_;
  int threads_;
};

/// The cells whose vertices have missed the face that triangle `t` of the surface is labelled with;
/// else the largest ones about its edge. `ahead`: those next to the former along the crease that
/// they have missed as well. With duplicates.
std::vector<std::int32_t> guilty_cells(const ExactField& field, const CellOctree& tree,
                                       const DualSurface& surface, const LabelledMesh& mesh,
                                       std::size_t t, bool ahead);

/// The face that decides at the middle of a triangle, or beside it, where its corners are nearer to
/// that one than to the face of its label.
std::optional<FieldSample> nearer_face(const ExactField& field, const CellOctree& tree,
                                       const LabelledMesh& mesh, std::size_t t);

}  // namespace mrsim::detail
