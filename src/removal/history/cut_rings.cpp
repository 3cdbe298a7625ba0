#include "removal/history/cut_rings.h"

#include "core/numbers/rounding.h"
#include "core/numbers/vec.h"
#include "removal/history/first_sweeps.h"

#include <algorithm>
#include <cmath>

namespace mrsim {
namespace {

constexpr double kNarrowest = 1.0 / 32;  // voxels: a ring of more than one value is not divided

void measure_all(const PartField& field, std::uint32_t sweep, PointColumns& points) {
  std::fill_n(points.least, PointColumns::kPad, kInfinity);
  field.sweeps().least(std::span(&sweep, 1), points);
}

}  // namespace

RingPlanes::RingPlanes(const PartField& field, double voxel, std::int32_t first, int count)
    : field_(field),
      lattice_{voxel, false},
      first_(first),
      planes_(static_cast<std::size_t>(count)),
      levels_(32) {
  std::fill_n(points_.nearest, PointColumns::kPad, 0.0);
  const double low = lattice_.position({0, 0, first}).z, high = low + count * voxel;
  const Box3 box{{-kInfinity, -kInfinity, low - voxel}, {kInfinity, kInfinity, high}};
  Part all{.low = 0, .high = field.bounds().hi.x + voxel, .z = first, .deep = count};
  all.list = field.sweeps().expanded(field.all(), box);
  divide(all, 0);
  for (std::vector<Ring>& plane : planes_) plane.push_back({kInfinity, kNeverThere});
}

void RingPlanes::divide(const Part& whole, std::size_t depth) {
  Parts& parts = levels_[depth];
  split(whole, parts);
  distribute(whole, parts);
  for (const Part& part : parts) settle(part, depth);
}

// Eight parts, about as wide as deep, in the order of their rings, and what the stock says of each.
void RingPlanes::split(const Part& whole, Parts& parts) {
  const double h = lattice_.voxel;
  const int deeper = whole.deep == 1                                              ? 1
                     : whole.deep == 2 || whole.high - whole.low > whole.deep * h ? 2
                                                                                  : 4;
  const int rings = int(PointColumns::kPad) / deeper, deep = whole.deep / deeper;
  const double width = (whole.high - whole.low) / rings;
  for (std::size_t c = 0; c < parts.size(); ++c) {
    const int ring = int(c) / deeper, low_z = int(c) % deeper * deep;
    Part& part = parts[c];
    part.low = whole.low + ring * width;
    part.high = ring + 1 == rings ? whole.high : whole.low + (ring + 1) * width;
    part.z = whole.z + low_z, part.deep = deep;
    const double middle = lattice_.position({0, 0, part.z}).z + 0.5 * (deep - 1) * h;
    const Vec3 center{0.5 * (part.low + part.high), 0, middle};
    points_.x[c] = center.x, points_.y[c] = 0, points_.z[c] = middle;
    const double reach = std::hypot(0.5 * width, 0.5 * (deep - 1) * h) + field_.slack();
    const double stock = whole.in_stock ? -kInfinity : field_.solid().distance(center);
    part.in_stock = stock<-reach, part.decided = stock> reach;
    part.list.clear();
    part.least = kInfinity;
  }
  points_.count = parts.size();
}

void RingPlanes::distribute(const Part& whole, Parts& parts) {
  const Part& any = parts.front();
  const double radius =
      std::hypot(0.5 * (any.high - any.low), 0.5 * (any.deep - 1) * lattice_.voxel);
  distribute_sweeps(whole.list, std::span<Part>(parts), points_.least, radius + field_.slack(),
                    2 * radius + field_.slack(),
                    [&](std::uint32_t sweep) { measure_all(field_, sweep, points_); });
}

void RingPlanes::settle(const Part& part, std::size_t depth) {
  if (part.decided && part.list.empty()) return append(part, kNeverThere);
  if (part.in_stock && part.list.empty()) return append(part, kStillThere);
  if (part.in_stock && part.decided && part.list.size() == 1)
    return append(part, field_.sweeps().motion(part.list.front()));
  if (part.deep > 1 || part.high - part.low > kNarrowest * lattice_.voxel)
    return divide(part, depth + 1);
  questions_.push_back({part.list, part.in_stock});
  append(part, kAsk - static_cast<std::int32_t>(questions_.size() - 1));
}

void RingPlanes::append(const Part& part, std::int32_t value) {
  for (std::int32_t z = part.z; z < part.z + part.deep; ++z) {
    std::vector<Ring>& rings = planes_[static_cast<std::size_t>(z - first_)];
    if (!rings.empty() && rings.back().value == value)
      rings.back().end = part.high;
    else
      rings.push_back({part.high, value});
  }
}

void RingWalker::walk(const RingPlanes& planes, const CutCell& block, CutSink& sink) {
  std::int32_t value = 0;
  if (is_uniform(planes, block, value)) return sink.tile(block, value);
  if (block.size == kLeaf) return write_leaf(planes, block, sink);
  const int half = block.size / 2;
  for (int c = 0; c < 8; ++c)
    walk(planes,
         {{block.origin[0] + (c & 4 ? half : 0), block.origin[1] + (c & 2 ? half : 0),
           block.origin[2] + (c & 1 ? half : 0)},
          half},
         sink);
}

// Whether all planes of a cell have one ring, or equal ones. Leaves in inner_ where the rings of a
// leaf's planes begin.
bool RingWalker::is_uniform(const RingPlanes& planes, const CutCell& cell, std::int32_t& value) {
  const Vec3 low = lattice_.position(cell.origin);
  const double wide = (cell.size - 1) * lattice_.voxel;
  const auto least = [&](double x) { return std::max({x, -x - wide, 0.0}); };
  const auto most = [&](double x) { return std::max(std::abs(x), std::abs(x + wide)); };
  // With room for rounding: a ring too many does no harm.
  const double from = (1 - kShareRounding) * std::hypot(least(low.x), least(low.y));
  const double to = (1 + kShareRounding) * std::hypot(most(low.x), most(low.y));
  bool uniform = true;
  for (int z = 0; z < cell.size; ++z) {
    const std::span<const RingPlanes::Ring> rings = planes.plane(cell.origin[2] + z);
    const auto ring = std::partition_point(rings.begin(), rings.end(),
                                           [from](const auto& r) { return r.end <= from; });
    if (z < kLeaf) inner_[std::size_t(z)] = &*ring;
    if (z == 0) value = ring->value;
    uniform = uniform && ring->end > to && ring->value == value && value > RingPlanes::kAsk;
    if (!uniform && cell.size > kLeaf) return false;
  }
  return uniform;
}

void RingWalker::write_leaf(const RingPlanes& planes, const CutCell& cell, CutSink& sink) {
  constexpr int kColumns = kLeaf * kLeaf;
  double radius[kColumns], most = 0;
  for (int k = 0; k < kColumns; ++k) {
    const Vec3 p = lattice_.position({cell.origin[0] + k / kLeaf, cell.origin[1] + k % kLeaf, 0});
    radius[k] = std::sqrt(p.x * p.x + p.y * p.y);
    most = std::max(most, radius[k]);
  }
  bool asks = false;
  for (int z = 0; z < kLeaf; ++z) {
    const RingPlanes::Ring* ring = inner_[std::size_t(z)];
    std::int32_t value[kColumns];
    std::fill_n(value, kColumns, ring->value);
    asks = asks || ring->value <= RingPlanes::kAsk;
    for (; ring->end <= most; ++ring) {
      const std::int32_t beyond = ring[1].value;
      for (int k = 0; k < kColumns; ++k) value[k] = radius[k] >= ring->end ? beyond : value[k];
      asks = asks || beyond <= RingPlanes::kAsk;
    }
    for (int k = 0; k < kColumns; ++k) cut_[k * kLeaf + z] = value[k];
  }
  if (asks) ask(planes, cell);
  sink.leaf(cell, cut_);
}

void RingWalker::ask(const RingPlanes& planes, const CutCell& cell) {
  for (int k = 0; k < kLeaf * kLeaf * kLeaf; ++k)
    if (cut_[k] <= RingPlanes::kAsk)
      cut_[k] = first_of(
          planes.question(cut_[k]),
          lattice_.position({cell.origin[0] + k / (kLeaf * kLeaf),
                             cell.origin[1] + k / kLeaf % kLeaf, cell.origin[2] + k % kLeaf}));
}

std::int32_t RingWalker::first_of(const RingPlanes::Question& question, const Vec3& p) {
  for (std::size_t k = 0; k < PointColumns::kPad; ++k)
    points_.x[k] = p.x, points_.y[k] = p.y, points_.z[k] = p.z;
  if (!question.in_stock && field_.solid().distance(p) >= 0) return kNeverThere;
  for (const std::uint32_t sweep : question.sweeps) {
    measure_all(field_, sweep, points_);
    if (points_.least[0] <= 0) return field_.sweeps().motion(sweep);
  }
  return kStillThere;
}

}  // namespace mrsim
