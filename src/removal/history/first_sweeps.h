// Candidate lists of the history: which sweeps can be the first to remove some place of a part of a
// region.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace mrsim {

/// Adds to the lists of `parts` the sweeps of `list` that may be the first to remove something
/// there. A part's list ends with the first sweep that holds all of the part. A sweep is left out
/// where an earlier one is nearer everywhere: both distances are 1-Lipschitz. `measure(sweep)` sets
/// least[c], the distance of the sweep from the centre of part c, mm. `reach`: of a part from its
/// centre; `lost`: by how much more than the least distance so far a sweep may be away and still be
/// nearer somewhere in the part, mm.
template <class Part, class Measure>
void distribute_sweeps(std::span<const std::uint32_t> list, std::span<Part> parts,
                       const double* least, double reach, double lost, const Measure& measure) {
  bool undecided =
      std::any_of(parts.begin(), parts.end(), [](const Part& p) { return !p.decided; });
  for (auto sweep = list.begin(); sweep != list.end() && undecided; ++sweep) {
    measure(*sweep);
    undecided = false;
    for (std::size_t c = 0; c < parts.size(); ++c) {
      Part& part = parts[c];
      const double d = least[c];
      if (!part.decided && d <= reach && d <= part.least + lost) {
        part.list.push_back(*sweep);
        part.least = std::min(part.least, d);
        part.decided = d < -reach;
      }
      undecided = undecided || !part.decided;
    }
  }
}

}  // namespace mrsim
