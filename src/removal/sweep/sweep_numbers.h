// Which sweeps, and packs of them, a list has. Each function means what its namesake in SweepTable
// says.
#pragma once

#include "removal/columns/sweep_columns.h"

#include <cstdint>
#include <span>
#include <vector>

namespace mrsim {

/// SweepTable::all().
std::vector<std::uint32_t> all_numbers(const SweepColumns& c, double longest);
/// SweepTable::expanded().
std::vector<std::uint32_t> sweeps_bounded(const SweepColumns& c,
                                          std::span<const std::uint32_t> list, const Box3& box);
/// SweepTable::meeting().
std::vector<std::uint32_t> sweeps_meeting(const SweepColumns& c,
                                          std::span<const std::uint32_t> list, const Box3& box);

}  // namespace mrsim
