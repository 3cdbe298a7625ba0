#include "removal/sweep/move_runs.h"

#include "core/numbers/rounding.h"
#include "removal/simd/sweep_kernels.h"

#include <algorithm>
#include <cmath>

namespace mrsim {
namespace {

// The tool of a sweep that is a straight move with a record; -1 for other sweeps.
std::int32_t tool_of(const SweepColumns& c, std::uint32_t sweep) {
  const std::uint32_t tag = c.tags[sweep];
  return is_other(tag) && single_form(tag) == SingleForm::chain ? c.refs[sweep].shape : -1;
}

const ChainLine& line_of(const SweepColumns& c, std::uint32_t sweep) {
  return c.chain_lines[c.tags[sweep] & kSingleRow];
}

}  // namespace

void MoveRuns::prepare(const SweepColumns& c, std::span<const std::uint32_t> list) {
  if (table_ == c.serial && std::ranges::equal(list, list_)) return;
  table_ = c.serial;
  list_.assign(list.begin(), list.end());
  runs_.clear(), groups_.clear(), chords_.clear();
  const auto n = static_cast<std::uint32_t>(list.size());
  for (std::uint32_t first = 0, end = 0; first < n; first = end) {
    Group group{tool_of(c, list[first]), static_cast<std::uint32_t>(runs_.size())};
    group.chord = static_cast<std::uint32_t>(chords_.size());
    while (++end < n && tool_of(c, list[end]) == group.tool) {
    }
    if (group.tool < 0)
      runs_.push_back({first, end - first});
    else
      add_moves(c, first, end);
    group.end = static_cast<std::uint32_t>(runs_.size());
    for (std::uint32_t k = group.first; k < group.end; ++k)
      group.spread = std::max(group.spread, runs_[k].spread);
    groups_.push_back(group);
  }
  // A register may reach beyond the last run.
  bounds_.resize(runs_.size() + PointColumns::kPad);
  stride_ = chords_.size() + PointColumns::kPad;
  columns_.resize(ChainColumn::kCount * stride_);
  for (std::size_t k = 0; k < chords_.size(); ++k) {
    const ChainLine& m = chords_[k];
    double* to = columns_.data() + k;
    for (const double number : {m.x, m.y, m.z, m.ux, m.uy, m.plan, m.rise, m.per_plan, m.per_way})
      *to = number, to += stride_;
    for (const double tilt : m.tilt) *to = tilt, to += stride_;
  }
}

void MoveRuns::add_moves(const SweepColumns& c, std::uint32_t first, std::uint32_t end) {
  while (first < end) {
    const RunChords::Run* run = c.run_chords.of(list_[first]);
    std::uint32_t next = first + 1;
    const auto take = [&] {
      while (next < end && list_[next] <= run->last) ++next;
    };
    if (run != nullptr) {
      take();
      if (run->pair && next < end && list_[next] <= run[1].last) ++run, take();
    }
    if (next == first + 1) {
      runs_.push_back({first, 1});
      chords_.push_back(line_of(c, list_[first]));
    } else {
      runs_.push_back({first, next - first, run->spread});
      chords_.push_back(run->chord);
    }
    first = next;
  }
}

void MoveRuns::measure(const SweepColumns& c, const Vec3& p, double limit) {
  for (const Group& g : groups_) {
    double* out = bounds_.data() + g.first;
    if (g.tool < 0) {
      *out = -kInfinity;
      continue;
    }
    const std::size_t n = g.end - g.first;
    sweep_kernels().chain_bounds_beside(c.chain_tools[g.tool], {columns_.data() + g.chord, stride_},
                                        n, p, limit + g.spread, out);
    for (std::size_t k = 0; k < n; ++k) out[k] -= runs_[g.first + k].spread;
  }
}

std::optional<std::uint32_t> MoveRuns::promising() const {
  double least = kInfinity;
  std::optional<std::uint32_t> best;
  for (std::size_t k = 0; k < runs_.size(); ++k)
    if (bounds_[k] > -kInfinity && bounds_[k] < least) {
      least = bounds_[k];
      best = list_[runs_[k].first + runs_[k].count / 2];
    }
  return best;
}

std::span<const std::uint32_t> MoveRuns::within(double limit) {
  within_.clear();
  for (std::size_t k = 0; k < runs_.size(); ++k)
    if (bounds_[k] <= limit) {
      const auto from = list_.begin() + runs_[k].first;
      within_.insert(within_.end(), from, from + runs_[k].count);
    }
  return within_;
}

}  // namespace mrsim
