// A mesh that can be read several times, block by block, from memory or from disk.
#pragma once

#include "core/output/scratch_file.h"
#include "mesh/solid/mesh_block.h"
#include <mrsim/types.h>

#include <cstddef>
#include <functional>
#include <string>
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
  /// The table that says what each owner stands for.
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

/// Takes blocks into a file without a name in `folder` and gives them again. Memory: that of a
/// block. Throws what ScratchFile throws. Blocks without colours only.
class SpilledMesh final : public MeshSink, public MeshSource {
 public:
  explicit SpilledMesh(const std::string& folder) : file_(folder) {}

  void take(const MeshBlock& block) override;
  void restart() override;

  std::size_t vertices() const override { return vertices_; }
  std::size_t triangles() const override { return triangles_; }
  void for_each_block(const Body& body) const override;
  const OwnerTable& origin() const override { return origin_; }
  bool has_owners() const override { return true; }
  void set_origin(OwnerTable origin) { origin_ = std::move(origin); }

 private:
  struct Record {
    std::uint64_t offset = 0;
    std::size_t points = 0, borrowed = 0, triangles = 0, unfinished = 0;
    std::uint32_t first_new = 0;
  };
  ScratchFile file_;
  std::vector<Record> records_;
  std::size_t vertices_ = 0, triangles_ = 0;
  OwnerTable origin_;
};

}  // namespace mrsim
