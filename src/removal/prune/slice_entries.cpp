#include "removal/prune/slice_entries.h"

#include <algorithm>

namespace mrsim {
namespace {

bool is_less(const SliceEntry& a, const SliceEntry& b) {
  return a.class_index != b.class_index ? a.class_index < b.class_index : a.first < b.first;
}

}  // namespace

// Merge sort: stretches that are sorted already are merged two by two.
void sort_by_class(SliceEntries& entries) {
  static thread_local SliceEntries merged;
  static thread_local std::vector<std::size_t> ends;
  ends.assign(1, 0);
  for (std::size_t k = 1; k < entries.size(); ++k)
    if (is_less(entries[k], entries[k - 1])) ends.push_back(k);
  ends.push_back(entries.size());
  while (ends.size() > 2) {
    merged.resize(entries.size());
    std::size_t left = 1;
    const auto at = [&](std::size_t k) { return entries.begin() + std::ptrdiff_t(ends[k]); };
    auto to = merged.begin();
    for (std::size_t k = 0; k + 1 < ends.size(); k += 2) {
      const std::size_t last = std::min(k + 2, ends.size() - 1);
      to = std::merge(at(k), at(k + 1), at(k + 1), at(last), to, is_less);
      ends[left++] = ends[last];
    }
    ends.resize(left);
    entries.swap(merged);
  }
}

void sort_by_class(SliceEntries& entries, std::size_t classes) {
  static thread_local SliceEntries sorted;
  static thread_local std::vector<std::size_t> begins;
  begins.assign(classes + 1, 0);
  for (const SliceEntry& e : entries) ++begins[e.class_index + 1];
  for (std::size_t k = 1; k < begins.size(); ++k) begins[k] += begins[k - 1];
  sorted.resize(entries.size());
  for (const SliceEntry& e : entries) sorted[begins[e.class_index]++] = e;
  entries.swap(sorted);
}

}  // namespace mrsim
