#include "mesh/cells/surface_lists.h"

#include "core/process/parallel.h"
#include "mesh/cells/cells.h"

#include <span>
#include <utility>

namespace mrsim::detail {
namespace {

constexpr std::size_t kShort = 48;  ///< candidates: halving gains little below it
constexpr int kHalvings = 6;

template <class Parts>
void divide(const ExactField& field, std::size_t part, const Box3& box, int halvings,
            Parts& parts) {
  if (halvings == 0 || parts[part].list.size() <= kShort) return;
  const std::size_t first = parts.size();
  const Candidates list = std::exchange(parts[part].list, {});
  parts[part].child = static_cast<std::int32_t>(first);
  parts.resize(first + 8);
  for (int k = 0; k < 8; ++k) {
    const Box3 own = octant(box, k);
    auto& child = parts[first + static_cast<std::size_t>(k)];
    const Box3 reach = reach_of(own, own.hi.x - own.lo.x);
    child.has_surface =
        field.restrict_to(reach, kSurfaceBand, list, child.list) == ExactField::Region::mixed;
    if (!child.has_surface) child.list.clear();
  }
  for (int k = 0; k < 8; ++k)
    divide(field, first + static_cast<std::size_t>(k), octant(box, k), halvings - 1, parts);
}

}  // namespace

SurfaceLists::SurfaceLists(const ExactField& field, const SurfaceCells& cells, int threads) {
  std::vector<std::int32_t> long_ones;
  for (std::size_t cell = 0; cell < cells.size(); ++cell)
    if (cells.candidates(static_cast<std::int32_t>(cell)).size() > kShort)
      long_ones.push_back(static_cast<std::int32_t>(cell));
  if (long_ones.empty()) return;
  of_cell_.assign(cells.size(), -1);
  parts_.resize(long_ones.size());
  for (std::size_t k = 0; k < parts_.size(); ++k)
    of_cell_[static_cast<std::size_t>(long_ones[k])] = static_cast<std::int32_t>(k);
  parallel_for(parts_.size(), threads, [&](std::size_t k) {
    const std::span<const std::uint32_t> whole = cells.candidates(long_ones[k]);
    parts_[k].emplace_back().list.assign(whole.begin(), whole.end());
    divide(field, 0, cells.box(long_ones[k]), kHalvings, parts_[k]);
  });
}

const Candidates* SurfaceLists::at(const Vec3& p, std::int32_t cell, const Box3& box) const {
  const std::int32_t found = of_cell_[static_cast<std::size_t>(cell)];
  if (found < 0) return nullptr;
  const Parts& parts = parts_[static_cast<std::size_t>(found)];
  Box3 own = box;
  const Part* part = &parts.front();
  while (part->child >= 0) {
    const Vec3 middle = 0.5 * (own.lo + own.hi);
    const int k = (p.x > middle.x ? 1 : 0) | (p.y > middle.y ? 2 : 0) | (p.z > middle.z ? 4 : 0);
    own = octant(own, k);
    part = &parts[static_cast<std::size_t>(part->child + k)];
  }
  return part->has_surface ? &part->list : nullptr;
}

}  // namespace mrsim::detail
