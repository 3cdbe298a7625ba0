#include "removal/prune/prune_turned.h"

#include "core/numbers/rounding.h"
#include "removal/columns/sweep_columns.h"
#include "removal/prune/region_args.h"

#include <algorithm>
#include <cmath>

namespace mrsim {

TurnRegion turn_region(const PruneRegion& region) {
  const Vec3& c = region.center;
  const double rho = std::sqrt(c.x * c.x + c.y * c.y);
  TurnRegion r{{rho, c.z}, {region.half, region.tall}};
  if (!region.box) return r;
  const double x = std::fabs(c.x), y = std::fabs(c.y), h = region.half;
  const double near_x = std::max(x - h, 0.0), near_y = std::max(y - h, 0.0);
  const double nearest = std::sqrt(near_x * near_x + near_y * near_y);
  const double farthest = std::sqrt((x + h) * (x + h) + (y + h) * (y + h));
  r.half.x = std::max(rho - nearest, farthest - rho) + kRounding;
  return r;
}

bool expand_turned(const SweepTable& table, const PruneRegion& region, double reach,
                   std::size_t most, std::vector<std::uint32_t>& ids) {
  static thread_local TurnTree::Packs packs;
  static thread_local std::vector<TurnMember> members;
  const auto numbers = table.columns().numbers_of(ids);
  if (numbers.turned.empty()) return true;
  if (!numbers.packs.empty()) return false;
  const std::size_t plain = numbers.sweeps.size();
  const TurnTree& tree = table.turn_tree();
  const TurnRegion at = turn_region(region);
  packs.clear(), members.clear();
  for (std::size_t k = plain; k < ids.size(); ++k) {
    packs.push_back(ids[k] - static_cast<std::uint32_t>(table.size()));
    if (packs.size() > most || !tree.is_leaf(packs.back())) return false;
  }
  TurnTree::Nearest best;
  for (const std::uint32_t pack : packs) tree.nearest(pack, at.center.x, at.center.y, best);
  tree.members(at, best, reach, 2 * table.max_error() + kRounding, packs, members);
  if (members.size() > most) return false;
  ids.resize(plain);
  for (const TurnMember& m : members) ids.push_back(m.sweep);
  std::sort(ids.begin(), ids.end());
  // A sweep and its mirror image have the same number: one of them is kept.
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return true;
}

}  // namespace mrsim
