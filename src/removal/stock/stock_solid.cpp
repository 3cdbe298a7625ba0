#include "removal/stock/stock_solid.h"

#include "core/numbers/rounding.h"
#include "core/numbers/units.h"
#include "core/numbers/vec.h"
#include "core/process/error.h"
#include "removal/field/face_range.h"

#include <algorithm>
#include <atomic>

namespace mrsim {
namespace {

// Neighbouring triangles whose normals agree within 1e-4 rad are one flat face: float32 coordinates
// are no more precise.
constexpr double kFlatCosine = 1 - 0.5e-8;

constexpr double kLargeFace = 0.01;  ///< of a mesh's area
constexpr double kSmoothBend =
    0.52;  ///< radians, 30 degrees: up to it, an edge draws a curved face

}  // namespace

StockSolid::StockSolid(StockShape shape) : shape_(std::move(shape)) {
  const Vec3 size = shape_.box.hi - shape_.box.lo;
  const bool round =
      shape_.kind == StockShape::Kind::cylinder || shape_.kind == StockShape::Kind::tube;
  if (!(size.x > 0 && size.y > 0 && size.z > 0) ||
      (round && !(shape_.outer_radius > shape_.inner_radius)))
    throw Error("stock-empty", "the stock has no volume: " + shape_.description);
  if (shape_.kind != StockShape::Kind::mesh) return;
  static std::atomic<std::uint64_t> count{0};
  number_ = ++count;
  tree_ = std::make_shared<TriangleTree>(shape_.mesh, TriangleTree::Boxes::pieces);
  find_flat_faces();
  find_bends();
  facets_.area = find_facet_area();
}

void StockSolid::find_bends() {
  for (std::uint32_t t = 0; t < tree_->size(); ++t) {
    const TriangleTree::Corners k = tree_->corners(t);
    const Vec3 ends[4] = {k.a, k.b, k.c, k.a};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t next = tree_->neighbors(t)[i];
      if (next >= t || faces_[next] == faces_[t]) continue;
      const double edge = length(ends[i + 1] - ends[i]);
      const double bend = length(tree_->normal(t) - tree_->normal(next));
      bent_edges_ += edge * bend / 2;
      if (bend > kSmoothBend) continue;
      facets_.bend += edge * bend;
      ++facets_.edges;
    }
  }
}

double StockSolid::find_facet_area() const {
  std::vector<double> areas(planes_.size());
  for (std::uint32_t t = 0; t < tree_->size(); ++t)
    areas[static_cast<std::size_t>(faces_[t])] += tree_->area(t);
  const double all = area();
  double sum = 0;
  for (const double face : areas)
    if (face <= kLargeFace * all) sum += face;
  return sum;
}

void StockSolid::find_flat_faces() {
  faces_.assign(tree_->size(), -1);
  std::vector<std::uint32_t> open;
  for (std::uint32_t seed = 0; seed < tree_->size(); ++seed) {
    if (faces_[seed] >= 0) continue;
    const Vec3 normal = tree_->normal(seed);
    const auto face = static_cast<std::int32_t>(planes_.size());
    planes_.push_back({normal, dot(normal, tree_->corners(seed).a)});
    faces_[seed] = face;
    open.assign(1, seed);
    while (!open.empty()) {
      const std::uint32_t t = open.back();
      open.pop_back();
      for (const std::uint32_t next : tree_->neighbors(t)) {
        if (next >= tree_->size() || faces_[next] >= 0 ||
            dot(tree_->normal(next), normal) < kFlatCosine)
          continue;
        faces_[next] = face;
        open.push_back(next);
      }
    }
  }
}

bool StockSolid::is_turned() const {
  const bool round =
      shape_.kind == StockShape::Kind::cylinder || shape_.kind == StockShape::Kind::tube;
  return round && shape_.axis_point.x == 0 && shape_.axis_point.y == 0;
}

double StockSolid::radius_at(const Vec3& p) const {
  const double dx = p.x - shape_.axis_point.x, dy = p.y - shape_.axis_point.y;
  return std::sqrt(dx * dx + dy * dy);
}

double StockSolid::plan_distance(double x, double y) const {
  if (!is_box()) {
    const double rho = radius_at({x, y, 0}), wall = rho - shape_.outer_radius;
    return shape_.kind == StockShape::Kind::tube ? std::max(wall, shape_.inner_radius - rho) : wall;
  }
  const Box3& b = shape_.box;
  const double dx = std::max(b.lo.x - x, x - b.hi.x), dy = std::max(b.lo.y - y, y - b.hi.y);
  if (dx > 0 && dy > 0) return std::sqrt(dx * dx + dy * dy);
  return std::max(dx, dy);
}

Vec2 StockSolid::plan_normal(double x, double y) const {
  const Vec3 p{x, y, 0};
  const bool is_wall = plan_distance(x, y) == patch_distance(p, kRoundWall);
  const Vec3 normal = gradient(p, is_wall ? kRoundWall : kRoundBore);
  return {normal.x, normal.y};
}

StockSolid::Sample StockSolid::sample(const Vec3& p, double least) const {
  if (shape_.kind == StockShape::Kind::mesh) return sample_mesh(p, least);
  return shape_.kind == StockShape::Kind::box ? sample_box(p) : sample_round(p);
}

// A box in a form that the compiler turns into whole registers.
void StockSolid::distances(std::size_t n, const double* x, const double* y, const double* z,
                           double* out, const double* cut) const {
  if (shape_.kind != StockShape::Kind::box) {
    for (std::size_t k = 0; k < n; ++k)
      out[k] = sample({x[k], y[k], z[k]}, cut != nullptr ? -cut[k] : -kInfinity).distance;
    return;
  }
  const Vec3 lo = shape_.box.lo, hi = shape_.box.hi;
  for (std::size_t k = 0; k < n; ++k) {
    const double a = std::max(lo.x - x[k], x[k] - hi.x), b = std::max(lo.y - y[k], y[k] - hi.y),
                 c = std::max(lo.z - z[k], z[k] - hi.z);
    const double most = std::max(std::max(a, b), c);
    const double u = std::max(a, 0.0), v = std::max(b, 0.0), w = std::max(c, 0.0);
    const double outside = std::sqrt(u * u + v * v + w * w);
    out[k] = most <= 0 ? most : outside;
  }
}

double StockSolid::plane_distance(const Vec3& p) const {
  const Vec3 &lo = shape_.box.lo, &hi = shape_.box.hi;
  return std::max({lo.x - p.x, p.x - hi.x, lo.y - p.y, p.y - hi.y, lo.z - p.z, p.z - hi.z});
}

StockSolid::Sample StockSolid::sample_box(const Vec3& p) const {
  const Box3& b = shape_.box;
  // Signed distances of the six half spaces; of each opposite pair the larger one counts.
  const auto larger = [](double low, double high, std::int32_t patch) {
    return high > low ? Sample{high, patch + 1} : Sample{low, patch};
  };
  const Sample x = larger(b.lo.x - p.x, p.x - b.hi.x, 0), y = larger(b.lo.y - p.y, p.y - b.hi.y, 2),
               z = larger(b.lo.z - p.z, p.z - b.hi.z, 4);
  Sample most = y.distance > x.distance ? y : x;
  if (z.distance > most.distance) most = z;
  if (most.distance <= 0) return most;
  const double u = std::max(x.distance, 0.0), v = std::max(y.distance, 0.0),
               w = std::max(z.distance, 0.0);
  return {std::sqrt(u * u + v * v + w * w), most.patch};
}

StockSolid::Sample StockSolid::sample_round(const Vec3& p) const {
  const double rho = radius_at(p);
  const bool tube = shape_.kind == StockShape::Kind::tube;
  const double wall = rho - shape_.outer_radius,
               bore = tube ? shape_.inner_radius - rho : -kInfinity;
  const double bottom = shape_.box.lo.z - p.z, top = p.z - shape_.box.hi.z;
  const double radial = std::max(wall, bore), axial = std::max(bottom, top);
  const std::int32_t patch = radial >= axial ? (wall >= bore ? kRoundWall : kRoundBore)
                                             : (bottom >= top ? kRoundBottom : kRoundTop);
  if (radial > 0 && axial > 0) return {std::sqrt(radial * radial + axial * axial), patch};
  return {std::max(radial, axial), patch};
}

StockSolid::Sample StockSolid::sample_mesh(const Vec3& p, double least) const {
  // What was found last: of neighbouring points that are deep inside, it shows that they are; of
  // others, its triangle makes the next search short.
  struct Last {
    std::uint64_t solid = 0;
    Vec3 place;
    double distance = 0;
    std::uint32_t triangle = 0;
  };
  static thread_local Last last;
  if (last.solid == number_) {
    const double most = last.distance + mrsim::distance(p, last.place) + kRounding;
    if (most < least) return {most, 0};
  }
  const TriangleTree::Hit hit = tree_->nearest(p, last.triangle);
  last = {number_, p, tree_->signed_distance(p, hit), hit.triangle};
  return {last.distance, faces_[hit.triangle]};
}

Vec3 StockSolid::gradient(const Vec3& p, std::int32_t patch) const {
  if (shape_.kind == StockShape::Kind::mesh) return planes_[static_cast<std::size_t>(patch)].normal;
  if (shape_.kind == StockShape::Kind::box) {
    Vec3 normal;
    component(normal, patch / 2) = patch % 2 ? 1 : -1;
    return normal;
  }
  if (patch == kRoundBottom) return {0, 0, -1};
  if (patch == kRoundTop) return {0, 0, 1};
  const Vec3 radial{p.x - shape_.axis_point.x, p.y - shape_.axis_point.y, 0};
  const double rho = length(radial);
  const double sign = patch == kRoundBore ? -1 : 1;
  return rho > 0 ? (sign / rho) * radial : Vec3{sign, 0, 0};
}

double StockSolid::patch_distance(const Vec3& p, std::int32_t patch) const {
  const Box3& b = shape_.box;
  if (shape_.kind == StockShape::Kind::mesh) {
    const Plane& plane = planes_[static_cast<std::size_t>(patch)];
    return dot(plane.normal, p) - plane.offset;
  }
  if (shape_.kind == StockShape::Kind::box)
    return patch % 2 ? component(p, patch / 2) - component(b.hi, patch / 2)
                     : component(b.lo, patch / 2) - component(p, patch / 2);
  if (patch == kRoundBottom) return b.lo.z - p.z;
  if (patch == kRoundTop) return p.z - b.hi.z;
  return patch == kRoundBore ? shape_.inner_radius - radius_at(p)
                             : radius_at(p) - shape_.outer_radius;
}

FaceRange StockSolid::patch_range(const Corners3& t, std::int32_t patch) const {
  const bool round =
      shape_.kind == StockShape::Kind::cylinder || shape_.kind == StockShape::Kind::tube;
  if (!round || patch == kRoundBottom || patch == kRoundTop)
    return range_of(
        {patch_distance(t[0], patch), patch_distance(t[1], patch), patch_distance(t[2], patch)});
  const Vec3& axis = shape_.axis_point;
  const FaceRange rho = whole_range(length_envelope({Vec2{t[0].x - axis.x, t[0].y - axis.y},
                                                     {t[1].x - axis.x, t[1].y - axis.y},
                                                     {t[2].x - axis.x, t[2].y - axis.y}}));
  if (patch == kRoundBore) return {shape_.inner_radius - rho.hi, shape_.inner_radius - rho.lo};
  return {rho.lo - shape_.outer_radius, rho.hi - shape_.outer_radius};
}

double StockSolid::volume() const {
  if (shape_.kind == StockShape::Kind::mesh) {
    double six = 0;
    for (std::uint32_t t = 0; t < tree_->size(); ++t) {
      const TriangleTree::Corners k = tree_->corners(t);
      six += dot(k.a, cross(k.b, k.c));
    }
    return six / 6;
  }
  const Vec3 size = shape_.box.hi - shape_.box.lo;
  if (shape_.kind == StockShape::Kind::box) return size.x * size.y * size.z;
  const double ro = shape_.outer_radius,
               ri = shape_.kind == StockShape::Kind::tube ? shape_.inner_radius : 0;
  return kPi * (ro * ro - ri * ri) * size.z;
}

double StockSolid::area() const {
  if (shape_.kind == StockShape::Kind::mesh) {
    double sum = 0;
    for (std::uint32_t t = 0; t < tree_->size(); ++t) sum += tree_->area(t);
    return sum;
  }
  const Vec3 size = shape_.box.hi - shape_.box.lo;
  if (shape_.kind == StockShape::Kind::box)
    return 2 * (size.x * size.y + size.y * size.z + size.z * size.x);
  const double ro = shape_.outer_radius,
               ri = shape_.kind == StockShape::Kind::tube ? shape_.inner_radius : 0;
  return kTwoPi * ((ro + ri) * size.z + ro * ro - ri * ri);
}

}  // namespace mrsim
