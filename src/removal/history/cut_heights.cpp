#include "removal/history/cut_heights.h"

#include "core/numbers/vec.h"
#include "removal/field/lattice.h"
#include "removal/simd/sweep_kernels.h"
#include "removal/stock/stock_solid.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace mrsim {
namespace {

constexpr int kPartsEachWay = 4;  // parts of a square that are cut at once
// Shares of the depth of cut. A column in which heights differ by more is halved; where a file is
// written, sooner, because the middle of a column says little of the sharp valleys that V tools
// leave. Balls leave none.
constexpr double kSteepTip = 0.5, kSteepInFile = 0.125;
constexpr std::size_t kWorthRun = 3;   // sweeps that are worth a bound of all
constexpr std::size_t kFewSweeps = 6;  // whose walls are worth finer columns
// Where walls are met by lines: in a file the squares are smaller and the lists shorter.
constexpr std::size_t kMostOnLines = 24;
constexpr WallLines::Fineness kSummaryLines{4, 1.0 / 128}, kFileLines{1, 1.0 / 256};

template <class Visit>
void for_each_bit(std::uint32_t bits, const Visit& visit) {
  for (; bits != 0; bits &= bits - 1) visit(static_cast<std::size_t>(std::countr_zero(bits)));
}

}  // namespace

// A square in four rows of four.
struct HeightWalker::Parts {
  Vec2 side;
  PlanPoints points;
  std::uint32_t open = 0;  // within the stock, a bit each

  Vec2 center(std::size_t k) const { return {points.x[k], points.y[k]}; }
  void set_low(PlanPoints& of, double low) const {
    for (std::size_t k = 0; k < PlanPoints::kCount; ++k)
      of.low[k] = (open >> k & 1) != 0 ? low : -std::numeric_limits<double>::infinity();
  }
};

bool has_height_history(const PartField& field) {
  if (!field.solid().is_upright()) return false;
  for (std::uint32_t i = 0; i < field.sweeps().size(); ++i)
    if (!is_upward(field.sweeps(), i)) return false;
  return true;
}

HeightGrid::HeightGrid(const Box3& stock, double voxel)
    : low_{stock.lo.x, stock.lo.y}, end_{stock.hi.x, stock.hi.y} {
  const Vec2 size = end_ - low_;
  const auto columns = [&](double length) { return std::max(std::ceil(length / voxel), 1.0); };
  const double nx = columns(size.x), ny = columns(size.y);
  column_ = {size.x / nx, size.y / ny};
  tiles_ = {static_cast<int>(std::ceil(nx / kTile)), static_cast<int>(std::ceil(ny / kTile))};
}

HeightGrid::HeightGrid(const Box3& stock, const CutLattice& lattice)
    : end_{stock.hi.x, stock.hi.y}, column_{lattice.voxel, lattice.voxel} {
  const auto tile_of = [&](double x, double shift) {
    return static_cast<std::int32_t>(
        std::floor((std::floor(x / lattice.voxel - shift + 0.5)) / kTile));
  };
  const std::int32_t x = tile_of(stock.lo.x, kLatticeShift.x),
                     y = tile_of(stock.lo.y, kLatticeShift.y);
  tiles_ = {tile_of(end_.x, kLatticeShift.x) - x + 1, tile_of(end_.y, kLatticeShift.y) - y + 1};
  first_ = {x * kTile, y * kTile};
  const Vec3 center = lattice.position({first_[0], first_[1], 0});
  low_ = {center.x - 0.5 * lattice.voxel, center.y - 0.5 * lattice.voxel};
}

std::array<std::int32_t, 2> HeightGrid::origin(std::size_t tile) const {
  const auto t = static_cast<std::int32_t>(tile);
  return {first_[0] + t % tiles_[0] * kTile, first_[1] + t / tiles_[0] * kTile};
}

Vec2 HeightGrid::corner(std::size_t tile) const {
  const auto wide = static_cast<std::size_t>(tiles_[0]);
  const std::size_t x = tile % wide, y = tile / wide;
  return low_ + Vec2{static_cast<double>(x) * kTile * column_.x,
                     static_cast<double>(y) * kTile * column_.y};
}

std::vector<std::vector<std::uint32_t>> HeightGrid::sweeps_of_tiles(
    const SweepTable& sweeps) const {
  std::vector<std::vector<std::uint32_t>> out(tiles());
  const auto tile_of = [](double x, double low, double column, int tiles) {
    return static_cast<int>(
        std::clamp(std::floor((x - low) / (kTile * column)), -1.0, static_cast<double>(tiles)));
  };
  for (std::uint32_t i = 0; i < sweeps.size(); ++i) {
    const Box3 box = sweeps.bounds(i);
    const int x0 = std::max(tile_of(box.lo.x, low_.x, column_.x, tiles_[0]), 0);
    const int x1 = std::min(tile_of(box.hi.x, low_.x, column_.x, tiles_[0]), tiles_[0] - 1);
    const int y0 = std::max(tile_of(box.lo.y, low_.y, column_.y, tiles_[1]), 0);
    const int y1 = std::min(tile_of(box.hi.y, low_.y, column_.y, tiles_[1]), tiles_[1] - 1);
    for (int y = y0; y <= y1; ++y)
      for (int x = x0; x <= x1; ++x)
        out[static_cast<std::size_t>(y) * static_cast<std::size_t>(tiles_[0]) +
            static_cast<std::size_t>(x)]
            .push_back(i);
  }
  return out;
}

HeightWalker::HeightWalker(const PartField& field, const SweepUndersides& tools,
                           std::span<const CutFrame> frames, double close)
    : field_(field),
      heights_(field.sweeps(), tools, field.bounds().lo.z, field.bounds().hi.z, close),
      low_(field.bounds().lo.z),
      high_(field.bounds().hi.z),
      frames_(frames),
      lines_(heights_, low_, high_, frames.empty() ? kSummaryLines : kFileLines) {}

void HeightWalker::walk(const HeightGrid& grid, std::size_t tile,
                        std::span<const std::uint32_t> sweeps, std::span<double> removed) {
  removed_ = removed;
  begin(grid, tile, sweeps);
}

void HeightWalker::walk_steps(const HeightGrid& grid, std::size_t tile,
                              std::span<const std::uint32_t> sweeps, const Steps& steps) {
  finest_ = 0;
  steps_ = &steps;
  begin(grid, tile, sweeps);
}

void HeightWalker::begin(const HeightGrid& grid, std::size_t tile,
                         std::span<const std::uint32_t> sweeps) {
  heights_.assign(sweeps);
  sweeps_ = sweeps;
  extents_.assign(frames_.empty() ? 0 : sweeps.size(), {});
  end_ = grid.end();
  lists_[0].resize(sweeps.size());
  for (std::size_t i = 0; i < sweeps.size(); ++i) lists_[0][i] = static_cast<std::uint32_t>(i);
  Square whole{.side = static_cast<double>(HeightGrid::kTile) * grid.column(),
               .columns = HeightGrid::kTile};
  whole.center = grid.corner(tile) + 0.5 * whole.side;
  visit(whole, 0, false);
}

// `even`: the square lies in one in which heights do not differ much.
void HeightWalker::visit(const Square& square, std::size_t tier, bool even) {
  const Vec2 low = square.center - 0.5 * square.side;
  const bool is_column = square.columns <= 1;
  if (!is_column && (low.x >= end_.x || low.y >= end_.y)) return;
  if (is_column && (square.center.x >= end_.x || square.center.y >= end_.y)) return;
  if (is_column && (even || finest_ == 0)) return cut(square, lists_[tier]);
  const bool in_file = !frames_.empty(), is_last = square.finer == finest_;
  const std::size_t most_on_lines = in_file ? kFewSweeps : kMostOnLines;
  if (is_column && is_last && lists_[tier].size() > most_on_lines) return cut(square, lists_[tier]);
  const Found found = narrow(square, tier);
  if (!found.cuts) return;
  even = found.even;
  const List& left = lists_[tier + 1];
  if (is_column && even) return cut(square, left);
  if (is_column && found.walls && found.quick && left.size() <= most_on_lines &&
      square.finer >= (in_file ? kFiner : kLinesFrom))
    return cut_walls(square, left);
  if (is_column && is_last) return cut(square, left);
  if (square.columns == kPartsEachWay * kPartsEachWay && !heights_.balls().empty())
    return cut_parts(square, tier + 1);
  Square part{.side = 0.5 * square.side,
              .columns = square.columns / 2,
              .finer = square.finer + (is_column ? 1 : 0)};
  for (int k = 0; k < 4; ++k) {
    part.center = square.center +
                  Vec2{(k & 1 ? 0.5 : -0.5) * part.side.x, (k & 2 ? 0.5 : -0.5) * part.side.y};
    visit(part, tier + 1, even);
  }
}

// The sweeps that can be record lows somewhere in the square: those whose bottom, somewhere, may
// lie below the bottoms of all before them. If extents are wanted, a square that the wall of
// a sweep passes is uneven too, even where later sweeps remove that wall: it separates what this
// motion removes from what a later one does.
HeightWalker::Found HeightWalker::narrow(const Square& square, std::size_t tier) {
  const double r = 0.5 * length(square.side);
  double least = high_, most = high_;  // of the lowest bottom, in the whole square
  bool has_wall = false;
  Found found;
  List& left = lists_[tier + 1];
  left.clear();
  const List& list = lists_[tier];
  std::uint32_t asked = 0;  // index behind the last run that was measured
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::uint32_t index = list[i];
    if (most <= low_) break;
    if (index >= asked) {
      asked = heights_.run_end(index);
      const std::size_t last = i + kWorthRun - 1;
      if (last < list.size() && list[last] < asked &&
          !(heights_.run_lower(index, square.center.x, square.center.y, r, most) < most)) {
        while (i + 1 < list.size() && list[i + 1] < asked) ++i;
        continue;
      }
    }
    const Underside::Bounds bottom =
        heights_.bounds(index, square.center.x, square.center.y, r, most);
    if (!(bottom.lower < most)) continue;
    left.push_back(index);
    found.walls = found.walls || std::isinf(bottom.upper);
    found.quick = found.quick && heights_.is_quick(index);
    const double step = std::min(kSteepTip * (high_ - bottom.lower), 2 * r);
    if (!frames_.empty() && std::min(bottom.upper, most) - bottom.lower > step) has_wall = true;
    least = std::min(least, bottom.lower), most = std::min(most, bottom.upper);
  }
  if (square.columns <= 1 && left.size() > kFewSweeps) has_wall = false;
  found.cuts = !left.empty();
  found.even = !has_wall && is_even(least, most);
  return found;
}

// Between these bounds of the lowest bottom in a square heights do not differ much.
bool HeightWalker::is_even(double least, double most) const {
  least = std::max(least, low_), most = std::max(most, low_);
  const bool is_fine = !frames_.empty() && heights_.balls().empty();
  const double steep = is_fine ? kSteepInFile : kSteepTip;
  return most - least <= steep * (high_ - least);
}

// Hands on the staircase in the middle of a square: the sweep, the height and the one before it.
template <class Step>
void HeightWalker::for_each_step(const Square& square, const List& list, const Step& step) const {
  double low = high_;
  for (const std::uint32_t index : list) {
    if (low <= low_) return;
    const double bottom =
        std::max(heights_.bottom(index, square.center.x, square.center.y, low), low_);
    if (!(bottom < low)) continue;
    step(index, bottom, low);
    low = bottom;
  }
}

void HeightWalker::cut(const Square& square, const List& list) {
  for_each_step(square, list, [&](std::uint32_t index, double bottom, double low) {
    step(square, index, bottom, low);
  });
}

// Volumes by lines, extents by the middle.
void HeightWalker::cut_walls(const Square& square, const List& list) {
  const double area = square.side.x * square.side.y * stock_share(square);
  if (!(area > 0)) return;
  const std::span<const double> depths = lines_.depths(square.center, square.side, list);
  for (std::size_t i = 0; i < list.size(); ++i) removed_[list[i]] += area * depths[i];
  if (frames_.empty()) return;
  for_each_step(square, list, [&](std::uint32_t index, double bottom, double low) {
    extend(index, square, bottom, low);
  });
}

// A column sinks from `low` to `bottom`.
void HeightWalker::step(const Square& column, std::uint32_t index, double bottom, double low) {
  if (steps_ != nullptr) return (*steps_)(column.center - 0.5 * column.side, index, bottom);
  const double area = column.side.x * column.side.y * stock_share(column);
  removed_[index] += area * (low - bottom);
  if (!frames_.empty() && area > 0) extend(index, column, bottom, low);
}

HeightWalker::Parts HeightWalker::parts_of(const Square& square) const {
  Parts parts{.side = 1.0 / kPartsEachWay * square.side, .points = {}};
  const bool are_columns = square.columns <= kPartsEachWay;
  for (std::size_t k = 0; k < PlanPoints::kCount; ++k) {
    const auto at = [&](std::size_t i, double center, double side, double part) {
      return center - 0.5 * side + (double(i) + 0.5) * part;
    };
    const double x = at(k % kPartsEachWay, square.center.x, square.side.x, parts.side.x);
    const double y = at(k / kPartsEachWay, square.center.y, square.side.y, parts.side.y);
    parts.points.x[k] = x, parts.points.y[k] = y;
    // A column belongs to the stock by its middle, a larger part by its corner.
    const Vec2 first = are_columns ? Vec2{x, y} : Vec2{x, y} - 0.5 * parts.side;
    if (first.x < end_.x && first.y < end_.y) parts.open |= 1u << k;
  }
  return parts;
}

// Balls alone: a sweep is measured at 16 points in plan together, first for squares of columns,
// then for columns.
void HeightWalker::cut_parts(const Square& square, std::size_t tier) {
  const Parts parts = parts_of(square);
  PlanPoints points = parts.points;
  alignas(64) double least[PlanPoints::kCount];
  parts.set_low(points, high_), std::fill_n(least, PlanPoints::kCount, high_);
  for (List& list : part_lists_) list.clear();
  const double r = 0.5 * length(parts.side);
  for (const std::uint32_t index : lists_[tier])
    for_each_bit(sweep_kernels().ball_bounds(heights_.balls()[index], r, points, least),
                 [&](std::size_t k) { part_lists_[k].push_back(index); });
  for_each_bit(parts.open, [&](std::size_t k) {
    if (part_lists_[k].empty()) return;
    const Square part{.center = parts.center(k), .side = parts.side, .columns = kPartsEachWay};
    cut_part(part, part_lists_[k], tier + 1, is_even(least[k], points.low[k]));
  });
}

// Columns in which heights differ are cut in parts. Where extents are wanted they are halved, each
// as often as it needs.
void HeightWalker::cut_part(const Square& part, const List& list, std::size_t tier,
                            bool is_even_part) {
  const SweepKernels& kernels = sweep_kernels();
  const std::span<const LineRecord> balls = heights_.balls();
  Parts parts = parts_of(part);
  PlanPoints points = parts.points;
  Square column{.side = parts.side, .columns = 1};
  const List* some = &list;
  if (!is_even_part && finest_ > 0) {
    List& left = lists_[tier];
    left.clear();
    alignas(64) double least[PlanPoints::kCount];
    parts.set_low(points, high_), std::fill_n(least, PlanPoints::kCount, high_);
    const double r = 0.5 * length(parts.side);
    for (const std::uint32_t index : list)
      if (kernels.ball_bounds(balls[index], r, points, least) != 0) left.push_back(index);
    some = &left;
    for_each_bit(parts.open, [&](std::size_t k) {
      if (is_even(least[k], points.low[k])) return;
      parts.open &= ~(1u << k);
      column.center = parts.center(k);
      if (frames_.empty() && left.size() > kMostOnLines)
        cut_part(column, left, tier + 1, true);
      else
        visit(column, tier, false);
    });
  }
  parts.set_low(points, high_);
  alignas(64) double bottom[PlanPoints::kCount];
  for (const std::uint32_t index : *some)
    for_each_bit(kernels.ball_heights(balls[index], points, bottom), [&](std::size_t k) {
      const double to = std::max(bottom[k], low_);
      if (!(to < points.low[k])) return;
      column.center = parts.center(k);
      step(column, index, to, points.low[k]);
      points.low[k] = to;
    });
}

void HeightWalker::extend(std::uint32_t index, const Square& square, double bottom, double top) {
  const CutFrame& frame = frames_[std::size_t(field_.sweeps().motion(sweeps_[index]))];
  // Over all of the column: the tip of a V tool seldom passes its middle.
  const double r = 0.5 * length(square.side);
  const double lowest = heights_.bounds(index, square.center.x, square.center.y, r, bottom).lower;
  const Vec3 p{square.center.x, square.center.y, std::max(std::min(lowest, bottom), low_)};
  const PlanBand band = band_across(frame, square, p);
  extents_[index].add({frame.along(p), frame.along({p.x, p.y, top}), band.left, band.right,
                       square.side.x * square.side.y * stock_share(square)});
}

// The cutter's own edge lies between the last column that it removes and the next one. At the side
// of a round stock the column ends with the stock.
PlanBand HeightWalker::band_across(const CutFrame& frame, const Square& square,
                                   const Vec3& p) const {
  constexpr double kClipped = 1 - 1e-9;
  const double at = frame.across(p), edge = frame.reach();
  const Vec2 across = frame.direction_across(p), half = 0.5 * square.side;
  const double whole = std::abs(across.x) * half.x + std::abs(across.y) * half.y;
  PlanBand out{at - 2 * whole < -edge ? -edge : at - whole,
               at + 2 * whole > edge ? edge : at + whole};
  const StockSolid& solid = field_.solid();
  if (solid.is_box()) return out;
  const double d = solid.plan_distance(p.x, p.y);
  if (d < -length(half)) return out;
  const PlanBand stock = band_within(across, half, solid.plan_normal(p.x, p.y), d);
  if (stock.left > -kClipped * whole) out.left = at + stock.left;
  if (stock.right < kClipped * whole) out.right = at + stock.right;
  return out;
}

// The share of a column that the stock fills, its side taken as a plane.
double HeightWalker::stock_share(const Square& square) const {
  const StockSolid& solid = field_.solid();
  if (solid.is_box()) return 1;
  const Vec2 half = 0.5 * square.side;
  const double d = solid.plan_distance(square.center.x, square.center.y), r = length(half);
  if (d <= -r || d >= r) return d < 0 ? 1 : 0;
  return share_within(half, solid.plan_normal(square.center.x, square.center.y), d);
}

}  // namespace mrsim
