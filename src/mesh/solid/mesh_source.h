// A mesh that can be read several times, block by block, from memory or from disk.
#pragma once

#include "mesh/solid/mesh_block.h"
#include <mrsim/types.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace mrsim {

class MeshSource {
 public:
  using Body = std::function<void(const MeshBlock& block)>;

  MeshSource() = default;
  MeshSource(const MeshSource&) = delete;
  MeshSource& operator=(const MeshSource&) = delete;
  virtual ~MeshSource() = default;

  virtual std::size_t vertices() const = 0;
  virtual std::size_t triangles() const = 0;
  /// Calls `body` for each block, in order; the blocks are the same each time.
  virtual void for_each_block(const Body& body) const = 0;
  /// The mesh, where it is in memory as a whole.
  virtual const TriMesh* in_memory() const { return nullptr; }
  /// What owners stand for.
  virtual const OwnerTable& origin() const = 0;
  virtual bool has_owners() const = 0;
  virtual bool has_colors() const { return false; }
  virtual const std::vector<ColorLabel>& legend() const;
};

/// A mesh in memory, which must outlive this.
class MemoryMesh final : public MeshSource {
 public:
  explicit MemoryMesh(const TriMesh& mesh) : mesh_(mesh) {}
  std::size_t vertices() const override { return mesh_.vertices.size(); }
  std::size_t triangles() const override { return mesh_.triangles.size(); }
  void for_each_block(const Body& body) const override { body(whole_block(mesh_)); }
  const TriMesh* in_memory() const override { return &mesh_; }
  const OwnerTable& origin() const override { return mesh_.origin; }
  bool has_owners() const override { return !mesh_.owners.empty(); }
  bool has_colors() const override { return !mesh_.colors.empty(); }
  const std::vector<ColorLabel>& legend() const override { return mesh_.legend; }

 private:
  const TriMesh& mesh_;
};

}  // namespace mrsim
