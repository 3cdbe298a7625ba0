#include "removal/prune/list_candidates.h"

#include "removal/prune/slice_writer.h"

#include <bit>

namespace mrsim {

// Classes in the order of their groups, so that slices that may be compared follow one another.
void list_candidates(const SweepTable& table, std::span<const std::uint32_t> ids,
                     const Vec3& origin, CandidateList& out) {
  const SweepColumns& c = table.columns();
  const auto [sweeps, turned, packs] = c.numbers_of(ids);
  static thread_local SliceEntries entries;
  entries.clear();
  const bool one = c.class_of.empty() && packs.empty();
  for (std::size_t k = 0; !one && k < sweeps.size(); ++k)
    entries.push_back({c.class_index(sweeps[k]), sweeps[k], sweeps[k]});
  for (const std::uint32_t pack : packs)
    entries.push_back({c.packs[pack].class_index, pack, c.packs[pack].first});
  sort_by_class(entries, c.classes.size());
  std::size_t slots = ids.size();
  for (std::size_t k = 0; !c.first_segment.empty() && k < sweeps.size(); ++k)
    slots += c.segment_count(sweeps[k]);
  std::size_t slices = 2;
  for (std::size_t k = 1; k < entries.size(); ++k)
    slices += entries[k].class_index != entries[k - 1].class_index;
  out.reset(CandidateList::room(slots, slices), origin);
  SliceWriter writer(out, c);
  if (one && !sweeps.empty()) {
    writer.begin(0);
    for (const std::uint32_t sweep : sweeps) writer.add(sweep);
    writer.close();
  }
  for (auto at = entries.cbegin(); at != entries.cend();) at = writer.slice(at, entries.cend());
  out.extent = writer.extent();
  if (turned.empty()) return;
  out.closed = false;  // a pack costs several sweeps
  const std::size_t first = out.begin_slice(static_cast<std::uint32_t>(c.classes.size() - 1));
  for (std::size_t k = 0; k < turned.size(); ++k)
    out.column(kIdColumn)[first + k] = std::bit_cast<float>(turned[k]);
  out.close_slice(turned.size());
}

void least_distances(const SweepTable& table, const CandidateList& list, PointColumns& points) {
  static thread_local std::vector<std::uint32_t> ids;
  ids.clear();
  for (const CandidateList::Slice& slice : list.slices())
    for (std::size_t k = 0; k < slice.count; ++k)
      table.columns().append_sweeps(list.number(slice, k), ids);
  table.least(ids, points);
}

}  // namespace mrsim
