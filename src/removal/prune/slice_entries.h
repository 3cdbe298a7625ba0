// Sorts what a list of candidates is to hold into the order of its slices.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace mrsim {

/// An entry that a list is to hold. Lists ascend by class, and within a class by sweep if they can.
/// A list that is evaluated at points must ascend by sweep, so it may be sorted again.
struct SliceEntry {
  std::uint32_t class_index = 0;  ///< into SweepColumns::classes
  std::uint32_t number = 0;
  std::uint32_t first = 0;  ///< sweep
  bool children = false;    ///< the pack stands for its children
};
using SliceEntries = std::vector<SliceEntry>;
/// Sorts by merging: each sequence that was appended to the entries ascends already.
void sort_by_class(SliceEntries& entries);
/// sort_by_class() for entries that already ascend within each class.
void sort_by_class(SliceEntries& entries, std::size_t classes);

}  // namespace mrsim
