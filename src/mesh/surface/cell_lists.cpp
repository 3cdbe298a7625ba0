#include "mesh/surface/cell_lists.h"

#include <atomic>

namespace mrsim::detail {
namespace {

constexpr std::size_t kLong = 40;  // candidates from which a list of its own pays

struct LastList {
  std::uint64_t round = 0;
  std::int32_t cell = -1;
  bool narrowed = false;
  Candidates list;
};

}  // namespace

void CellLists::restart() {
  static std::atomic<std::uint64_t> rounds{0};
  round_ = ++rounds;
}

std::span<const std::uint32_t> CellLists::of(std::int32_t cell) const {
  const std::span<const std::uint32_t> shared = cells_.candidates(cell);
  if (shared.size() < kLong) return shared;
  static thread_local LastList last;
  if (last.round != round_ || last.cell != cell) {
    last.round = round_, last.cell = cell;
    last.narrowed =
        field_.restrict_to(reach_of(cells_.box(cell), cells_.lattice().voxel()), kSurfaceBand,
                           shared, last.list) == ExactField::Region::mixed;
  }
  return last.narrowed ? std::span<const std::uint32_t>(last.list) : shared;
}

}  // namespace mrsim::detail
