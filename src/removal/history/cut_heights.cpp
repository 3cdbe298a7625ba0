#include "removal/history/cut_heights.h"

#include "core/vec.h"
#include "removal/stock/stock_solid.h"

#include <algorithm>
#include <cmath>

namespace mrsim {
namespace {

constexpr double kSteep = 0.5;  // of the depth of cut: where heights differ by more, columns halve

}  // namespace

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

Vec2 HeightGrid::corner(std::size_t tile) const {
  const auto wide = static_cast<std::size_t>(tiles_[0]);
  return low_ + Vec2{static_cast<double>(tile % wide) * kTile * column_.x,
                     static_cast<double>(tile / wide) * kTile * column_.y};
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
                           std::span<const CutFrame> frames)
    : field_(field),
      heights_(field.sweeps(), tools, field.bounds().lo.z, field.bounds().hi.z),
      low_(field.bounds().lo.z),
      high_(field.bounds().hi.z),
      frames_(frames) {}

void HeightWalker::walk(const HeightGrid& grid, std::size_t tile,
                        std::span<const std::uint32_t> sweeps, std::span<double> removed) {
  heights_.assign(sweeps);
  removed_ = removed;
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

// `is_even`: the square lies in one in which heights do not differ much.
void HeightWalker::visit(const Square& square, std::size_t level, bool is_even) {
  const Vec2 low = square.center - 0.5 * square.side;
  const bool is_column = square.columns <= 1;
  if (!is_column && (low.x >= end_.x || low.y >= end_.y)) return;
  if (is_column && (square.center.x >= end_.x || square.center.y >= end_.y)) return;
  if (is_column && (is_even || square.finer == kFiner)) return cut(square, lists_[level]);
  if (!narrow(square, level, is_even)) return;
  if (is_column && is_even) return cut(square, lists_[level + 1]);
  Square part{.side = 0.5 * square.side,
              .columns = square.columns / 2,
              .finer = square.finer + (is_column ? 1 : 0)};
  for (int k = 0; k < 4; ++k) {
    part.center = square.center +
                  Vec2{(k & 1 ? 0.5 : -0.5) * part.side.x, (k & 2 ? 0.5 : -0.5) * part.side.y};
    visit(part, level + 1, is_even);
  }
}

// The sweeps that can be record lows somewhere in the square: those whose bottom, somewhere, may
// lie below the bottoms of all before them. False where there is none.
bool HeightWalker::narrow(const Square& square, std::size_t level, bool& is_even) {
  const double r = 0.5 * length(square.side);
  double least = high_, most = high_;  // of the lowest bottom, in the whole square
  List& left = lists_[level + 1];
  left.clear();
  for (const std::uint32_t place : lists_[level]) {
    if (most <= low_) break;
    const Underside::Bounds bottom = heights_.bounds(place, square.center.x, square.center.y, r);
    if (!(bottom.lower < most)) continue;
    left.push_back(place);
    least = std::min(least, bottom.lower), most = std::min(most, bottom.upper);
  }
  least = std::max(least, low_), most = std::max(most, low_);
  is_even = most - least <= kSteep * (high_ - least);
  return !left.empty();
}

void HeightWalker::cut(const Square& square, const List& list) {
  const double area = square.side.x * square.side.y * stock_share(square);
  double low = high_;
  for (const std::uint32_t place : list) {
    if (low <= low_) return;
    const double bottom =
        std::max(heights_.bottom(place, square.center.x, square.center.y, low), low_);
    if (!(bottom < low)) continue;
    removed_[place] += area * (low - bottom);
    if (!frames_.empty() && area > 0) extend(place, square, bottom, low);
    low = bottom;
  }
}

// A column beside the cutter's own edge is removed up to that.
void HeightWalker::extend(std::uint32_t place, const Square& square, double bottom, double top) {
  const CutFrame& frame = frames_[std::size_t(field_.sweeps().motion(sweeps_[place]))];
  const Vec3 p{square.center.x, square.center.y, bottom};
  const double at = frame.across(p), half = frame.half_across(p, square.side);
  extents_[place].add({frame.along(p), frame.along({p.x, p.y, top}),
                       std::max(at - half, -frame.reach()), std::min(at + half, frame.reach()),
                       square.side.x * square.side.y * stock_share(square)});
}

// Of a column, by the distance of its centre from the stock's sides.
double HeightWalker::stock_share(const Square& square) const {
  if (field_.solid().is_box()) return 1;
  const double d = field_.solid().plan_distance(square.center.x, square.center.y);
  const double side = std::sqrt(square.side.x * square.side.y);
  return std::clamp(0.5 - d / side, 0.0, 1.0);
}

}  // namespace mrsim
