// The path of a sweep as seen from above, and how far about it the sweep reaches.
#pragma once

#include "removal/field/record_slots.h"
#include "removal/sweep/sweep_table.h"
#include "removal/tool/profile.h"

#include <array>
#include <cstdint>
#include <optional>

namespace mrsim {

/// Distances are signed, in mm, and 1-Lipschitz; the heights of points do not matter.
struct PlanPath {
  bool arc = false;
  std::array<double, ArcSlot::low> plan{};  ///< ArcSlot or LineSlot, as far as they tell the path
  double radius = 0;                        ///< the widest of the tool's; may be made less, below 0
  /// Heights, mm: from the one to the other all within `radius` of the path is swept; of end mills
  /// all within what their corner leaves of the radius. None where `from` is above `to`.
  double from = 0, to = 0;
  double round = 0;               ///< corner radius of an end mill, else 0
  double low = 0;                 ///< mm: lowest height of the tool's origin
  const Profile* tool = nullptr;  ///< valid as long as the table

  bool is_upright() const;
  double distance(const Vec3& p) const;
  /// Away from the path, of unit length; somewhere where p is on it.
  Vec3 out(const Vec3& p) const;
};

/// None for upright arcs, turning, and where the tool's axis leans.
std::optional<PlanPath> plan_path(const SweepTable& sweeps, std::uint32_t i);

/// Whether the cut is a plunge that has cleared what the mover, another upright move at its place,
/// has below its widest place: by the same nose, which never narrows upwards, and no less deep.
bool holds_nose(const PlanPath& cut, const PlanPath& mover);

}  // namespace mrsim
