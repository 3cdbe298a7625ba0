// How far the triangles of a mesh on the voxels are from the exact part: measured as they are made
// (docs/mesh.md, Default settings).
//
// Guarantees: each triangle counts with the enclosed distance from its face of the part
// (ExactField::patch_range), or, where no enclosure is known, with its largest at four points; and
// with d at its middle. Not guaranteed: parts of the surface that no triangle lies near.
#pragma once

#include "mesh/cells/cells.h"
#include "removal/field/field.h"

#include <array>
#include <cstdint>

namespace mrsim::detail {

class MeshDistance {
 public:
  /// A triangle about an edge of the cells, which lies on `face`.
  void add(const ExactField& field, const SurfaceCells& cells, const MinimalEdge& edge,
           const FieldSample& face, const Corners3& t);
  void add(const MeshDistance& other);

  double largest() const { return largest_; }
  /// mm that this share of all triangles do not exceed, rounded up to the next of some steps.
  double quantile(double share) const;
  std::size_t sampled() const { return sampled_; }
  /// mm^3 that the mesh holds more than the part, about: each triangle as if its corners were on
  /// the part and the part curved evenly between them.
  double excess() const { return excess_; }

 private:
  static constexpr std::size_t kBins = 64;
  void count(double distance);

  double largest_ = 0, excess_ = 0;
  std::size_t sampled_ = 0;
  std::array<std::uint64_t, kBins> bins_{};
};

}  // namespace mrsim::detail
