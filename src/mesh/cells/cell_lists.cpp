#include "mesh/cells/cell_lists.h"

#include <atomic>
#include <memory>

namespace mrsim::detail {
namespace {

constexpr std::size_t kLong = 40;  // candidates from which a list of its own pays

// What the thread asked for last: lists of one shared one are narrowed on one way down.
struct LastList {
  std::uint64_t round = 0;
  std::int32_t shared = -1, cell = -1;
  std::unique_ptr<ExactField::Descent> descent;
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
  const std::int32_t number = cells_.list_of(cell);
  const Box3 box = cells_.box(cell);
  if (last.round != round_ || last.shared != number) {
    last.descent = field_.descent(0.5 * (box.lo + box.hi), shared);
    last.cell = -1;
  }
  if (last.cell != cell) {
    last.narrowed = last.descent->finish(1, reach_of(box, cells_.lattice().voxel()), kSurfaceBand,
                                         last.list) == ExactField::Region::mixed;
    last.round = round_, last.shared = number, last.cell = cell;
  }
  return last.narrowed ? std::span<const std::uint32_t>(last.list) : shared;
}

}  // namespace mrsim::detail
