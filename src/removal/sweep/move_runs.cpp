#include "removal/sweep/move_runs.h"

#include "core/rounding.h"
#include "core/vec.h"
#include "removal/simd/sweep_kernels.h"

#include <algorithm>
#include <cmath>

namespace mrsim {
namespace {

constexpr std::uint32_t kMostMoves = 16;  // of a run
constexpr double kStraight = 1.0 / 16;    // largest spread of a chord of length 1
constexpr double kSteep = 1e-3;           // in plan: shorter chords of length 1 have no direction

// Of a straight move with a record; -1 for other sweeps.
std::int32_t tool_of(const SweepColumns& c, std::uint32_t sweep) {
  const std::uint32_t tag = c.tags[sweep];
  return is_other(tag) && single_form(tag) == SingleForm::chain ? c.refs[sweep].shape : -1;
}

const ChainLine& line_of(const SweepColumns& c, std::uint32_t sweep) {
  return c.chain_lines[c.tags[sweep] & kSingleRow];
}

double square_from(const Vec3& p, const Vec3& start, const Vec3& way, double per_square) {
  const Vec3 off = p - start;
  const Vec3 left = off - std::clamp(dot(off, way) * per_square, 0.0, 1.0) * way;
  return dot(left, left);
}

}  // namespace

void MoveRuns::prepare(const SweepColumns& c, std::span<const std::uint32_t> list) {
  if (table_ == c.serial && std::ranges::equal(list, list_)) return;
  table_ = c.serial;
  list_.assign(list.begin(), list.end());
  moves_.resize(list.size());
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
      add_moves(c, first, end - first);
    group.end = static_cast<std::uint32_t>(runs_.size());
    for (std::uint32_t k = group.first; k < group.end; ++k)
      group.spread = std::max(group.spread, runs_[k].spread);
    groups_.push_back(group);
  }
  // A register of results may reach beyond the last run.
  bounds_.resize(runs_.size() + PointColumns::kPad);
}

void MoveRuns::add_moves(const SweepColumns& c, std::uint32_t first, std::uint32_t count) {
  for (std::uint32_t k = first; k < first + count; ++k) {
    const ChainLine& line = line_of(c, list_[k]);
    const Vec3 start{line.x, line.y, line.z};
    moves_[k] = {start, start + Vec3{line.plan * line.ux, line.plan * line.uy, line.rise}};
  }
  // As long as they are straight, by halves.
  const auto add = [&](const auto& self, std::uint32_t from, std::uint32_t n) -> void {
    if (add_run(c, from, n)) return;
    self(self, from, n / 2);
    self(self, from + n / 2, n - n / 2);
  };
  for (std::uint32_t k = 0; k < count; k += kMostMoves)
    add(add, first + k, std::min(kMostMoves, count - k));
}

bool MoveRuns::add_run(const SweepColumns& c, std::uint32_t first, std::uint32_t count) {
  if (count == 1) {
    runs_.push_back({first, 1});
    chords_.push_back(line_of(c, list_[first]));
    return true;
  }
  ToolPath chord;
  chord.start = moves_[first].start;
  chord.travel = moves_[first + count - 1].end - chord.start;
  const Vec3& way = chord.travel;
  const double plan = way.x * way.x + way.y * way.y, square = plan + way.z * way.z;
  if (!(plan > kSteep * kSteep * square)) return false;
  double spread = 0;
  for (std::uint32_t k = first; k < first + count; ++k)
    for (const Vec3& end : {moves_[k].start, moves_[k].end})
      spread = std::max(spread, square_from(end, chord.start, way, 1 / square));
  if (spread > kStraight * kStraight * square) return false;
  runs_.push_back({first, count, std::sqrt(spread) + kRounding});
  chords_.push_back(chain_line(c.chain_tools[c.refs[list_[first]].shape], chord));
  return true;
}

void MoveRuns::measure(const SweepColumns& c, const Vec3& p, double limit) {
  static thread_local std::vector<std::uint32_t> rows;
  for (auto k = static_cast<std::uint32_t>(rows.size()); k < runs_.size(); ++k) rows.push_back(k);
  for (const Group& g : groups_) {
    double* out = bounds_.data() + g.first;
    if (g.tool < 0) {
      *out = -kInfinity;
      continue;
    }
    const std::size_t n = g.end - g.first;
    sweep_kernels().chain_bounds(c.chain_tools[g.tool], chords_.data() + g.chord, rows.data(), n, p,
                                 limit + g.spread, out);
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
