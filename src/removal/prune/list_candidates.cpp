#include "removal/prune/list_candidates.h"

#include "core/heap.h"
#include "removal/columns/sweep_columns.h"

#include <algorithm>
#include <cmath>

namespace mrsim {
namespace {

// What a list is to hold. Runs ascend by class, and by sweep where they can: what is asked for
// points must, or has to be sorted again.
struct Entry {
  std::uint32_t of = 0;  ///< class
  std::uint32_t number = 0;
  std::uint32_t first = 0;  ///< sweep
  bool children = false;    ///< those of the pack, not itself
};
using ByClass = std::vector<Entry>;
bool is_less(const Entry& a, const Entry& b) {
  return a.of != b.of ? a.of < b.of : a.first < b.first;
}
// Merges stretches that ascend, two by two: those of the runs that the entries came from.
void sort_by_class(ByClass& entries) {
  static thread_local ByClass merged;
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

constexpr std::size_t kAhead = 8;  // entries, to ask for memory in time

// The same where entries ascend but for their classes.
void sort_by_class(ByClass& entries, std::size_t classes) {
  static thread_local ByClass sorted;
  static thread_local std::vector<std::size_t> places;
  places.assign(classes + 1, 0);
  for (const Entry& e : entries) ++places[e.of + 1];
  for (std::size_t of = 1; of < places.size(); ++of) places[of] += places[of - 1];
  sorted.resize(entries.size());
  for (const Entry& e : entries) sorted[places[e.of]++] = e;
  entries.swap(sorted);
}

// Writes entries of a list; keeps track of the largest value.
class RunWriter {
 public:
  RunWriter(CandidateList& list, const SweepColumns& columns)
      : list_(list), columns_(columns), origin_(list.origin), stride_(list.stride()) {}

  // The run of all entries of the first one's class; what comes after it.
  ByClass::const_iterator run(ByClass::const_iterator at, ByClass::const_iterator end) {
    const std::uint32_t of = at->of;
    begin(of);
    for (; at != end && at->of == of; ++at) {
      if (const auto ahead = at + std::min<std::ptrdiff_t>(kAhead, end - at - 1); !ahead->children)
        ask_for(ahead->number);
      if (at->children)
        add_children_of(at->number);
      else
        add(at->number);
    }
    close();
    return at;
  }
  void begin(std::uint32_t of) {
    const SweepClass& type = columns_.classes[of];
    form_ = type.form;
    first_ = slot_ = list_.begin_run(of, type.packs ? kPackColumn : kIdColumn);
    to_ = list_.column(0);
    const bool piece = form_ == SweepClass::Form::piece;
    list_.closed = list_.closed && form_ != SweepClass::Form::other && !piece;
    const ToolColumns& t = type.tool;
    for (const float size : {t.core + t.round, std::isinf(t.height) ? 0 : t.height})
      extent_ = std::max<double>(extent_, size);
    for (const float size : {type.heights.radius, type.heights.lift, type.heights.top})
      if (piece && !std::isinf(size)) extent_ = std::max<double>(extent_, size);
  }
  void close() { list_.close_run(slot_ - first_); }

  // A sweep, or a pack.
  void add(std::uint32_t number) {
    if (number >= kFirstPack) return add_pack(number);
    if (form_ == SweepClass::Form::piece) return add_pieces(number);
    const std::uint32_t row = columns_.row_of(number);
    if (form_ == SweepClass::Form::strip) widen_strip(columns_.ball_lines[row].c);
    if (form_ == SweepClass::Form::line) widen_line(columns_.plane_lines[row].c);
    add_sweep(number, row);
  }
  // The children of a pack, all of the class of this run: their paths are near its chord.
  void add_children_of(std::uint32_t number) {
    constexpr std::size_t kLanes = PackColumns::kLanes;
    const SweepPack& pack = columns_.packs[number];
    const PackColumns& children = columns_.packs.children(number);
    const double* chord = columns_.packs.chord(number).c;
    float common[PackColumns::kColumns] = {static_cast<float>(chord[BallSlot::x] - origin_.x),
                                           static_cast<float>(chord[BallSlot::y] - origin_.y)};
    if (form_ != SweepClass::Form::line) {
      common[StripColumn::z] = static_cast<float>(chord[BallSlot::z] - origin_.z);
    } else {
      common[LineColumn::z] =
          static_cast<float>(chord[LineSlot::low] - chord[LineSlot::round] - origin_.z);
      common[LineColumn::height_number] = static_cast<float>(height_number_of(pack.first));
    }
    spread_ = std::max<double>(spread_, pack.spread);
    if (form_ == SweepClass::Form::piece)
      spread_ = std::max(spread_, pack.spread + chord[BallSlot::error]);
    for (std::size_t i = 0; i < PackColumns::kColumns; ++i) {
      float sums[kLanes];  // in registers
      for (std::size_t k = 0; k < kLanes; ++k) sums[k] = children.c[i][k] + common[i];
      std::copy_n(sums, kLanes, to_ + i * stride_ + slot_);
    }
    if (pack.count == 0)
      put_numbers(kIdColumn, pack.first);
    else
      put_numbers(kPackColumn, kFirstPack + pack.child);
    for (std::uint32_t k = 0; k < pack.count; ++k)
      to_[kIdColumn * stride_ + slot_ + k] =
          std::bit_cast<float>(columns_.packs[kFirstPack + pack.child + k].first);
    slot_ += pack.size();
  }
  double extent() const { return extent_; }
  /// The largest of the packs whose children have been added, mm.
  double spread() const { return spread_; }

 private:
  void ask_for(std::uint32_t number) const {
    if (number >= kFirstPack) prefetch(columns_.packs.chord(number));
  }
  void add_sweep(std::uint32_t id, std::uint32_t row) {
    if (form_ == SweepClass::Form::strip) strip(columns_.ball_lines[row].c);
    if (form_ == SweepClass::Form::line) line(columns_.plane_lines[row].c, id);
    if (form_ == SweepClass::Form::arc) arc(columns_.plane_arcs[row].c, id);
    put(kIdColumn, id);
    ++slot_;
  }
  void add_pieces(std::uint32_t id) {
    for (std::uint32_t k = columns_.first_piece[id]; k < columns_.first_piece[id + 1]; ++k) {
      piece(columns_.pieces[k].c);
      put(kIdColumn, id);
      ++slot_;
    }
  }
  void add_pack(std::uint32_t number) {
    const std::uint32_t first = columns_.packs[number].first;
    const double* chord = columns_.packs.chord(number).c;
    if (form_ == SweepClass::Form::piece)
      piece(chord);
    else if (form_ == SweepClass::Form::strip)
      widen_strip(chord), strip(chord);
    else
      widen_line(chord), line(chord, first);
    put(kPackColumn, number);
    put(kIdColumn, first);
    ++slot_;
  }

  void piece(const double* c) {
    put({c[BallSlot::x] - origin_.x, c[BallSlot::y] - origin_.y, c[BallSlot::z] - origin_.z,
         c[BallSlot::ux], c[BallSlot::uy], c[BallSlot::length], c[BallSlot::slope],
         c[BallSlot::error]});
    widen_strip(c);
  }
  void strip(const double* c) {
    const double s = c[BallSlot::slope];
    put({c[BallSlot::x] - origin_.x, c[BallSlot::y] - origin_.y, c[BallSlot::z] - origin_.z,
         c[BallSlot::ux], c[BallSlot::uy], c[BallSlot::length], s, 1 / (1 + s * s)});
  }
  void widen_strip(const double* c) {
    const double x = c[BallSlot::x] - origin_.x, y = c[BallSlot::y] - origin_.y,
                 z = c[BallSlot::z] - origin_.z;
    widen(x, y, z);
    widen(x + c[BallSlot::ux] * c[BallSlot::length], y + c[BallSlot::uy] * c[BallSlot::length],
          z + c[BallSlot::slope] * c[BallSlot::length]);
  }
  void line(const double* c, std::uint32_t id) {
    put({c[LineSlot::x] - origin_.x, c[LineSlot::y] - origin_.y, c[LineSlot::dx], c[LineSlot::dy],
         1 / std::max(c[LineSlot::dx] * c[LineSlot::dx] + c[LineSlot::dy] * c[LineSlot::dy], 1e-30),
         c[LineSlot::low] - c[LineSlot::round] - origin_.z, height_number_of(id)});
  }
  void widen_line(const double* c) {
    const double x = c[LineSlot::x] - origin_.x, y = c[LineSlot::y] - origin_.y,
                 z = c[LineSlot::low] - c[LineSlot::round] - origin_.z;
    widen(x, y, z);
    widen(x + c[LineSlot::dx], y + c[LineSlot::dy], z);
  }
  void arc(const double* c, std::uint32_t id) {
    const double x = c[ArcSlot::x] - origin_.x, y = c[ArcSlot::y] - origin_.y,
                 z = c[ArcSlot::low] - c[ArcSlot::round] - origin_.z;
    put({x, y, c[ArcSlot::radius], c[ArcSlot::mx], c[ArcSlot::my], c[ArcSlot::cosine],
         c[ArcSlot::sine], z, height_number_of(id)});
    widen(std::fabs(x) + c[ArcSlot::radius], std::fabs(y) + c[ArcSlot::radius], z);
  }

  double height_number_of(std::uint32_t id) const {
    return height_number(columns_.height_numbers[id]);
  }
  template <std::size_t N>
  void put(const double (&values)[N]) {
    float* to = to_ + slot_;
    for (std::size_t i = 0; i < N; ++i) to[i * stride_] = static_cast<float>(values[i]);
  }
  void put(std::size_t column, std::uint32_t number) {
    to_[column * stride_ + slot_] = std::bit_cast<float>(number);
  }
  // Of PackColumns::kLanes entries, as many as there are.
  void put_numbers(std::size_t column, std::uint32_t first) {
    float* to = to_ + column * stride_ + slot_;
    for (std::uint32_t k = 0; k < PackColumns::kLanes; ++k) to[k] = std::bit_cast<float>(first + k);
  }
  void widen(double x, double y, double z) {
    extent_ = std::max(extent_, std::max({std::fabs(x), std::fabs(y), std::fabs(z)}));
  }

  CandidateList& list_;
  const SweepColumns& columns_;
  const Vec3 origin_;
  const std::size_t stride_;
  float* to_ = nullptr;
  SweepClass::Form form_ = SweepClass::Form::other;
  std::size_t first_ = 0, slot_ = 0;
  double extent_ = 0;
  double spread_ = 0;
};

void copy_run(const CandidateList& in, const CandidateList::Run& run, CandidateList& out) {
  const std::size_t first = out.begin_run(run.of, run.numbers);
  for (std::size_t i = 0; i < kNearColumns; ++i)
    std::copy_n(in.column(i) + run.first, run.count, out.column(i) + first);
  out.close_run(run.count);
}
// The entries k with wanted(k).
template <typename Wanted>
void copy_some(const CandidateList& in, const CandidateList::Run& run, CandidateList& out,
               Wanted wanted) {
  const std::size_t first = out.begin_run(run.of, run.numbers);
  std::size_t count = 0;
  for (std::size_t k = 0; k < run.count; ++k) {
    if (!wanted(k)) continue;
    for (std::size_t i = 0; i < kNearColumns; ++i)
      out.column(i)[first + count] = in.column(i)[run.first + k];
    ++count;
  }
  out.close_run(count);
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
    for (const CandidateList::Run& run : in.runs())
      for (std::size_t k = 0; k < run.count && may_be_large(run); ++k) {
        prefetch(c_.packs[in.number(run, std::min(k + kAhead, run.count - 1))]);
        if (const std::uint32_t number = in.number(run, k); is_large(number)) append(number);
      }
    sort_by_class(expanded_);
    return !expanded_.empty();
  }

  // Children come after all runs of their group, so that the group stays together.
  void write(const CandidateList& in, CandidateList& out) const {
    const auto& runs = in.runs();
    out.reset(CandidateList::room(room_, runs.size() + c_.classes.size()), in.origin);
    out.closed = in.closed;
    RunWriter writer(out, c_);
    auto next = expanded_.cbegin();
    for (std::size_t i = 0; i < runs.size(); ++i) {
      if (!may_be_large(runs[i]))
        copy_run(in, runs[i], out);
      else if (!region_.expand_packs)
        copy_some(in, runs[i], out,
                  [&](std::size_t k) { return !is_large(in.number(runs[i], k)); });
      const std::int32_t group = c_.classes[runs[i].of].group;
      if (i + 1 < runs.size() && c_.classes[runs[i + 1].of].group == group) continue;
      while (next != expanded_.cend() && c_.classes[next->of].group == group)
        next = writer.run(next, expanded_.cend());
    }
    // The chords of the packs lie within the extent, their children within the spread of these.
    out.extent = std::max(in.extent + writer.spread(), writer.extent());
  }

 private:
  static ByClass& scratch() {
    static thread_local ByClass entries;  // its memory serves all lists
    return entries;
  }
  bool is_large(std::uint32_t pack) const {
    return region_.expand_packs || region_.radius < c_.packs[pack].expand_below ||
           !is_measured(c_.classes[c_.packs[pack].of]);
  }
  bool may_be_large(const CandidateList::Run& run) const {
    const SweepClass& type = c_.classes[run.of];
    return type.packs &&
           (region_.expand_packs || region_.radius < type.expand_below || !is_measured(type));
  }
  // Packs of paths have heights, but no distances.
  bool is_measured(const SweepClass& type) const {
    return by_heights_ || type.form != SweepClass::Form::piece;
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
      alike = alike && !is_large(child) && c_.packs[child].of == c_.packs[first].of;
    });
    if (alike) return expanded_.push_back({c_.packs[first].of, number, pack.first, true});
    c_.packs.for_each_child(number, [&](std::uint32_t child) {
      if (is_large(child))
        append(child);
      else
        expanded_.push_back({c_.packs[child].of, child, c_.packs[child].first, false});
    });
  }

  const SweepColumns& c_;
  const PruneRegion& region_;
  bool by_heights_;
  ByClass& expanded_;
  std::size_t room_ = 0;
};

}  // namespace

// Classes in the order of their groups, so that runs that may be compared follow one another.
void list_candidates(const SweepTable& table, std::span<const std::uint32_t> ids,
                     const Vec3& origin, CandidateList& out) {
  const SweepColumns& c = table.columns();
  const auto [sweeps, turned, packs] = c.numbers_of(ids);
  static thread_local ByClass entries;
  entries.clear();
  const bool one = c.class_of.empty() && packs.empty();
  for (std::size_t k = 0; !one && k < sweeps.size(); ++k)
    entries.push_back({c.class_index(sweeps[k]), sweeps[k], sweeps[k]});
  for (const std::uint32_t pack : packs)
    entries.push_back({c.packs[pack].of, pack, c.packs[pack].first});
  sort_by_class(entries, c.classes.size());
  std::size_t slots = ids.size();
  for (std::size_t k = 0; !c.first_piece.empty() && k < sweeps.size(); ++k)
    slots += c.piece_count(sweeps[k]);
  std::size_t runs = 2;
  for (std::size_t k = 1; k < entries.size(); ++k) runs += entries[k].of != entries[k - 1].of;
  out.reset(CandidateList::room(slots, runs), origin);
  RunWriter writer(out, c);
  if (one && !sweeps.empty()) {
    writer.begin(0);
    for (const std::uint32_t sweep : sweeps) writer.add(sweep);
    writer.close();
  }
  for (auto at = entries.cbegin(); at != entries.cend();) at = writer.run(at, entries.cend());
  out.extent = writer.extent();
  if (turned.empty()) return;
  out.closed = false;  // a pack costs several sweeps
  const std::size_t first = out.begin_run(static_cast<std::uint32_t>(c.classes.size() - 1));
  for (std::size_t k = 0; k < turned.size(); ++k)
    out.column(kIdColumn)[first + k] = std::bit_cast<float>(turned[k]);
  out.close_run(turned.size());
}

bool expand_packs(const SweepTable& table, const PruneRegion& region, bool by_heights,
                  const CandidateList& in, CandidateList& out) {
  PackExpander expander(table.columns(), region, by_heights);
  if (!expander.find(in)) return false;
  expander.write(in, out);
  return true;
}

void least_distances(const SweepTable& table, const CandidateList& list, PointColumns& points) {
  static thread_local std::vector<std::uint32_t> ids;
  ids.clear();
  for (const CandidateList::Run& run : list.runs())
    for (std::size_t k = 0; k < run.count; ++k)
      table.columns().append_sweeps(list.number(run, k), ids);
  table.least(ids, points);
}

}  // namespace mrsim
