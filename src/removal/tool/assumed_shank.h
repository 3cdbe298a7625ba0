// The shank that is assumed above a cutter that ends (flutes of a given length, the head of a
// T-slot mill) where none is given: every real tool has one, and it breaks in material.
#pragma once

#include <mrsim/types.h>

#include <span>
#include <vector>

namespace mrsim {

/// Diameter in mm of the shank that a milling tool is checked with where it has none of its own:
/// the neck of a T-slot or lollipop mill, else nearly that of the cutter's upper end. 0: the cutter
/// has no end, shank or holder are given, or nothing tells their size (has_unknown_neck()).
double assumed_shank(const Tool& tool);

/// The cutter ends in a neck of which no size is given: a head without `neck_diameter`, a form tool
/// whose profile ends on the axis.
bool has_unknown_neck(const Tool& tool);

/// The tools, each with its own shank or the assumed one.
std::vector<Tool> with_shanks(std::span<const Tool> tools);

}  // namespace mrsim
