// Checks whether a mesh bounds a solid and finds its connected surfaces, block by block. Needs
// memory for one block and for the triangles about unfinished vertices only.
//
// An edge is judged when the first of its vertices is done (no later block may borrow it), a vertex
// when it is done itself: all triangles about them are known then. The sums do not depend on the
// order of the triangles, so the figures do not depend on the blocks.
#pragma once

#include "core/numbers/disjoint_sets.h"
#include "mesh/solid/half_edges.h"
#include "mesh/solid/mesh_block.h"
#include <mrsim/types.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace mrsim {

/// A sum of numbers that is the same in any order, exact to 2^-40 a number below 2^55.
class OrderlessSum {
 public:
  void add(double x) {
    const double scaled = x * kScale;
    if (std::abs(scaled) < 0x1p62)
      sum_ += static_cast<std::int64_t>(scaled);
    else if (std::abs(scaled) < 0x1p95)
      sum_ += static_cast<Wide>(scaled);
    else
      beyond_ += x;
  }
  void add(const OrderlessSum& other) {
    sum_ += other.sum_;
    beyond_ += other.beyond_;
  }
  double value() const { return static_cast<double>(sum_) * (1 / kScale) + beyond_; }

 private:
  __extension__ using Wide = __int128;
  static constexpr double kScale = 0x1p40;
  Wide sum_ = 0;
  double beyond_ = 0;
};

/// A connected component of the surface.
struct SurfaceComponent {
  std::uint64_t first_triangle = ~std::uint64_t(0);
  std::size_t triangles = 0, vertices = 0;
  Box3 bounds;  ///< mm
  OrderlessSum volume6, area2;
  OrderlessSum moment24[3];  ///< about MeshAudit::center(): of the volume, times 24
  double volume() const { return volume6.value() / 6; }  ///< mm^3, signed
  double area() const { return area2.value() / 2; }      ///< mm^2
};

class MeshAudit final : public MeshSink {
 public:
  explicit MeshAudit(int threads = 1) : threads_(threads) {}
  /// Requires: indices in range, coordinates finite.
  void take(const MeshBlock& block) override;
  void restart() override { *this = MeshAudit(threads_); }

  /// The components, by their first triangles. Requires: all blocks were taken.
  const std::vector<SurfaceComponent>& components() const;
  /// For each triangle of block `index`, which is given anew, its component. The blocks may also
  /// have been joined to one.
  std::vector<std::uint32_t> components_of(std::size_t index, const MeshBlock& block) const;
  /// The figures of the whole mesh, or of those components for which `kept` holds.
  MeshSummary summary(const std::vector<bool>& kept = {}) const;
  Vec3 center() const { return center_; }

 private:
  // A part of the mesh with all triangles about the vertices that are done with this block.
  struct Patch {
    enum State : std::uint8_t { unfinished, closing, done };
    std::vector<std::array<float, 3>> points;
    std::vector<std::uint32_t> numbers, nodes;  ///< of the points; numbers ascend
    std::vector<State> states;
    std::vector<std::array<std::uint32_t, 3>> triangles;
  };
  struct Fault {
    std::size_t boundary = 0, twisted = 0, crowded = 0, vertices = 0, degenerate = 0;
    std::uint32_t first = 0;         ///< what is wrong with the first edge, as find_opposites says
    std::string edge, vertex, flat;  ///< where the first are
    std::size_t edges() const { return boundary + twisted + crowded; }
    std::string edge_text() const;
  };

  void add_components(const MeshBlock& block);
  void add_sums(const MeshBlock& block, const std::vector<std::uint32_t>& component);
  Patch patch_with(const MeshBlock& block);
  void check(std::span<const Patch::State> states, std::span<const std::array<float, 3>> points,
             Triangles triangles);
  void check_edges(std::span<const Patch::State> states,
                   std::span<const std::array<float, 3>> points, Triangles triangles,
                   const std::vector<std::uint32_t>& opposite);
  void check_vertices(std::span<const Patch::State> states,
                      std::span<const std::array<float, 3>> points, Triangles triangles,
                      const std::vector<std::uint32_t>& opposite);
  void keep_front(const Patch& patch);

  int threads_;
  std::uint64_t triangles_ = 0;
  Vec3 center_;
  std::vector<std::uint32_t> first_node_;  ///< by block
  std::vector<SurfaceComponent> nodes_;    ///< a component within a block
  std::vector<std::uint32_t> node_of_;     ///< of the present block's points
  mutable DisjointSets joined_;            ///< nodes of one component of the mesh
  Patch front_;                            ///< triangles about unfinished vertices
  Fault fault_;
  mutable std::vector<SurfaceComponent> components_;
  mutable std::vector<std::uint32_t> component_of_node_;
};

}  // namespace mrsim
