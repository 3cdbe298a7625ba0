#include "removal/columns/run_chords.h"

#include "core/numbers/rounding.h"
#include "core/numbers/vec.h"
#include "removal/columns/sweep_columns.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace mrsim {
namespace {

constexpr double kPairSpread = 1.0 / 16;  // largest spread of the chord of two packs of length 1
constexpr double kUprightChord = 1e-3;    // in plan: shorter chords of length 1 have no direction

// The path along the chord of a pack, from its lower end.
ToolPath path_along(const LineRecord& segment) {
  const double* r = segment.c;
  ToolPath path;
  path.start = {r[BallSlot::x], r[BallSlot::y], r[BallSlot::z]};
  path.travel = r[BallSlot::length] * Vec3{r[BallSlot::ux], r[BallSlot::uy], r[BallSlot::slope]};
  return path;
}

double spread_of(const SweepColumns& c, std::uint32_t pack) {
  const double plan = c.packs[pack].spread, up = c.packs.chord(pack).c[BallSlot::error];
  return std::sqrt(plan * plan + up * up);
}

// The run of two packs of one tool, where the second follows the first; none where that is not so.
std::optional<RunChords::Run> run_of_pair(const SweepColumns& c, std::uint32_t a, std::uint32_t b) {
  const auto line_of = [&](std::uint32_t sweep) -> const PathColumn::Line& {
    return c.paths.line(c.refs[sweep].row);
  };
  const Vec3 middle = line_of(c.packs[b].first).start;
  ToolPath path;
  path.start = line_of(c.packs[a].first).start;
  path.travel = line_of(c.packs[b].last).end() - path.start;
  const Vec3 &way = path.travel, off = middle - path.start;
  const double square = dot(way, way);
  if (!(way.x * way.x + way.y * way.y > kUprightChord * kUprightChord * square))
    return std::nullopt;
  const Vec3 aside = off - std::clamp(dot(off, way) / square, 0.0, 1.0) * way;
  RunChords::Run run{c.packs[a].first, c.packs[b].last};
  run.spread = length(aside) + std::max(spread_of(c, a), spread_of(c, b)) + kRounding;
  if (run.spread * run.spread > kPairSpread * kPairSpread * square) return std::nullopt;
  run.chord = chain_line(c.chain_tools[c.refs[run.first].shape], path);
  return run;
}

}  // namespace

RunChords::RunChords(const SweepColumns& c) {
  if (c.chain_lines.empty() || c.packs.size() == 0) return;
  run_of_.assign(c.refs.size(), kNone);
  const auto is_run = [&](std::uint32_t pack) {
    return c.packs[pack].count == 0 && c.is_chain(c.refs[c.packs[pack].first]);
  };
  const auto add = [&](std::uint32_t pack) {
    const SweepPack& p = c.packs[pack];
    Run run{p.first, p.last, spread_of(c, pack) + kRounding};
    run.chord = chain_line(c.chain_tools[c.refs[p.first].shape], path_along(c.packs.chord(pack)));
    std::fill(run_of_.begin() + p.first, run_of_.begin() + p.last + 1,
              static_cast<std::uint32_t>(runs_.size()));
    runs_.push_back(run);
  };
  const auto end = kFirstPack + static_cast<std::uint32_t>(c.packs.size());
  for (std::uint32_t pack = kFirstPack; pack < end; ++pack) {
    if (!is_run(pack)) continue;
    add(pack);
    const std::uint32_t next = pack + 1;
    if (next == end || !is_run(next) || c.packs[next].first != c.packs[pack].last + 1 ||
        c.refs[c.packs[next].first].shape != c.refs[c.packs[pack].first].shape)
      continue;
    if (const std::optional<Run> both = run_of_pair(c, pack, next)) {
      runs_.back().pair = true;
      runs_.push_back(*both);
      add(next);
      ++pack;
    }
  }
}

}  // namespace mrsim
