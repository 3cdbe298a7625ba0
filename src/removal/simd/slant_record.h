// What the loops of slant_lanes.inl know of a slanted line and its tool.
#pragma once

#include <cstddef>

namespace mrsim {

/// A straight move of a tool with is_rounded() that reaches up, from its lower end.
struct alignas(32) SlantRecord {
  double x = 0, y = 0, z = 0;  ///< of the lower end; z of the tool's flat core
  double ux = 1, uy = 0;       ///< direction in plan, unit
  double length = 0;           ///< mm
  double plan = 1, rise = 0;   ///< in plan and upwards for each mm of the length, not negative
  double core = 0, round = 0;  ///< of the tool
  bool falls = false;          ///< the move ends at the lower end
};

/// Its numbers, in their order.
struct SlantColumn {
  enum : std::size_t { x, y, z, ux, uy, length, plan, rise, core, round, kCount };
};

}  // namespace mrsim
