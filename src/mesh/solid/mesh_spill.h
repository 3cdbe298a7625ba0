// A mesh on disk: its blocks as they came.
#pragma once

#include "core/output/scratch_file.h"
#include "mesh/solid/mesh_source.h"

#include <string>
#include <vector>

namespace mrsim {

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
