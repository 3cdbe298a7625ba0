// The path of a sweep as seen from above, and how far about it the sweep reaches.
#pragma once

#include "removal/field/record_slots.h"
#include "removal/sweep/sweep_table.h"

#include <array>
#include <cstdint>
#include <optional>

namespace mrsim {

/// Distances are signed, in mm, and 1-Lipschitz; the heights of points do not matter.
struct PlanPath {
  bool arc = false;
  std::array<double, ArcSlot::low> plan{};  ///< ArcSlot or LineSlot, as far as they tell the path
  double radius = 0;                        ///< the widest of the tool's; may be made less, below 0
  std::int32_t shape = 0;                   ///< equal for sweeps of one tool
  bool is_level = false;                    ///< a horizontal cut by an end mill
  double tip = 0, top = 0;                  ///< heights of its tip and of its upper end
  double round = 0;                         ///< corner radius of an end mill, else 0

  double distance(const Vec3& p) const;
  /// Away from the path, of unit length; somewhere where p is on it.
  Vec3 out(const Vec3& p) const;
};

/// None for helices, upright arcs, turning, and where the tool's axis leans.
std::optional<PlanPath> plan_path(const SweepTable& sweeps, std::uint32_t i);

}  // namespace mrsim
