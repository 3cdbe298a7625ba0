// A mesh in blocks. The mesher hands it over block by block, and checks and file writers take it
// so: none of them needs the whole mesh. A mesh in memory is one block.
#pragma once

#include <mrsim/types.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace mrsim {

/// Some triangles of a mesh, one after another, with their vertices. Each vertex has a
/// number in the whole mesh, in the order in which vertices come. Triangles of a block name them by
/// their place in `points`: first those borrowed from earlier blocks, then the new ones.
struct MeshBlock {
  std::span<const std::array<float, 3>> points;             ///< #borrowed + #new, mm
  std::span<const std::uint32_t> borrowed;                  ///< their numbers in the whole mesh
  std::uint32_t first_new = 0;                              ///< number of the first new one
  std::span<const std::array<std::uint32_t, 3>> triangles;  ///< by `points`
  std::span<const std::int32_t> owners;                     ///< of the triangles, or empty
  std::span<const std::array<std::uint8_t, 3>> colors;      ///< of the new vertices, or empty
  /// Vertices of this and earlier blocks that later ones may borrow: numbers in the whole mesh,
  /// ascending.
  std::span<const std::uint32_t> unfinished;

  std::span<const std::array<float, 3>> fresh() const { return points.subspan(borrowed.size()); }
  /// Number of a point in the whole mesh.
  std::uint32_t number(std::uint32_t point) const {
    return point < borrowed.size()
               ? borrowed[point]
               : first_new + (point - static_cast<std::uint32_t>(borrowed.size()));
  }
};

/// A mesh in memory, as one block.
inline MeshBlock whole_block(const TriMesh& mesh) {
  return {mesh.vertices, {}, 0, mesh.triangles, mesh.owners, mesh.colors, {}};
}

/// Takes the blocks of a mesh in their order.
class MeshSink {
 public:
  virtual ~MeshSink() = default;
  virtual void take(const MeshBlock& block) = 0;
  /// An estimate of the whole size; called before the first block.
  virtual void expect(std::size_t vertices, std::size_t triangles) {
    static_cast<void>(vertices), static_cast<void>(triangles);
  }
  /// Starts again: drops all blocks so far.
  virtual void restart() = 0;

 protected:
  MeshSink() = default;
  MeshSink(const MeshSink&) = default;
  MeshSink& operator=(const MeshSink&) = default;
};

/// Puts the blocks together again.
class MeshCollector final : public MeshSink {
 public:
  void take(const MeshBlock& block) override;
  void expect(std::size_t vertices, std::size_t triangles) override;
  void restart() override { mesh_ = {}; }
  TriMesh& mesh() { return mesh_; }
  /// Bytes in use at most while the block is taken.
  std::size_t bytes_with(const MeshBlock& block) const;

 private:
  TriMesh mesh_;
  std::size_t expected_vertices_ = 0, expected_triangles_ = 0;
};

}  // namespace mrsim
