#include "removal/history/cut_columns.h"

#include "core/numbers/rounding.h"
#include "core/numbers/vec.h"
#include "removal/columns/sweep_columns.h"
#include "removal/part/block_index.h"

#include <algorithm>

namespace mrsim {
namespace {

constexpr double kRootTwo = 1.4142135623730952, kRootThree = 1.7320508075688774;

double within_one(double x) { return std::min(std::max(x, 0.0), 1.0); }

std::size_t padded(std::size_t count) {
  return (count + PointColumns::kPad - 1) / PointColumns::kPad * PointColumns::kPad;
}

void copy_point(const PointColumns& from, std::size_t k, PointColumns& to, std::size_t at) {
  to.x[at] = from.x[k], to.y[at] = from.y[k], to.z[at] = from.z[k];
}

// The kernels read whole registers.
void pad(PointColumns& points) {
  for (std::size_t k = points.count; k < padded(points.count); ++k)
    copy_point(points, points.count - 1, points, k);
}

}  // namespace

ColumnWalker::ColumnWalker(const PartField& field, double voxel)
    : field_(field),
      lattice_{voxel, false},
      voxel_(voxel),
      share_(1 / voxel),
      band_(0.5 * voxel + field.slack()),
      slack_(field.slack()) {
  std::fill_n(points_.nearest, PointColumns::kMost, 0.0);
  std::fill_n(below_.nearest, PointColumns::kMost, 0.0);
}

void ColumnWalker::walk(const std::array<std::int32_t, 3>& origin,
                        std::span<const std::uint32_t> sweeps, CutSink* sink,
                        std::span<double> removed) {
  sweeps_ = sweeps, removed_ = removed, sink_ = sink;
  Square block{.origin = origin, .list = List(sweeps.size())};
  lowest_.resize(sweeps.size());
  for (std::size_t i = 0; i < sweeps.size(); ++i) {
    block.list[i] = static_cast<std::uint32_t>(i);
    lowest_[i] = field_.sweeps().bounds(sweeps[i]).lo.z;
  }
  bottom_ = lattice_.position(origin).z;
  block.clear = height(kDeep - 1);
  block.floor = kInfinity;
  visit(block, kBlockVoxels, 0);
}

void ColumnWalker::visit(const Square& square, int size, std::size_t depth) {
  if (size == kSide) return carve(square.origin, square.list);
  std::array<Square, 4>& squares = levels_[depth];
  const int half = size / 2;
  const double middle = 0.5 * (half - 1) * voxel_;
  for (std::size_t k = 0; k < squares.size(); ++k) {
    squares[k].origin = {square.origin[0] + (k & 2 ? half : 0),
                         square.origin[1] + (k & 1 ? half : 0), square.origin[2]};
    squares[k].list.clear();
    squares[k].clear = height(kDeep - 1), squares[k].floor = kInfinity, squares[k].closed = false;
    const Vec3 corner = lattice_.position(squares[k].origin);
    points_.x[k] = corner.x + middle, points_.y[k] = corner.y + middle;
    points_.z[k] = squares[k].clear;
  }
  points_.count = squares.size();
  pad(points_);
  distribute(square.list, middle * kRootTwo, squares);
  for (const Square& child : squares) visit(child, half, depth + 1);
}

void ColumnWalker::distribute(const List& list, double radius, std::array<Square, 4>& squares) {
  const double reach = radius + band_;
  for (const std::uint32_t index : list) {
    bool closed = true;
    for (const Square& square : squares) closed = closed && square.closed;
    if (closed) return;
    measure(index, points_);
    for (std::size_t k = 0; k < squares.size(); ++k) {
      Square& square = squares[k];
      const Vec3 center{points_.x[k], points_.y[k], points_.z[k]};
      if (square.closed || !reaches(index, points_.least[k], reach, center, square)) continue;
      square.list.push_back(index);
      points_.z[k] = square.clear;
      square.closed = square.clear < bottom_;
    }
  }
}

// Whether a sweep, at distance d from the centre of a square, can remove anything of what is left
// of the square. Notes in `square` what is left after the sweep. Distances are 1-Lipschitz and do
// not grow upwards.
bool ColumnWalker::reaches(std::uint32_t index, double d, double reach, const Vec3& center,
                           Square& square) const {
  if (d > reach || lowest_[index] >= square.floor) return false;
  if (d < -reach) square.clear -= -reach - d;
  if (const auto flat = field_.sweeps().flat_floor(sweeps_[index], center))
    if (flat->inside > reach && std::isinf(flat->top))
      square.floor = std::min(square.floor, flat->z - slack_);
  return true;
}

void ColumnWalker::carve(const std::array<std::int32_t, 3>& origin, const List& list) {
  if (list.empty() && sink_ == nullptr) return;
  fill_from_stock(origin);
  set_lanes(origin);
  for (const std::uint32_t index : list)
    if (!take(index)) break;
  if (sink_ != nullptr) hand_on(origin);
}

void ColumnWalker::fill_from_stock(const std::array<std::int32_t, 3>& origin) {
  const double middle = 0.5 * (kSide - 1) * voxel_, reach = middle * kRootThree + band_;
  for (int low = 0; low < kDeep; low += kSide) {
    const Vec3 corner = lattice_.position({origin[0], origin[1], origin[2] + low});
    const double stock = field_.solid().distance(corner + Vec3{middle, middle, middle});
    if (stock >= -reach && stock <= reach) {
      fill_cell(origin, low);
      continue;
    }
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      std::fill_n(left_[lane].data() + low, kSide, stock < 0 ? 1.0f : 0.0f);
      std::fill_n(cut_[lane].data() + low, kSide, stock < 0 ? kStillThere : kNeverThere);
    }
  }
}

// A cell on the stock's surface, layer by layer.
void ColumnWalker::fill_cell(const std::array<std::int32_t, 3>& origin, int low) {
  double x[kLanes], y[kLanes], z[kLanes], stock[kLanes];
  for (int deep = low; deep < low + kSide; ++deep) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const auto i = static_cast<std::int32_t>(lane);
      const Vec3 p =
          lattice_.position({origin[0] + i / kSide, origin[1] + i % kSide, origin[2] + deep});
      x[lane] = p.x, y[lane] = p.y, z[lane] = p.z;
    }
    field_.solid().distances(kLanes, x, y, z, stock);
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const auto at = static_cast<std::size_t>(deep);
      left_[lane][at] = static_cast<float>(within_one(0.5 - share_ * stock[lane]));
      cut_[lane][at] = stock[lane] < 0 ? kStillThere : kNeverThere;
    }
  }
}

void ColumnWalker::set_lanes(const std::array<std::int32_t, 3>& origin) {
  open_ = 0;
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    const auto i = static_cast<std::int32_t>(lane);
    const Vec3 p = lattice_.position({origin[0] + i / kSide, origin[1] + i % kSide, origin[2]});
    top_[lane] = kDeep - 1, floor_at_[lane] = -1;
    lower_top(lane);
    if (top_[lane] < 0) continue;
    points_.x[open_] = p.x, points_.y[open_] = p.y, points_.z[open_] = height(top_[lane]);
    lanes_[open_++] = static_cast<std::uint8_t>(lane);
  }
  points_.count = open_;
  if (open_ > 0) pad(points_);
}

void ColumnWalker::lower_top(std::size_t lane) {
  while (top_[lane] >= 0 && !(left_[lane][static_cast<std::size_t>(top_[lane])] > 0)) --top_[lane];
}

// What one sweep removes at the tops of the columns, and below them where it reaches further. False
// where nothing is left.
bool ColumnWalker::take(std::uint32_t index) {
  if (open_ == 0) return false;
  measure(index, points_);
  const double half = 0.5 * voxel_;
  if (*std::min_element(points_.least, points_.least + open_) >= half) return true;
  falling_count_ = 0;
  for (std::size_t k = 0; k < open_; ++k) {
    const std::size_t lane = lanes_[k];
    const double d = points_.least[k];
    if (d >= half || (top_[lane] <= floor_at_[lane] && lowest_[index] >= floor_[lane])) continue;
    falling_[falling_count_++] = {static_cast<std::uint8_t>(lane), top_[lane], 1, d};
    below_.x[falling_count_ - 1] = points_.x[k], below_.y[falling_count_ - 1] = points_.y[k];
  }
  if (falling_count_ == 0) return true;
  motion_ = field_.sweeps().motion(sweeps_[index]);
  removed_[index] += cut_down(index) * voxel_ * voxel_ * voxel_;
  std::size_t kept = 0;
  for (std::size_t k = 0; k < open_; ++k) {
    const std::size_t lane = lanes_[k];
    lower_top(lane);
    if (top_[lane] < 0) continue;
    copy_point(points_, k, points_, kept);
    points_.z[kept] = height(top_[lane]);
    lanes_[kept++] = static_cast<std::uint8_t>(lane);
  }
  points_.count = open_ = kept;
  if (kept > 0) pad(points_);
  return kept > 0;
}

// Removes downwards in the columns of falling_, as far as the sweep reaches. The share of a voxel
// never falls on the way down, so where two voxels have the same share, all between them have it,
// too: steps grow while shares stay the same.
double ColumnWalker::cut_down(std::uint32_t index) {
  double gone = 0;
  for (std::size_t k = 0; k < falling_count_; ++k)
    gone += remove(falling_[k].lane, falling_[k].at, falling_[k].at, falling_[k].distance);
  while (true) {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < falling_count_; ++k) {
      if (falling_[k].at == 0) continue;
      falling_[kept] = falling_[k];
      below_.x[kept] = below_.x[k], below_.y[kept] = below_.y[k];
      below_.z[kept] = height(std::max(falling_[k].at - falling_[k].step, 0));
      ++kept;
    }
    below_.count = kept;
    if (kept == 0) return gone;
    pad(below_);
    measure(index, below_);
    falling_count_ = 0;
    for (std::size_t k = 0; k < kept; ++k) {
      if (!step_down(falling_[k], below_.least[k], gone)) continue;
      falling_[falling_count_] = falling_[k];
      below_.x[falling_count_] = below_.x[k], below_.y[falling_count_++] = below_.y[k];
    }
  }
}

// d: the distance one step below. False where the sweep reaches no further.
bool ColumnWalker::step_down(Falling& f, double d, double& gone) {
  const int next = std::max(f.at - f.step, 0);
  const bool same = share_of(d) == share_of(f.distance);
  if (!same && f.at - next > 1) {
    f.step = 1;
    return true;
  }
  if (d >= 0.5 * voxel_) {
    // The distance grows as fast as it can: the sweep's lowest point here is right above.
    if (d - f.distance >= voxel_ * (1 - kShareRounding))
      floor_[f.lane] = height(next) + d - slack_, floor_at_[f.lane] = f.at;
    return false;
  }
  gone += remove(f.lane, next, f.at - 1, d);
  f.step = same ? 2 * f.step : 1;
  f.at = next, f.distance = d;
  return true;
}

double ColumnWalker::share_of(double d) const { return within_one(0.5 + share_ * d); }

// Leaves no more than a sweep at distance d does of the voxels low .. high of a column.
double ColumnWalker::remove(std::size_t lane, int low, int high, double d) {
  const auto share = static_cast<float>(share_of(d));
  double gone = 0;
  for (auto z = static_cast<std::size_t>(low); z <= static_cast<std::size_t>(high); ++z) {
    float& left = left_[lane][z];
    std::int32_t& cut = cut_[lane][z];
    if (d <= 0 && cut == kStillThere) cut = motion_;
    if (left <= share) continue;
    gone += static_cast<double>(left - share);
    left = share;
  }
  return gone;
}

// Distances of the points from one sweep.
void ColumnWalker::measure(std::uint32_t index, PointColumns& points) {
  std::fill_n(points.least, padded(points.count), kInfinity);
  field_.sweeps().least(sweeps_.subspan(index, 1), points);
}

void ColumnWalker::hand_on(const std::array<std::int32_t, 3>& origin) {
  std::array<std::int32_t, kLanes * kSide> cell;
  for (int low = 0; low < kDeep; low += kSide) {
    for (std::size_t lane = 0; lane < kLanes; ++lane)
      std::copy_n(cut_[lane].data() + low, kSide, cell.data() + lane * kSide);
    const CutCell whole{{origin[0], origin[1], origin[2] + low}, kSide};
    if (std::all_of(cell.begin(), cell.end(), [&](std::int32_t c) { return c == cell[0]; }))
      sink_->tile(whole, cell[0]);
    else
      sink_->leaf(whole, cell.data());
  }
}

}  // namespace mrsim
