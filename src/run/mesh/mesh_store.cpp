#include "run/mesh/mesh_store.h"

#include "core/process/error.h"

#include <utility>

namespace mrsim {

MeshStore::MeshStore(const std::optional<std::string>& folder, double room, int threads,
                     MeshSink& next)
    : room_(room), next_(next), audit_(threads), collected_(collector_.mesh()) {
  if (folder) spilled_ = std::make_unique<SpilledMesh>(*folder);
}

void MeshStore::take(const MeshBlock& block) {
  is_full_ = !spilled_ && static_cast<double>(collector_.bytes_with(block)) > room_;
  if (is_full_) throw Error("memory", "the mesh takes more memory than was expected");
  ++blocks_;
  audit_.take(block);
  owners_.add(block.owners);
  if (spilled_)
    spilled_->take(block);
  else
    collector_.take(block);
  next_.take(block);
}

void MeshStore::restart() {
  blocks_ = 0;
  audit_.restart();
  owners_.clear();
  collector_.restart();
  if (spilled_) spilled_->restart();
  next_.restart();
}

const MeshSource& MeshStore::source() const {
  if (piece_) return *piece_;
  if (spilled_) return *spilled_;
  return collected_;
}

MeshSummary MeshStore::summary() const { return audit_.summary(kept_); }

void MeshStore::keep(const Piece& piece) {
  auto chosen = std::make_unique<PieceOfMesh>(audit_, source(), piece);
  kept_ = chosen->wanted();
  if (spilled_)
    piece_ = std::move(chosen);
  else
    collector_.mesh() = collected(*chosen);
  owners_.clear();
  source().for_each_block([this](const MeshBlock& block) { owners_.add(block.owners); });
}

void MeshStore::replace(TriMesh mesh) {
  collector_.mesh() = std::move(mesh);
  audit_.restart();
  kept_.clear();
  owners_.clear();
  source().for_each_block([this](const MeshBlock& block) {
    audit_.take(block);
    owners_.add(block.owners);
  });
}

void MeshStore::set_origin(const OwnerTable& origin) {
  if (spilled_)
    spilled_->set_origin(origin);
  else
    collector_.mesh().origin = origin;
}

}  // namespace mrsim
