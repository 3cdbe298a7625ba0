#include "removal/history/cut_volume.h"

#include "core/numbers/vec.h"
#include "removal/history/removed_volumes.h"

#include <algorithm>

namespace mrsim {
namespace {

constexpr std::int32_t kAligned = 8;

// Writes the voxels of walks into the array. Walks write different voxels, so several may run at
// once.
class ArraySink final : public CutSink {
 public:
  explicit ArraySink(CutVolume& volume) : volume_(volume) {}
  void tile(const CutCell& cell, std::int32_t cut) override {
    if (cut != kNeverThere) fill(cell, [cut](std::size_t) { return cut; });
  }
  void leaf(const CutCell& cell, const std::int32_t* cut) override {
    fill(cell, [cut](std::size_t k) { return cut[k]; });
  }

 private:
  template <typename Value>
  void fill(const CutCell& cell, Value value) {
    const int deep = volume_.lattice.half_plane ? 1 : cell.size;
    std::size_t k = 0;
    for (int x = 0; x < cell.size; ++x)
      for (int y = 0; y < deep; ++y)
        for (int z = 0; z < cell.size; ++z, ++k) {
          const int at[3] = {cell.origin[0] + x - volume_.first[0],
                             cell.origin[1] + y - volume_.first[1],
                             cell.origin[2] + z - volume_.first[2]};
          bool within = true;
          for (int axis = 0; axis < 3; ++axis)
            within = within && at[axis] >= 0 && at[axis] < volume_.size[std::size_t(axis)];
          if (within) volume_.cut[volume_.index(at[0], at[1], at[2])] = value(k);
        }
  }
  CutVolume& volume_;
};

// The voxels about the stock, with one layer of air at least.
void set_extent(const Box3& stock, CutVolume& volume) {
  const CutLattice& lattice = volume.lattice;
  const double shift[3] = {lattice.half_plane ? 0.5 : kLatticeShift.x, kLatticeShift.y,
                           kLatticeShift.z};
  for (int axis = 0; axis < 3; ++axis) {
    const auto k = std::size_t(axis);
    const auto low =
        std::int32_t(lattice_floor(lattice.voxel, component(stock.lo, axis), shift[axis]) - 1);
    const auto high =
        std::int32_t(lattice_floor(lattice.voxel, component(stock.hi, axis), shift[axis]) + 3);
    volume.first[k] = (low >= 0 ? low : low - kAligned + 1) / kAligned * kAligned;
    volume.size[k] = high - volume.first[k];
  }
  if (!lattice.half_plane) return;
  volume.size[0] += volume.first[0];
  volume.first[0] = volume.first[1] = 0;
  volume.size[1] = 1;
}

}  // namespace

CutVolume make_cut_volume(const PartField& field, const CutLattice& lattice, std::size_t motions,
                          int threads, const Progress& progress) {
  CutVolume out;
  out.lattice = lattice;
  set_extent(field.bounds(), out);
  out.cut.assign(std::size_t(out.size[0]) * std::size_t(out.size[1]) * std::size_t(out.size[2]),
                 kNeverThere);
  ArraySink sink(out);
  out.removed = removed_volumes(field, lattice, motions, threads, &sink, progress);
  return out;
}

}  // namespace mrsim
