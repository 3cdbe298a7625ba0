// Writes the slices of a list of candidates from the columns of a table.
#pragma once

#include "core/process/heap.h"
#include "removal/columns/sweep_columns.h"
#include "removal/prune/candidate_list.h"
#include "removal/prune/slice_entries.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace mrsim {

inline constexpr std::size_t kEntriesAhead = 8;  ///< entries, to ask for memory in time

/// Writes entries of a list; keeps track of the largest value.
class SliceWriter {
 public:
  SliceWriter(CandidateList& list, const SweepColumns& columns)
      : list_(list), columns_(columns), origin_(list.origin), stride_(list.stride()) {}

  // The slice of all entries of the first one's class; what comes after it.
  SliceEntries::const_iterator slice(SliceEntries::const_iterator at,
                                     SliceEntries::const_iterator end) {
    const std::uint32_t class_index = at->class_index;
    begin(class_index);
    for (; at != end && at->class_index == class_index; ++at) {
      if (const auto ahead = at + std::min<std::ptrdiff_t>(kEntriesAhead, end - at - 1);
          !ahead->children)
        ask_for(ahead->number);
      at->children ? add_children_of(at->number) : add(at->number);
    }
    close();
    return at;
  }
  void begin(std::uint32_t class_index) {
    const SweepClass& type = columns_.classes[class_index];
    form_ = type.form;
    first_ = slot_ = list_.begin_slice(class_index, type.packs ? kPackColumn : kIdColumn);
    to_ = list_.column(0);
    const bool segment = form_ == SweepClass::Form::segment;
    list_.closed = list_.closed && form_ != SweepClass::Form::other && !segment;
    const ToolColumns& t = type.tool;
    for (const float size : {t.core + t.round, std::isinf(t.height) ? 0 : t.height})
      extent_ = std::max<double>(extent_, size);
    for (const float size : {type.heights.radius, type.heights.lift, type.heights.top})
      if (segment && !std::isinf(size)) extent_ = std::max<double>(extent_, size);
  }
  void close() { list_.close_slice(slot_ - first_); }

  // A sweep, or a pack.
  void add(std::uint32_t number) {
    if (number >= kFirstPack) return add_pack(number);
    if (form_ == SweepClass::Form::segment) return add_segments(number);
    const std::uint32_t row = columns_.row_of(number);
    if (form_ == SweepClass::Form::strip) widen_strip(columns_.ball_lines[row].c);
    if (form_ == SweepClass::Form::line) widen_line(columns_.plane_lines[row].c);
    add_sweep(number, row);
  }
  // The children of a pack, all of the class of this slice: their paths are near its chord.
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
    if (form_ == SweepClass::Form::segment)
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
  void add_segments(std::uint32_t id) {
    for (std::uint32_t k = columns_.first_segment[id]; k < columns_.first_segment[id + 1]; ++k) {
      segment(columns_.segments[k].c);
      put(kIdColumn, id);
      ++slot_;
    }
  }
  void add_pack(std::uint32_t number) {
    const std::uint32_t first = columns_.packs[number].first;
    const double* chord = columns_.packs.chord(number).c;
    if (form_ == SweepClass::Form::segment)
      segment(chord);
    else if (form_ == SweepClass::Form::strip)
      widen_strip(chord), strip(chord);
    else
      widen_line(chord), line(chord, first);
    put(kPackColumn, number);
    put(kIdColumn, first);
    ++slot_;
  }

  void segment(const double* c) {
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
         1 / std::max(c[LineSlot::dx] * c[LineSlot::dx] + c[LineSlot::dy] * c[LineSlot::dy],
                      kLeastSquare),
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
  // Writes the numbers of PackColumns::kLanes entries, or of as many as there are.
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

}  // namespace mrsim
