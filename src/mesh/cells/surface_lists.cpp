#include "mesh/cells/surface_lists.h"

#include "core/process/parallel.h"
#include "mesh/cells/cells.h"

#include <array>
#include <span>
#include <utility>

namespace mrsim::detail {
namespace {

constexpr std::size_t kShort = 48;  ///< candidates: halving gains little below it
constexpr int kListHalvings = 6;
// Where the parts' lists are hardly shorter, as where all passes end in one wall, halving gains
// nothing. Shares of the list that is halved, on average.
constexpr double kShorter = 0.9;
// Candidates that the parts of a cell may hold, as multiples of those of the cell. Floors of loops
// side by side take up to 5.
constexpr std::size_t kMostHeld = 8;

}  // namespace

// Divides the first part, then the parts that this makes, the larger ones first.
void SurfaceLists::divide(const ExactField& field, const Box3& box, Parts& parts) {
  struct Place {
    Box3 box;
    int halvings;
  };
  std::vector<Place> places{{box, kListHalvings}};
  std::size_t held = parts.front().list.size();
  const std::size_t most = kMostHeld * held;
  std::array<Part, 8> children;
  for (std::size_t part = 0; part < parts.size() && held <= most; ++part) {
    const Place place = places[part];
    const std::size_t before = parts[part].list.size();
    if (place.halvings == 0 || before <= kShort) continue;
    std::size_t after = 0, passed = 0;
    for (int k = 0; k < 8; ++k) {
      const Box3 own = octant(place.box, k);
      Part& child = children[static_cast<std::size_t>(k)];
      child = Part();
      child.has_surface =
          field.restrict_to(reach_of(own, own.hi.x - own.lo.x), kSurfaceBand, parts[part].list,
                            child.list) == ExactField::Region::mixed;
      if (!child.has_surface) child.list.clear();
      after += child.list.size();
      passed += child.has_surface;
    }
    if (double(after) > kShorter * double(before) * double(passed)) continue;
    parts[part].list = Candidates();
    parts[part].child = static_cast<std::int32_t>(parts.size());
    held += after;
    held -= before;
    for (int k = 0; k < 8; ++k) {
      places.push_back({octant(place.box, k), place.halvings - 1});
      parts.push_back(std::move(children[static_cast<std::size_t>(k)]));
    }
  }
}

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
    divide(field, cells.box(long_ones[k]), parts_[k]);
  });
}

std::size_t SurfaceLists::memory() const {
  std::size_t bytes = of_cell_.capacity() * sizeof(of_cell_[0]) + parts_.capacity() * sizeof(Parts);
  for (const Parts& parts : parts_) {
    bytes += parts.capacity() * sizeof(Part);
    for (const Part& part : parts) bytes += part.list.capacity() * sizeof(part.list[0]);
  }
  return bytes;
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
