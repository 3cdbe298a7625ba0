#include "mesh/tiles/kept_tiles.h"

namespace mrsim::detail {

std::shared_ptr<const TileMesh> KeptTiles::find(std::size_t tile, const BareTiles& about) const {
  const std::scoped_lock lock(mutex_);
  const Kept& kept = tiles_[tile];
  return kept.about == about ? kept.mesh : nullptr;
}

void KeptTiles::drop(Kept& kept) {
  if (kept.mesh != nullptr) room_ += kept.mesh->memory();
  kept.mesh = nullptr;
}

void KeptTiles::keep(std::size_t tile, const BareTiles& about,
                     const std::shared_ptr<const TileMesh>& mesh) {
  const std::scoped_lock lock(mutex_);
  Kept& kept = tiles_[tile];
  if (kept.mesh == mesh) return;
  drop(kept);
  if (mesh->memory() > room_) return;
  room_ -= mesh->memory();
  kept = {mesh, about};
}

void KeptTiles::forget(std::size_t tile) {
  const std::scoped_lock lock(mutex_);
  drop(tiles_[tile]);
}

}  // namespace mrsim::detail
