#include "removal/prune/expand_packs.h"

#include "core/process/heap.h"
#include "removal/prune/slice_writer.h"

#include <algorithm>

namespace mrsim {
namespace {

void copy_slice(const CandidateList& in, const CandidateList::Slice& slice, CandidateList& out) {
  const std::size_t first = out.begin_slice(slice.class_index, slice.numbers);
  for (std::size_t i = 0; i < kCandidateColumns; ++i)
    std::copy_n(in.column(i) + slice.first, slice.count, out.column(i) + first);
  out.close_slice(slice.count);
}
// The entries k with wanted(k).
template <typename Wanted>
void copy_some(const CandidateList& in, const CandidateList::Slice& slice, CandidateList& out,
               Wanted wanted) {
  const std::size_t first = out.begin_slice(slice.class_index, slice.numbers);
  std::size_t count = 0;
  for (std::size_t k = 0; k < slice.count; ++k) {
    if (!wanted(k)) continue;
    for (std::size_t i = 0; i < kCandidateColumns; ++i)
      out.column(i)[first + count] = in.column(i)[slice.first + k];
    ++count;
  }
  out.close_slice(count);
}

// Puts children in place of the packs of a list that are large beside a region.
class PackExpander {
 public:
  PackExpander(const SweepColumns& columns, const PruneRegion& region, bool by_heights)
      : c_(columns), region_(region), by_heights_(by_heights), expanded_(scratch()) {
    expanded_.clear();
  }

  // False where there is no such pack.
  bool find(const CandidateList& in) {
    room_ = in.size();
    for (const CandidateList::Slice& slice : in.slices())
      for (std::size_t k = 0; k < slice.count && may_be_large(slice); ++k) {
        prefetch(c_.packs[in.number(slice, std::min(k + kEntriesAhead, slice.count - 1))]);
        if (const std::uint32_t number = in.number(slice, k); is_large(number)) append(number);
      }
    sort_by_class(expanded_);
    return !expanded_.empty();
  }

  // Children come after all slices of their group, so that the group stays together.
  void write(const CandidateList& in, CandidateList& out) const {
    const auto& slices = in.slices();
    out.reset(CandidateList::room(room_, slices.size() + c_.classes.size()), in.origin);
    out.closed = in.closed;
    SliceWriter writer(out, c_);
    auto next = expanded_.cbegin();
    for (std::size_t i = 0; i < slices.size(); ++i) {
      if (!may_be_large(slices[i]))
        copy_slice(in, slices[i], out);
      else if (!region_.expand_packs)
        copy_some(in, slices[i], out,
                  [&](std::size_t k) { return !is_large(in.number(slices[i], k)); });
      const std::int32_t group = c_.classes[slices[i].class_index].group;
      if (i + 1 < slices.size() && c_.classes[slices[i + 1].class_index].group == group) continue;
      while (next != expanded_.cend() && c_.classes[next->class_index].group == group)
        next = writer.slice(next, expanded_.cend());
    }
    // The chords of the packs lie within the extent, their children within the spread of these.
    out.extent = std::max(in.extent + writer.spread(), writer.extent());
  }

 private:
  static SliceEntries& scratch() {
    static thread_local SliceEntries entries;  // static: its memory serves all lists
    return entries;
  }
  bool is_large(std::uint32_t pack) const {
    return region_.expand_packs || region_.radius < c_.packs[pack].expand_below ||
           !is_measured(c_.classes[c_.packs[pack].class_index]);
  }
  bool may_be_large(const CandidateList::Slice& slice) const {
    const SweepClass& type = c_.classes[slice.class_index];
    return type.packs &&
           (region_.expand_packs || region_.radius < type.expand_below || !is_measured(type));
  }
  // Packs of paths have heights, but no distances.
  bool is_measured(const SweepClass& type) const {
    return by_heights_ || type.form != SweepClass::Form::segment;
  }

  // The children of a large pack, or theirs.
  void append(std::uint32_t number) {
    const SweepPack& pack = c_.packs[number];
    room_ += pack.size();
    if (pack.count == 0) {
      c_.packs.prefetch_children(number);
      return expanded_.push_back({c_.class_index(pack.first), number, pack.first, true});
    }
    bool alike = true;
    const std::uint32_t first = kFirstPack + pack.child;
    c_.packs.for_each_child(number, [&](std::uint32_t child) {
      alike =
          alike && !is_large(child) && c_.packs[child].class_index == c_.packs[first].class_index;
    });
    if (alike) return expanded_.push_back({c_.packs[first].class_index, number, pack.first, true});
    c_.packs.for_each_child(number, [&](std::uint32_t child) {
      if (is_large(child))
        append(child);
      else
        expanded_.push_back({c_.packs[child].class_index, child, c_.packs[child].first, false});
    });
  }

  const SweepColumns& c_;
  const PruneRegion& region_;
  bool by_heights_;
  SliceEntries& expanded_;
  std::size_t room_ = 0;
};

}  // namespace

bool expand_packs(const SweepTable& table, const PruneRegion& region, bool by_heights,
                  const CandidateList& in, CandidateList& out) {
  PackExpander expander(table.columns(), region, by_heights);
  if (!expander.find(in)) return false;
  expander.write(in, out);
  return true;
}

}  // namespace mrsim
