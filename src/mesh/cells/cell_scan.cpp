#include "mesh/cells/cell_scan.h"

#include "core/numbers/vec.h"
#include "mesh/points/surface_search.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <memory>

namespace mrsim::detail {
namespace {

constexpr std::int32_t kTogether = 3;  ///< points to a side that are sampled together
constexpr int kSecants = 2;            ///< the second is near enough to see the face that decides
constexpr double kBendShare = 0.15;    ///< of k s^2, that a cell's triangles leave the surface by
constexpr double kSharpTurn = 0.5;     ///< sine of an angle between faces
constexpr double kTurned = 0.9;        ///< cosine between a face that has turned and the other one
constexpr std::size_t kMost = kTogether * kTogether * kTogether;
constexpr std::size_t kLong = 24;  ///< candidates that are cheaper narrowed than evaluated

// The points of a cell that are looked at: those of the voxel lattice, by voxels from its origin.
// Of a turned part, in each layer, points on a line from the axis outwards, at most 0.71 voxels
// apart, stand for all: no wall or gap of a voxel is between them.
class Points {
 public:
  Points(const Lattice& lattice, const CellView& cell, bool turned)
      : lattice_(lattice), cell_(cell), turned_(turned), lo_(on_lattice(0, 0, 0)) {
    const std::int32_t n = cell.voxels;
    hi_ = on_lattice(n, n, n);
    inner_ = {std::clamp(0.0, lo_.x, hi_.x), std::clamp(0.0, lo_.y, hi_.y), 0};
    outer_ = {-lo_.x > hi_.x ? lo_.x : hi_.x, -lo_.y > hi_.y ? lo_.y : hi_.y, 0};
  }

  std::int32_t last(int axis) const {
    return !turned_ ? cell_.voxels : axis == 0 ? 2 * cell_.voxels : axis == 1 ? 0 : cell_.voxels;
  }
  Vec3 position(const std::int32_t (&at)[3]) const {
    if (!turned_) return on_lattice(at[0], at[1], at[2]);
    Vec3 p = lerp(inner_, outer_, static_cast<double>(at[0]) / (2 * cell_.voxels));
    p.z = on_lattice(0, 0, at[2]).z;
    return p;
  }

 private:
  Vec3 on_lattice(std::int32_t x, std::int32_t y, std::int32_t z) const {
    const std::int32_t step = lattice_.per_voxel();
    return lattice_.position(
        {cell_.origin.x + x * step, cell_.origin.y + y * step, cell_.origin.z + z * step});
  }

  const Lattice& lattice_;
  const CellView& cell_;
  bool turned_;
  Vec3 lo_, hi_, inner_, outer_;
};

// A part of them, both ends included.
struct Range {
  std::int32_t lo[3], hi[3];

  int longest() const {
    int axis = 0;
    for (int a = 1; a < 3; ++a)
      if (hi[a] - lo[a] > hi[axis] - lo[axis]) axis = a;
    return axis;
  }
  std::int32_t side(int axis) const { return hi[axis] - lo[axis] + 1; }
};

using List = std::span<const std::uint32_t>;

Box3 box_about(const Vec3& a, const Vec3& b) {
  const Vec3 lo{std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)},
      hi{std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
  return inflated(Box3{lo, hi}, kQuantum);
}

// Goes through the points until it finds what `Judge` looks for, and leaves out whole ranges that
// `Judge` finds to be far from it. Lists of candidates become shorter on the way. They give d
// exactly where it is -Judge::band() or more; where it is less, they only show that it is less.
template <class Judge>
class Scan {
 public:
  Scan(const ExactField& field, const Points& points, const Judge& judge)
      : field_(field), points_(points), judge_(judge) {}

  bool finds(List candidates) {
    const Range all{{0, 0, 0}, {points_.last(0), points_.last(1), points_.last(2)}};
    if (candidates.size() > kLong)
      descent_ =
          field_.descent(0.5 * (points_.position(all.lo) + points_.position(all.hi)), candidates);
    return finds(all, candidates, 1);
  }

 private:
  // `tier`: the first one that holds none of the regions about the range.
  bool finds(const Range& range, List list, std::size_t tier) {
    const int axis = range.longest();
    if (range.side(axis) <= kTogether) return finds_among(range, list);
    const Vec3 first = points_.position(range.lo), last = points_.position(range.hi);
    if (judge_.is_far({first, last}, list)) return false;
    if (list.size() > kLong && descent_->enter(tier, box_about(first, last), judge_.band(), true) ==
                                   ExactField::Region::mixed) {
      if (lists_.size() <= tier) lists_.resize(tier + 1);
      descent_->candidates(tier, lists_[tier]);
      list = lists_[tier++];
    }
    Range low = range, high = range;
    low.hi[axis] = range.lo[axis] + range.side(axis) / 2 - 1;
    high.lo[axis] = low.hi[axis] + 1;
    return finds(low, list, tier) || finds(high, list, tier);
  }
  bool finds_among(const Range& range, List list) const {
    Vec3 points[kMost];
    std::size_t n = 0;
    for (std::int32_t x = range.lo[0]; x <= range.hi[0]; ++x)
      for (std::int32_t y = range.lo[1]; y <= range.hi[1]; ++y)
        for (std::int32_t z = range.lo[2]; z <= range.hi[2]; ++z)
          points[n++] = points_.position({x, y, z});
    return judge_.finds({points, n}, list);
  }

  const ExactField& field_;
  const Points& points_;
  const Judge& judge_;
  std::unique_ptr<ExactField::Descent> descent_;
  std::deque<Candidates> lists_;  ///< by tier; a deque, so that spans of them stay valid
};

// Half of the diagonal of the box that two opposite corners span, whichever these are.
double radius(const Box3& box) { return 0.5 * length(box.hi - box.lo) + kQuantum; }

// The plane that a surface is like.
struct MeanPlane {
  explicit MeanPlane(const CellSurface& surface) {
    for (const CellSurface::Point& p : surface.all()) middle += p.position, normal += p.normal;
    middle = (1.0 / static_cast<double>(surface.count)) * middle;
    // Normals that cancel out leave no plane: all distances from it are then about 0.
    normal = (1 / std::max(length(normal), 1e-30)) * normal;
  }
  double operator()(const Vec3& p) const { return dot(normal, p - middle); }

  Vec3 middle, normal;
};

struct Views {
  const ExactField& field;
  const CellView& cell;
  const CellLimits& limits;
  MeanPlane plane{cell.surface};

  // Deeper than that, d differs from a plane near the surface by more than the limit as well.
  double band() const { return 2 * limits.near + kQuantum; }

  // All material, or all air, by more than the limits, whichever bound shows it.
  bool is_far(const Box3& box, List list) const {
    const Vec3 center = 0.5 * (box.lo + box.hi);
    const double d = field.sample(center, list).distance;
    const double room = radius(box) + limits.near;
    if (std::abs(d) <= room) return false;
    if (d > 0 && field.sample(center, cell.seen).distance <= room) return false;
    return limits.bend > limits.near || (d > 0 ? plane(center) > room : plane(center) < -room);
  }

  bool finds(std::span<const Vec3> points, List list) const {
    FieldSample all[kMost];
    field.samples(points, list, all);
    Vec3 doubtful[kMost];
    double least[kMost], seen[kMost];
    std::size_t n = 0;
    for (std::size_t k = 0; k < points.size(); ++k) {
      const double d = all[k].distance;
      if (limits.bend <= limits.near && bends(d, plane(points[k]))) return true;
      if (d < -limits.near) continue;  // without the unseen ones as well
      if (!cell.stock_seen && all[k].owner == kStockOwner && d <= limits.near) return true;
      doubtful[n] = points[k];
      least[n++] = d - limits.unseen;
    }
    if (n == 0 || cell.all_seen) return false;
    field.distances({doubtful, n}, cell.seen, seen);
    for (std::size_t k = 0; k < n; ++k)
      if (seen[k] < least[k] && seen[k] < limits.near) return true;
    return false;
  }

  bool bends(double d, double told) const {
    return std::abs(d - told) > limits.bend && std::min(d, told) <= limits.near &&
           std::max(d, told) >= -limits.near;
  }
};

struct Sides {
  const ExactField& field;
  const CellView& cell;
  double sign, depth;

  double band() const { return depth + kQuantum; }

  bool is_far(const Box3& box, List list) const {
    const Vec3 center = 0.5 * (box.lo + box.hi);
    return sign * field.sample(center, list).distance - radius(box) > -depth;
  }
  bool finds(std::span<const Vec3> points, List list) const {
    double d[kMost];
    field.distances(points, list, d);
    return std::any_of(d, d + points.size(), [&](double x) { return sign * x < -depth; });
  }
};

// Whether two faces of one owner that join smoothly look like a crease nevertheless, as the floor
// and the wall that a flat mill leaves on a ramp: one of them, continued to the other's point, has
// turned into it, and their planes meet in the cell, near the surface.
bool turns_at_once(const ExactField& field, List candidates, const CellSurface::Point& p,
                   const CellSurface::Point& q, double size, double tolerance) {
  const double cosine = dot(p.normal, q.normal), square = 1 - cosine * cosine;
  if (p.at.owner != q.at.owner || same_face(p.at, q.at) || !(square > kSharpTurn * kSharpTurn))
    return false;
  if (dot(field.gradient(q.position, p.at), q.normal) < kTurned &&
      dot(field.gradient(p.position, q.at), p.normal) < kTurned)
    return false;
  const Vec3 middle = 0.5 * (p.position + q.position);
  const double f = dot(p.normal, middle - p.position), g = dot(q.normal, middle - q.position);
  const Vec3 meet =
      middle - (f - cosine * g) / square * p.normal - (g - cosine * f) / square * q.normal;
  return distance(meet, middle) <= size &&
         std::abs(field.sample(meet, candidates).distance) <= tolerance;
}

}  // namespace

CellSurface surface_of(const ExactField& field, std::span<const std::uint32_t> candidates,
                       const Box3& cell, const double (&corners)[8]) {
  CellSurface surface;
  for (int axis = 0; axis < 3; ++axis)
    for (int low = 0; low < 8; ++low) {
      const int high = low | 1 << axis;
      if (high == low || is_inside(corners[low]) == is_inside(corners[high])) continue;
      Vec3 a{low & 1 ? cell.hi.x : cell.lo.x, low & 2 ? cell.hi.y : cell.lo.y,
             low & 4 ? cell.hi.z : cell.lo.z};
      Vec3 b = a;
      mrsim::component(b, axis) = mrsim::component(cell.hi, axis);
      double from = corners[low], to = corners[high];
      CellSurface::Point& p = surface.points[surface.count++];
      for (int step = 0; step < kSecants; ++step) {
        p.position = lerp(a, b, from / (from - to));
        p.at = field.sample(p.position, candidates);
        (is_inside(p.at.distance) == is_inside(from) ? a : b) = p.position;
        (is_inside(p.at.distance) == is_inside(from) ? from : to) = p.at.distance;
      }
      p.normal = field.gradient(p.position, p.at);
    }
  return surface;
}

// The turn between two points as a curvature k: a chord across the cell leaves the surface by about
// k s^2 / 4. A face continued beyond its end (the nose of a short turning move) turns where the
// part does not: what the part shows at the two points must turn as well.
Bend bend_of(const ExactField& field, std::span<const std::uint32_t> candidates,
             const CellSurface& surface, double size, double tolerance) {
  const double limit = tolerance / (kBendShare * size * size);
  Bend bend = Bend::even;
  for (const CellSurface::Point& p : surface.all())
    for (const CellSurface::Point& q :
         surface.all().first(static_cast<std::size_t>(&p - surface.points))) {
      const double most = limit * std::max(distance(p.position, q.position), size);
      const Vec3 seen = p.normal - q.normal;
      if (dot(seen, seen) <= most * most) continue;
      bend = Bend::crease;
      const Vec3 first = field.gradient(q.position, p.at) - p.normal,
                 last = field.gradient(p.position, q.at) - q.normal;
      if (std::max(dot(first, first), dot(last, last)) <= most * most) continue;
      if (!turns_at_once(field, candidates, p, q, size, tolerance)) return Bend::face;
    }
  return bend;
}

bool shows_more(const ExactField& field, const Lattice& lattice, const CellView& cell,
                const CellLimits& limits) {
  // A cell that may bend and whose owners are all seen has nothing that a point could show.
  if (limits.bend > limits.near && cell.stock_seen && cell.all_seen) return false;
  const Points points(lattice, cell, field.is_turned(cell.candidates));
  const Views views{field, cell, limits};
  return Scan(field, points, views).finds(cell.candidates);
}

bool hides_surface(const ExactField& field, const Lattice& lattice, const CellView& cell,
                   double depth) {
  const Points points(lattice, cell, field.is_turned(cell.candidates));
  const Sides sides{field, cell, cell.is_inside ? -1.0 : 1.0, depth};
  return Scan(field, points, sides).finds(cell.candidates);
}

}  // namespace mrsim::detail
