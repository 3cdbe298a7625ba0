// The mesh of the part while it is made, checked and written: in memory, or on disk where memory is
// short.
#pragma once

#include "mesh/solid/mesh_audit.h"
#include "mesh/solid/mesh_source.h"
#include "mesh/solid/owner_set.h"
#include "mesh/solid/pieces.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace mrsim {

class MeshStore final : public MeshSink {
 public:
  /// `folder`: where it is kept on disk; none: in memory, up to `room` bytes. `threads`: of checks.
  /// `next` takes the blocks too.
  MeshStore(const std::optional<std::string>& folder, double room, int threads, MeshSink& next);

  /// Throws Error "memory" where there is no room for it.
  void take(const MeshBlock& block) override;
  bool is_full() const { return is_full_; }
  void expect(std::size_t vertices, std::size_t triangles) override {
    if (!spilled_) collector_.expect(vertices, triangles);
  }
  void restart() override;

  const MeshAudit& audit() const { return audit_; }
  std::size_t blocks() const { return blocks_; }
  /// The part, or what keep() has left of it.
  const MeshSource& source() const;
  /// The figures of what is left.
  MeshSummary summary() const;
  void keep(const Piece& piece);
  /// Another mesh takes its place. Requires: one that is in memory.
  void replace(TriMesh mesh);
  /// The owners of the faces that are left, ascending.
  std::vector<std::int32_t> owners() const { return owners_.sorted(); }
  void set_origin(const OwnerTable& origin);
  /// The mesh where it is in memory, else none.
  TriMesh& in_memory() { return collector_.mesh(); }

 private:
  double room_;
  bool is_full_ = false;
  MeshSink& next_;
  MeshAudit audit_;
  MeshCollector collector_;
  MemoryMesh collected_;
  std::unique_ptr<SpilledMesh> spilled_;
  std::unique_ptr<PieceOfMesh> piece_;
  std::vector<bool> kept_;
  OwnerSet owners_;
  std::size_t blocks_ = 0;
};

}  // namespace mrsim
