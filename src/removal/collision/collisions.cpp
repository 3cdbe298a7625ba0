#include "removal/collision/collisions.h"

#include "core/numbers/motions.h"
#include "core/numbers/vec.h"
#include "core/process/error.h"
#include "core/process/parallel.h"
#include "removal/collision/collision_depth.h"
#include "removal/collision/collision_probe.h"
#include "removal/collision/collision_search.h"
#include "removal/collision/collision_volume.h"
#include "removal/collision/withdrawals.h"
#include "removal/field/lattice.h"
#include "removal/forms/sweep_motion.h"
#include "removal/part/stock_grid.h"
#include "removal/tool/assumed_shank.h"

#include <algorithm>
#include <atomic>
#include <map>
#include <mutex>
#include <numeric>
#include <tuple>

namespace mrsim {
namespace {

constexpr std::array<ToolPart, 3> kParts{ToolPart::cutter, ToolPart::shank, ToolPart::holder};

// The boxes of the search end at this share of a voxel.
constexpr double kFinest = 1.0 / 16;

// Colliding motions of one line that are measured; the deepest of them is reported.
constexpr std::size_t kMostMeasured = 16;

// Lines of which the deepest are chosen, by the places where they were found: to measure a line
// takes a hundred times as long. The lines after these are only counted.
constexpr std::size_t kMostRanked = 200;

// Rapids of one line that may be withdrawals and are measured; the others count as collisions.
constexpr std::size_t kMostWithdrawals = 1000;

class Check {
 public:
  Check(const StockGrid& grid, std::span<const Motion> motions, std::span<const Tool> tools,
        const CollisionOptions& options)
      : grid_(grid),
        motions_(motions),
        tools_(tools),
        options_(options),
        withdrawals_(motions, tools) {}

  CollisionReport run(std::size_t first);

 private:
  struct Hit {
    std::int32_t motion;
    std::size_t part;
    CollisionHit hit;
  };
  using Line = std::tuple<int, int, std::size_t>;  // file, line, part

  CollisionScene scene(std::size_t part) const;
  void find_turned();
  void detect(std::size_t part, std::vector<Hit>& hits);
  Box3 search_box(const Box3& box, const Box3& bounds) const;
  std::vector<std::vector<Hit>> by_line(const std::vector<Hit>& hits) const;
  Collision measure(const std::vector<Hit>& hits) const;
  double volume(const Collision& found, const std::vector<Hit>& hits) const;
  std::vector<std::size_t> deepest_lines(const std::vector<std::vector<Hit>>& lines) const;
  void report_lines(const std::vector<std::vector<Hit>>& lines, CollisionReport& report) const;
  void take_withdrawals(std::vector<std::vector<Hit>>& lines, CollisionReport& report);
  void step(std::size_t total);

  const StockGrid& grid_;
  std::span<const Motion> motions_;
  std::span<const Tool> tools_;
  const CollisionOptions& options_;
  Withdrawals withdrawals_;
  std::vector<Movers> movers_;  // by part
  bool turned_ = false;         // the same at every angle: one half plane says it all
  std::atomic<std::size_t> blocks_{0};
  std::mutex mutex_;
};

CollisionScene Check::scene(std::size_t part) const {
  return {*grid_.field,
          *grid_.index,
          movers_[part],
          options_.depth,
          std::max(0.5 * options_.depth, kFinest * grid_.voxel),
          kBandVoxels * grid_.voxel,
          turned_};
}

// Turning tools, and others along the bar's axis: drills of a lathe.
void Check::find_turned() {
  const auto is_round = [&](const Motion& m) {
    return m.tool < 0 || is_turning(tools_[static_cast<std::size_t>(m.tool)].type) ||
           runs_on_axis(m);
  };
  const auto may_move = [&](const Movers& movers) {
    return std::all_of(movers.motions.begin(), movers.motions.end(), [&](std::int32_t i) {
      return is_round(motions_[static_cast<std::size_t>(i)]);
    });
  };
  turned_ = grid_.field->solid().is_turned() &&
            std::all_of(motions_.begin(), motions_.end(),
                        [&](const Motion& m) { return !is_cut(m) || is_round(m); }) &&
            std::all_of(movers_.begin(), movers_.end(), may_move);
}

Box3 Check::search_box(const Box3& box, const Box3& bounds) const {
  const Box3& stock = grid_.field->solid().bounds();
  Box3 b{max(max(box.lo, bounds.lo), stock.lo), min(min(box.hi, bounds.hi), stock.hi)};
  if (!turned_ || b.lo.y > 0 || b.hi.y < 0) return turned_ ? Box3{} : b;
  b.lo.y = b.hi.y = 0;
  b.lo.x = std::max(b.lo.x, 0.0);
  return b;
}

void Check::step(std::size_t total) {
  const std::size_t done = ++blocks_;
  if (!options_.progress || done % 16 != 0) return;
  const std::scoped_lock lock(mutex_);
  if (!options_.progress("collisions", static_cast<double>(done) / static_cast<double>(total)))
    throw Error("cancelled", "the run was stopped");
}

// One hit for each mover: the probe's, else that of its first block.
void Check::detect(std::size_t part, std::vector<Hit>& hits) {
  const Movers& movers = movers_[part];
  if (movers.motions.empty()) return;
  const CollisionScene scene = this->scene(part);
  std::vector<char> known(movers.motions.size(), 0);
  const auto add = [&](const CollisionHit& hit) {
    if (known[hit.mover] == 0) hits.push_back({movers.motions[hit.mover], part, hit});
    known[hit.mover] = 1;
  };
  const auto box_of = [&](std::uint32_t mover) {
    const Box3 bounds = movers.sweeps.bounds(mover);
    return search_box(bounds, bounds);
  };
  for (const CollisionHit& hit : probe_movers(scene, scene.beside, box_of, options_.threads))
    add(hit);
  if (std::find(known.begin(), known.end(), 0) == known.end()) return;
  const BlockIndex index(*grid_.index, movers.sweeps);
  std::vector<std::vector<CollisionHit>> found(index.size());
  blocks_ = 0;
  parallel_for(index.size(), options_.threads, [&](std::size_t b) {
    Candidates here;
    for (const std::uint32_t mover : index.sweeps(b))
      if (known[mover] == 0) here.push_back(mover);
    Box3 bounds;
    for (const std::uint32_t mover : here) extend(bounds, movers.sweeps.bounds(mover));
    const Box3 box = here.empty() ? Box3{} : search_box(index.box(b), bounds);
    if (!is_empty(box)) {
      const Box3 around = inflated(index.box(b), scene.beside);
      found[b] = CollisionDetector(scene).detect(
          box, grid_.field->sweeps().meeting(grid_.index->sweeps(b), around), here);
    }
    step(index.size());
  });
  for (const std::vector<CollisionHit>& block : found)
    for (const CollisionHit& hit : block) add(hit);
}

// Hits by line of the program, lines in the order of their first motions; the hits of one line are
// sorted by motion.
std::vector<std::vector<Check::Hit>> Check::by_line(const std::vector<Hit>& hits) const {
  std::vector<std::vector<Hit>> lines;
  std::map<Line, std::size_t> known;
  for (const Hit& hit : hits) {
    const Motion& m = motions_[static_cast<std::size_t>(hit.motion)];
    const auto [at, added] = known.try_emplace({m.file, m.line, hit.part}, lines.size());
    if (added) lines.emplace_back();
    lines[at->second].push_back(hit);
  }
  return lines;
}

Collision Check::measure(const std::vector<Hit>& hits) const {
  Collision worst;
  worst.motions = 0;
  std::int32_t last = -1;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    worst.motions += hits[i].motion != last;  // a shank of two pieces counts once
    last = hits[i].motion;
    if (i >= kMostMeasured) continue;
    const std::size_t part = hits[i].part;
    const Box3 bounds = movers_[part].sweeps.bounds(hits[i].hit.mover);
    const DeepPoint deep = deepest_point(scene(part), hits[i].hit, search_box(bounds, bounds));
    if (deep.depth <= worst.depth) continue;
    worst.motion = static_cast<std::size_t>(hits[i].motion);
    worst.part = kParts[part];
    worst.depth = deep.depth;
    worst.place = deep.place;
  }
  return worst;
}

// The volume that all bodies of the tool's part (a shank has two) cut on that motion.
double Check::volume(const Collision& found, const std::vector<Hit>& hits) const {
  std::vector<std::uint32_t> movers;
  Box3 bounds;
  const std::size_t part = hits.front().part;
  for (const Hit& hit : hits) {
    if (static_cast<std::size_t>(hit.motion) != found.motion) continue;
    movers.push_back(hit.hit.mover);
    extend(bounds, movers_[part].sweeps.bounds(hit.hit.mover));
  }
  return met_volume(scene(part), movers, search_box(bounds, bounds));
}

// The lines to be listed, in the order of the program.
std::vector<std::size_t> Check::deepest_lines(const std::vector<std::vector<Hit>>& lines) const {
  std::vector<double> depth(std::min(lines.size(), std::max(options_.lines, kMostRanked)));
  std::vector<std::size_t> order(depth.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  if (order.size() <= options_.lines) return order;
  parallel_for(depth.size(), options_.threads, [&](std::size_t i) {
    for (std::size_t h = 0; h < std::min(lines[i].size(), kMostMeasured); ++h)
      depth[i] = std::max(depth[i], depth_of_hit(scene(lines[i][h].part), lines[i][h].hit));
  });
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return depth[a] > depth[b]; });
  order.resize(options_.lines);
  std::sort(order.begin(), order.end());
  return order;
}

void Check::report_lines(const std::vector<std::vector<Hit>>& lines,
                         CollisionReport& report) const {
  const std::vector<std::size_t> listed = deepest_lines(lines);
  report.lines.resize(listed.size());
  report.more = lines.size() - listed.size();
  parallel_for(listed.size(), options_.threads, [&](std::size_t i) {
    report.lines[i] = measure(lines[listed[i]]);
    report.lines[i].volume = volume(report.lines[i], lines[listed[i]]);
  });
}

// Removes hits of rapids that only withdraw an insert, then lines that have no hits left.
void Check::take_withdrawals(std::vector<std::vector<Hit>>& lines, CollisionReport& report) {
  const auto at = [](const Hit& hit) { return static_cast<std::size_t>(hit.motion); };
  std::vector<std::pair<std::size_t, std::size_t>> asked;  // line, and hit of that
  for (std::size_t l = 0; l < lines.size(); ++l)
    for (std::size_t h = 0; h < std::min(lines[l].size(), kMostWithdrawals); ++h)
      if (kParts[lines[l][h].part] == ToolPart::cutter && withdrawals_.follows_cut(at(lines[l][h])))
        asked.emplace_back(l, h);
  std::vector<Collision> found(asked.size());
  parallel_for(asked.size(), options_.threads, [&](std::size_t i) {
    found[i] = measure({lines[asked[i].first][asked[i].second]});
  });
  for (std::size_t i = asked.size(); i-- > 0;) {  // backwards: the places of hits stay
    const Collision& c = found[i];
    if (c.depth > kWithdrawalDepth || !withdrawals_.withdraws(c.motion, c.place, options_.depth))
      continue;
    std::vector<Hit>& line = lines[asked[i].first];
    line.erase(line.begin() + static_cast<std::ptrdiff_t>(asked[i].second));
    report.withdrawals.lines += line.empty();
    if (line.empty() && c.depth >= report.withdrawals.depth)
      report.withdrawals = {report.withdrawals.lines, c.motion, c.depth};
  }
  std::erase_if(lines, [](const std::vector<Hit>& line) { return line.empty(); });
}

CollisionReport Check::run(std::size_t first) {
  CollisionReport report;
  const Box3& stock = grid_.field->solid().bounds();
  for (const ToolPart part : kParts)
    movers_.push_back(find_movers(part, motions_, tools_, first, stock, options_.depth,
                                  options_.threads, report.shapeless));
  find_turned();
  std::vector<Hit> hits;
  for (std::size_t part = 0; part < kParts.size(); ++part) detect(part, hits);
  std::sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) {
    return std::tie(a.motion, a.part, a.hit.mover) < std::tie(b.motion, b.part, b.hit.mover);
  });
  std::vector<std::vector<Hit>> lines = by_line(hits);
  take_withdrawals(lines, report);
  report_lines(lines, report);
  return report;
}

}  // namespace

CollisionReport find_collisions(const Stock& stock, std::span<const Motion> motions,
                                std::span<const Tool> tools, std::size_t first,
                                const CollisionOptions& options) {
  if (!(options.depth >= 0.001))
    throw Error("option-invalid", "the depth of a collision is below 0.001 mm", Error::Kind::usage);
  const std::vector<Tool> complete = with_shanks(tools);
  return Check(stock.grid(), motions, complete, options).run(first);
}

}  // namespace mrsim
