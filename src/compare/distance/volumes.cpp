#include "compare/distance/volumes.h"

#include "compare/distance/sampling.h"
#include "core/numbers/vec.h"
#include "core/process/parallel.h"
#include "mesh/solid/check.h"
#include "mesh/solid/half_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

namespace mrsim {
namespace {

constexpr std::size_t kCells = 512;  // a side; about one ray a cell

// Crossings that are held at once: 16 MB. Meshes of many layers have thousands on each ray.
constexpr std::size_t kHeldCrossings = std::size_t(1) << 20;

struct RayCrossing {
  double z;
  std::int8_t first, second;  // steps of the winding numbers upwards
};

// Rays from `begin` to before `end`, as the grid numbers them.
struct RayRange {
  std::uint32_t begin = 0, end = 0;
};

// The rays, sorted into cells of the outline so that a triangle finds those below it.
class RayGrid {
 public:
  RayGrid(const Box3& box, std::size_t rays) : box_(box), begin_(kCells * kCells + 1, 0) {
    std::vector<std::pair<std::uint32_t, Vec2>> keyed(rays);
    for (std::size_t i = 0; i < rays; ++i) {
      const Vec2 at = spread_point(i);
      const Vec2 p{box.lo.x + at.x * (box.hi.x - box.lo.x),
                   box.lo.y + at.y * (box.hi.y - box.lo.y)};
      keyed[i] = {cell(p.x, 0) + std::uint32_t(kCells) * cell(p.y, 1), p};
    }
    std::stable_sort(keyed.begin(), keyed.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [key, point] : keyed) {
      ++begin_[key + 1];
      rays_.push_back(point);
    }
    for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
  }

  std::uint32_t cell(double x, int axis) const {
    const double lo = component(box_.lo, axis), size = component(box_.hi, axis) - lo;
    const double at = size > 0 ? (x - lo) / size * double(kCells) : 0;
    return std::uint32_t(std::clamp(at, 0.0, double(kCells - 1)));
  }
  // Rays of `range` in the cells of the box from lo to hi.
  template <class Visit>
  void visit(const Vec3& lo, const Vec3& hi, RayRange range, Visit visit_ray) const {
    const std::uint32_t x0 = cell(lo.x, 0), x1 = cell(hi.x, 0);
    for (std::uint32_t y = cell(lo.y, 1); y <= cell(hi.y, 1); ++y) {
      const std::uint32_t last = std::min(range.end, begin_[y * kCells + x1 + 1]);
      for (std::uint32_t i = std::max(range.begin, begin_[y * kCells + x0]); i < last; ++i)
        visit_ray(i, rays_[i]);
    }
  }

 private:
  Box3 box_;
  std::vector<std::uint32_t> begin_;
  std::vector<Vec2> rays_;
};

double turn(Vec2 a, Vec2 b, Vec2 p) { return cross(b - a, p - a); }

// Side of p to the directed edge, the same value with opposite sign for the neighbour's edge, so
// that a ray through an edge crosses exactly one of two triangles.
bool left_of(Vec2 a, Vec2 b, Vec2 p) {
  const bool swap = b.x < a.x || (b.x == a.x && b.y < a.y);
  const double t = swap ? -turn(b, a, p) : turn(a, b, p);
  return swap ? t > 0 : t >= 0;
}

// Calls body(ray, z, step) for each crossing of a ray of `range` with the mesh; `step` is that of
// the winding number upwards.
template <class Body>
void cross_mesh(const TriMesh& mesh, const RayGrid& grid, RayRange range, Body body) {
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    const Vec3 n = area_normal(mesh, f);
    if (n.z == 0) continue;
    Vec3 a = corner(mesh, f, 0), b = corner(mesh, f, 1);
    const Vec3 c = corner(mesh, f, 2);
    if (n.z < 0) std::swap(a, b);
    const Vec2 pa{a.x, a.y}, pb{b.x, b.y}, pc{c.x, c.y};
    const auto step = std::int8_t(n.z < 0 ? 1 : -1);  // upwards through a floor: into the solid
    grid.visit(min(a, min(b, c)), max(a, max(b, c)), range, [&](std::uint32_t ray, Vec2 p) {
      if (!left_of(pa, pb, p) || !left_of(pb, pc, p) || !left_of(pc, pa, p)) return;
      body(ray, c.z - (n.x * (p.x - c.x) + n.y * (p.y - c.y)) / n.z, step);
    });
  }
}

// Two meshes and the rays through them.
class CrossedRays {
 public:
  CrossedRays(const TriMesh& first, const TriMesh& second, const Box3& box, std::size_t rays,
              int threads)
      : meshes_{&first, &second}, grid_(box, rays), threads_(threads) {
    parallel_for(2, threads, [&](std::size_t i) {
      counts_[i].resize(rays, 0);
      cross_mesh(*meshes_[i], grid_, {0, std::uint32_t(rays)},
                 [&](std::uint32_t ray, double, std::int8_t) { ++counts_[i][ray]; });
    });
  }

  // Calls body(crossings) for each ray that crosses anything, by its number; z ascends, and of
  // equal ones those of the first mesh come first.
  template <class Body>
  void for_each_ray(Body body) const {
    RayRange range;
    for (; range.begin < counts_[0].size(); range.begin = range.end) {
      std::vector<std::size_t> ends(1, 0);  // of each ray's crossings
      for (range.end = range.begin; range.end < counts_[0].size(); ++range.end) {
        const std::size_t next = ends.back() + counts_[0][range.end] + counts_[1][range.end];
        if (next > kHeldCrossings && range.end > range.begin) break;
        ends.push_back(next);
      }
      std::vector<RayCrossing> all = crossings(range, ends);
      for (std::size_t r = 0; r + 1 < ends.size(); ++r) {
        const std::span<RayCrossing> ray = std::span(all).subspan(ends[r], ends[r + 1] - ends[r]);
        std::stable_sort(ray.begin(), ray.end(),
                         [](const RayCrossing& a, const RayCrossing& b) { return a.z < b.z; });
        if (!ray.empty()) body(std::span<const RayCrossing>(ray));
      }
    }
  }

 private:
  std::vector<RayCrossing> crossings(RayRange range, const std::vector<std::size_t>& ends) const {
    std::vector<RayCrossing> out(ends.back());
    parallel_for(2, threads_, [&](std::size_t i) {
      std::vector<std::size_t> at(ends.begin(), ends.end() - 1);
      for (std::size_t r = 0; i == 1 && r < at.size(); ++r) at[r] += counts_[0][range.begin + r];
      cross_mesh(*meshes_[i], grid_, range, [&](std::uint32_t ray, double z, std::int8_t step) {
        out[at[ray - range.begin]++] = {z, i == 0 ? step : std::int8_t(0),
                                        i == 0 ? std::int8_t(0) : step};
      });
    });
    return out;
  }

  std::array<const TriMesh*, 2> meshes_;
  RayGrid grid_;
  int threads_;
  std::array<std::vector<std::uint32_t>, 2> counts_;  // by mesh and ray
};

// Along one ray.
struct Lengths {
  double first = 0, second = 0;  // inside of one mesh alone
  double excess = 0;             // the winding number of the first less that of the second
};

Lengths lengths_along(std::span<const RayCrossing> ray) {
  Lengths out;
  int first = 0, second = 0;
  double z = ray.front().z;
  for (const RayCrossing& c : ray) {
    const double dz = c.z - z;
    if (first > 0 && second <= 0) out.first += dz;
    if (second > 0 && first <= 0) out.second += dz;
    out.excess += (first - second) * dz;
    z = c.z;
    first += c.first;
    second += c.second;
  }
  return out;
}

// The mean of a length over the rays, corrected by another length whose true mean is known (a
// control variate): rays that miss some of the one mostly miss as much of the other. An upright
// wall 0.05 mm thick is met by few rays, but both volumes are known.
class ControlledMean {
 public:
  void add(double length, double known) {
    sum_ += length;
    square_ += length * length;
    known_ += known;
    known_square_ += known * known;
    product_ += length * known;
  }
  struct Mean {
    double value = 0, error = 0;  // of as many independent rays
  };
  Mean mean(double true_known, double rays) const {
    const double own = square_ - sum_ * sum_ / rays;
    const double other = known_square_ - known_ * known_ / rays;
    const double both = product_ - sum_ * known_ / rays;
    const double share = other > 0 ? both / other : 0;
    const double left = std::max(0.0, own - share * both);
    return {std::max(0.0, sum_ / rays - share * (known_ / rays - true_known)),
            std::sqrt(left) / rays};
  }

 private:
  double sum_ = 0, square_ = 0, known_ = 0, known_square_ = 0, product_ = 0;
};

}  // namespace

VolumeDifference volume_difference(const TriMesh& first, const TriMesh& second, std::size_t rays,
                                   int threads) {
  Box3 box;
  for (const TriMesh* mesh : {&first, &second})
    for (const auto& v : mesh->vertices) extend(box, to_vec(v));
  ControlledMean excess, gouge;
  CrossedRays(first, second, box, rays, threads)
      .for_each_ray([&](std::span<const RayCrossing> ray) {
        const Lengths l = lengths_along(ray);
        excess.add(l.first, l.excess);
        gouge.add(l.second, l.excess);
      });
  const double outline = (box.hi.x - box.lo.x) * (box.hi.y - box.lo.y);
  if (!(outline > 0)) return {};
  const double known = (signed_volume(first) - signed_volume(second)) / outline;
  const ControlledMean::Mean one = excess.mean(known, double(rays));
  const ControlledMean::Mean other = gouge.mean(known, double(rays));
  // The error for independent rays; rays of the low-discrepancy sequence do better.
  return {outline * one.value, outline * other.value, outline * std::max(one.error, other.error)};
}

}  // namespace mrsim
