#include "removal/history/cut_walk.h"

#include "core/numbers/rounding.h"
#include "core/numbers/units.h"
#include "core/numbers/vec.h"
#include "removal/field/lattice.h"
#include "removal/history/first_sweeps.h"

#include <algorithm>

namespace mrsim {
namespace {

// Share of a voxel: a sweep that removes less of it has only rounded there (a pass along a finished
// surface does), and the voxel is not part of its extent.
constexpr double kLeastGone = 0.01;

}  // namespace

CutWalker::CutWalker(const PartField& field, const CutLattice& lattice,
                     std::span<const CutFrame> frames)
    : field_(field),
      lattice_(lattice),
      band_(0.5 * lattice.voxel + field.slack()),
      share_(1 / lattice.voxel),
      frames_(frames) {
  std::fill_n(points_.nearest, PointColumns::kMost, 0.0);
}

void CutWalker::walk(const CutCell& block, std::span<const std::uint32_t> sweeps, CutSink* sink,
                     std::span<double> removed) {
  if (!frames_.empty() && sweeps.data() != sweeps_.data()) extents_.assign(sweeps.size(), {});
  sweeps_ = sweeps, sink_ = sink, removed_ = removed;
  List all(sweeps.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<std::uint32_t>(i);
  visit(block, all, false, 0);
}

// Radius of the ball about all voxel centres of a cell.
double CutWalker::radius_of(int size) const {
  const double half = 0.5 * (size - 1) * lattice_.voxel;
  return half * (lattice_.half_plane ? 1.4142135623730952 : 1.7320508075688774);
}

// mm^3 of a voxel at x.
double CutWalker::ring(double x) const {
  const double h = lattice_.voxel;
  return lattice_.half_plane ? kTwoPi * x * h * h : h * h * h;
}

void CutWalker::visit(const CutCell& cell, const List& list, bool in_stock, std::size_t depth) {
  Children& children = levels_[depth];
  const std::size_t count = divide(cell, in_stock, children);
  distribute(list, radius_of(cell.size / 2), std::span(children).first(count));
  for (std::size_t c = 0; c < count; ++c) settle(children[c], depth);
}

// The children, their centres in points_, and what the stock says about each.
std::size_t CutWalker::divide(const CutCell& cell, bool in_stock, Children& children) {
  const int size = cell.size / 2;
  const double middle = 0.5 * (size - 1) * lattice_.voxel, reach = radius_of(size) + band_;
  const std::size_t count = lattice_.half_plane ? 4 : 8;
  for (std::size_t c = 0; c < count; ++c) {
    Child& child = children[c];
    child.cell = {cell.origin, size};
    child.cell.origin[2] += c & 1 ? size : 0;
    child.cell.origin[0] += c & 2 ? size : 0;
    child.cell.origin[1] += c & 4 ? size : 0;
    const Vec3 center = lattice_.position(child.cell.origin) +
                        Vec3{middle, lattice_.half_plane ? 0 : middle, middle};
    points_.x[c] = center.x, points_.y[c] = center.y, points_.z[c] = center.z;
    child.list.clear();
    child.least = kInfinity;
    const double stock = in_stock ? -kInfinity : field_.solid().distance(center);
    child.in_stock = stock < -reach;
    child.decided = stock > reach;
    if (child.decided && sink_ != nullptr) sink_->tile(child.cell, kNeverThere);
  }
  for (std::size_t c = count; c < PointColumns::kPad; ++c)
    points_.x[c] = points_.x[0], points_.y[c] = points_.y[0], points_.z[c] = points_.z[0];
  points_.count = count;
  return count;
}

void CutWalker::distribute(const List& list, double radius, std::span<Child> children) {
  distribute_sweeps(list, children, points_.least, radius + band_, 2 * radius + field_.slack(),
                    [&](std::uint32_t index) { measure(index); });
}

void CutWalker::settle(Child& child, std::size_t depth) {
  if (child.decided && child.list.empty()) return;  // in the air
  if (child.in_stock && child.list.empty()) {
    if (sink_ != nullptr) sink_->tile(child.cell, kStillThere);
  } else if (child.in_stock && child.decided && child.list.size() == 1) {
    fill_tile(child.cell, child.list.front());
  } else if (child.cell.size > leaf_size()) {
    visit(child.cell, child.list, child.in_stock, depth + 1);
  } else {
    evaluate(child.cell, child.list, child.in_stock);
  }
}

void CutWalker::fill_tile(const CutCell& cell, std::uint32_t index) {
  const double size = cell.size, middle = 0.5 * (size - 1) * lattice_.voxel;
  removed_[index] += ring(lattice_.position(cell.origin).x + middle) * size * size *
                     (lattice_.half_plane ? 1 : size);
  if (sink_ != nullptr) sink_->tile(cell, field_.sweeps().motion(sweeps_[index]));
  if (frames_.empty()) return;
  const std::int32_t last = cell.size - 1;
  for (int k = 0; k < 8; ++k)
    extend(index,
           lattice_.position({cell.origin[0] + (k & 1 ? last : 0),
                              cell.origin[1] + (k & 2 && !lattice_.half_plane ? last : 0),
                              cell.origin[2] + (k & 4 ? last : 0)}),
           1);
}

// The share that is removed of the outermost voxel is taken to lie on its inner side.
void CutWalker::extend(std::uint32_t index, const Vec3& p, double gone) {
  const CutFrame& frame = frames_[std::size_t(field_.sweeps().motion(sweeps_[index]))];
  const double out = (gone - 0.5) * lattice_.voxel;
  const double along = frame.along(p), across = frame.across(p);
  extents_[index].add({along - out, along + out, across - out, across + out});
}

void CutWalker::set_points(const CutCell& cell) {
  const int size = cell.size, deep = lattice_.half_plane ? 1 : size;
  std::size_t k = 0;
  for (int x = 0; x < size; ++x)
    for (int y = 0; y < deep; ++y)
      for (int z = 0; z < size; ++z, ++k) {
        const Vec3 p =
            lattice_.position({cell.origin[0] + x, cell.origin[1] + y, cell.origin[2] + z});
        points_.x[k] = p.x, points_.y[k] = p.y, points_.z[k] = p.z;
        volume_[k] = ring(p.x);
      }
  points_.count = k;
}

void CutWalker::evaluate(const CutCell& cell, const List& list, bool in_stock) {
  set_points(cell);
  std::fill_n(left_, points_.count, 1.0);
  std::fill_n(cut_, points_.count, kStillThere);
  if (!in_stock) {
    double stock[PointColumns::kMost];
    field_.solid().distances(points_.count, points_.x, points_.y, points_.z, stock);
    for (std::size_t k = 0; k < points_.count; ++k) {
      left_[k] = std::clamp(0.5 - share_ * stock[k], 0.0, 1.0);
      if (stock[k] >= 0) cut_[k] = kNeverThere;
    }
  }
  for (const std::uint32_t index : list)
    if (!take(index)) break;
  if (sink_ != nullptr) sink_->leaf(cell, cut_);
}

// The share of a voxel that is left after some sweeps is the least of their shares. False where
// nothing is left.
bool CutWalker::take(std::uint32_t index) {
  measure(index);
  const std::int32_t motion = field_.sweeps().motion(sweeps_[index]);
  double gone = 0, rest = 0;
  for (std::size_t k = 0; k < points_.count; ++k) {
    const double d = points_.least[k];
    const double left = std::min(left_[k], std::clamp(0.5 + share_ * d, 0.0, 1.0));
    gone += (left_[k] - left) * volume_[k];
    if (!frames_.empty() && left_[k] - left > kLeastGone)
      extend(index, {points_.x[k], points_.y[k], points_.z[k]}, left_[k] - left);
    rest += left;
    left_[k] = left;
    cut_[k] = d <= 0 && cut_[k] == kStillThere ? motion : cut_[k];
  }
  removed_[index] += gone;
  return rest > 0;
}

// Distances of the points from one sweep.
void CutWalker::measure(std::uint32_t index) {
  const std::size_t padded =
      (points_.count + PointColumns::kPad - 1) / PointColumns::kPad * PointColumns::kPad;
  std::fill_n(points_.least, padded, kInfinity);
  field_.sweeps().least(sweeps_.subspan(index, 1), points_);
}

}  // namespace mrsim
