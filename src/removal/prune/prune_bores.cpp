#include "removal/prune/prune_bores.h"

#include "core/numbers/rounding.h"

#include <algorithm>
#include <cmath>

namespace mrsim {
namespace {

// Whether lane::bore (sweep_lanes.inl) decides everywhere in the region: its first position lies
// no higher beside a point than the point lies within the wall.
bool decides(const double* bore, const PruneRegion& region) {
  if (bore[BoreSlot::whole] == 0) return false;
  const double dx = region.center.x - bore[BoreSlot::x], dy = region.center.y - bore[BoreSlot::y];
  const double wall = std::fabs(std::sqrt(dx * dx + dy * dy) - bore[BoreSlot::radius]) -
                      bore[BoreSlot::core];  // changes by no more than the way
  const double above = region.center.z - bore[BoreSlot::first_low];
  return region.radius - above + kBoundError <= std::min(wall - region.radius, 0.0);
}

bool have_one_wall(const double* a, const double* b) {
  return std::equal(a + BoreSlot::x, a + BoreSlot::first_low, b + BoreSlot::x);
}

}  // namespace

void drop_later_turns(const SweepColumns& columns, const PruneRegion& region,
                      std::vector<std::uint32_t>& sweeps) {
  if (columns.bores.empty()) return;
  static thread_local std::vector<const double*> walls;
  walls.clear();
  const auto is_later = [&](std::uint32_t id) {
    if (id >= columns.refs.size()) return false;
    const SweepRef& ref = columns.refs[id];
    if (ref.frame != 0 || !columns.is_bore(ref)) return false;
    const double* bore = columns.bores[ref.row].c;
    if (!decides(bore, region)) return false;
    for (const double* wall : walls)
      if (have_one_wall(wall, bore)) return true;
    walls.push_back(bore);
    return false;
  };
  sweeps.erase(std::remove_if(sweeps.begin(), sweeps.end(), is_later), sweeps.end());
}

}  // namespace mrsim
