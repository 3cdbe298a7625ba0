#include "removal/stock/recognise_stock.h"

#include "core/numbers/rounding.h"
#include "core/numbers/units.h"
#include "core/numbers/vec.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include <fmt/format.h>

namespace mrsim {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

struct Candidate {
  std::vector<Vec3> points;
  std::span<const Triangle> triangles;
  Box3 bounds;
  double tolerance = 0;  // mm, 4 float32 ulps of the largest coordinate
  double volume = 0;
};

// Distance from |x| to the next float.
double float_ulp(double x) {
  const float magnitude = float(std::fabs(x));
  return double(std::nextafter(magnitude, std::numeric_limits<float>::infinity())) - magnitude;
}

// Whether each side of a triangle is that of exactly one other triangle, in the other direction.
bool is_closed(std::span<const Triangle> triangles) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> sides, reversed;
  for (const Triangle& t : triangles)
    for (int k = 0; k < 3; ++k) {
      sides.emplace_back(t[k], t[(k + 1) % 3]);
      reversed.emplace_back(t[(k + 1) % 3], t[k]);
    }
  std::sort(sides.begin(), sides.end());
  std::sort(reversed.begin(), reversed.end());
  return sides == reversed && std::adjacent_find(sides.begin(), sides.end()) == sides.end();
}

double volume_of(const Candidate& c) {
  const Vec3 center = 0.5 * (c.bounds.lo + c.bounds.hi);
  double six = 0;
  for (const Triangle& t : c.triangles)
    six += dot(c.points[t[0]] - center, cross(c.points[t[1]] - center, c.points[t[2]] - center));
  return six / 6;
}

std::optional<Candidate> make_candidate(const TriMesh& mesh) {
  Candidate c;
  c.triangles = mesh.triangles;
  for (const auto& v : mesh.vertices) c.points.push_back({v[0], v[1], v[2]});
  for (const Triangle& t : c.triangles)
    for (const std::uint32_t v : t) {
      if (v >= c.points.size()) return {};
      extend(c.bounds, c.points[v]);
    }
  if (is_empty(c.bounds)) return {};
  double largest = 0;
  for (int i = 0; i < 3; ++i)
    largest = std::max(
        {largest, std::fabs(component(c.bounds.lo, i)), std::fabs(component(c.bounds.hi, i))});
  c.tolerance = 4 * float_ulp(largest);
  c.volume = volume_of(c);
  return c;
}

// The decimal with the fewest places within `slack` of x: what was typed before it became a float.
double shortest_decimal(double x, double slack) {
  double scale = 1;
  for (int places = 0; places <= 7; ++places, scale *= 10) {
    const double rounded = std::round(x * scale) / scale;
    if (std::fabs(rounded - x) <= slack) return rounded + 0.0;
  }
  return x;
}

// Half an ulp of the numbers themselves: snapping undoes the rounding to float, no more.
double rounding_of(double x) { return std::max(0.51 * float_ulp(x), kRounding); }

bool near(double a, double b, double tolerance) { return std::fabs(a - b) <= tolerance; }

Vec3 normal_of(const Candidate& c, const Triangle& t) {
  return cross(c.points[t[1]] - c.points[t[0]], c.points[t[2]] - c.points[t[0]]);
}

// All three corners on the plane coordinate[axis] = at.
bool in_plane(const Candidate& c, const Triangle& t, int axis, double at) {
  return std::all_of(t.begin(), t.end(), [&](std::uint32_t v) {
    return near(component(c.points[v], axis), at, c.tolerance);
  });
}

// ... and looking along `direction` (a triangle without area looks everywhere).
bool fits_plane(const Candidate& c, const Triangle& t, int axis, double at, int direction) {
  return in_plane(c, t, axis, at) && direction * component(normal_of(c, t), axis) >= 0;
}

std::optional<StockShape> as_box(const Candidate& c) {
  Box3 box;
  for (int i = 0; i < 3; ++i) {
    const double lo = component(c.bounds.lo, i), hi = component(c.bounds.hi, i);
    component(box.lo, i) = shortest_decimal(lo, rounding_of(lo));
    component(box.hi, i) = shortest_decimal(hi, rounding_of(hi));
    if (hi - lo <= 16 * c.tolerance) return {};
  }
  for (const Triangle& t : c.triangles) {
    bool fits = false;
    for (int i = 0; i < 3 && !fits; ++i)
      fits = fits_plane(c, t, i, component(box.lo, i), -1) ||
             fits_plane(c, t, i, component(box.hi, i), 1);
    if (!fits) return {};
  }
  // Outward triangles in the faces of a box could still cover it twice: its volume decides.
  const Vec3 side = box.hi - box.lo;
  if (!near(c.volume, side.x * side.y * side.z, 1e-3 * side.x * side.y * side.z)) return {};
  StockShape shape;
  shape.kind = StockShape::Kind::box;
  shape.box = box;
  return shape;
}

struct Circle {
  double x = 0, y = 0, radius = 0;
  double distance(const Vec3& p) const { return length(Vec2{p.x - x, p.y - y}); }
};

// Kasa's fit (least squares of x^2 + y^2 - 2 a x - 2 b y - k) to the points near `guess`, which is
// within a few ulps already: averaging brings it below one.
Circle refined(const Candidate& c, const Circle& guess) {
  double n = 0, suu = 0, suv = 0, svv = 0, su = 0, sv = 0, sw = 0, suw = 0, svw = 0;
  for (const Vec3& p : c.points) {
    if (!near(guess.distance(p), guess.radius, 16 * c.tolerance)) continue;
    const double u = (p.x - guess.x) / guess.radius, v = (p.y - guess.y) / guess.radius;
    const double w = u * u + v * v - 1;
    n += 1, su += u, sv += v, suu += u * u, suv += u * v, svv += v * v;
    sw += w, suw += u * w, svw += v * w;
  }
  const double cuu = suu - su * su / n, cuv = suv - su * sv / n, cvv = svv - sv * sv / n;
  const double cuw = suw - su * sw / n, cvw = svw - sv * sw / n;
  const double det = cuu * cvv - cuv * cuv;
  if (n < 3 || !(det > 1e-6 * n * n)) return guess;
  const double a = (cuw * cvv - cvw * cuv) / det / 2, b = (cvw * cuu - cuw * cuv) / det / 2;
  const double k = (sw - 2 * a * su - 2 * b * sv) / n;
  return {guess.x + a * guess.radius, guess.y + b * guess.radius,
          guess.radius * std::sqrt(std::max(0.0, 1 + k + a * a + b * b))};
}

// The circle through the vertices that are extreme in three directions: those lie on the outer
// face, whatever else the mesh has.
std::optional<Circle> outer_circle(const Candidate& c) {
  const Vec2 directions[3] = {{1, 0.013}, {-0.5, 0.866}, {-0.5, -0.866}};
  Vec2 on[3];
  for (int i = 0; i < 3; ++i) {
    const auto along = [&](const Vec3& p) { return dot(directions[i], Vec2{p.x, p.y}); };
    const auto best =
        std::max_element(c.points.begin(), c.points.end(),
                         [&](const Vec3& a, const Vec3& b) { return along(a) < along(b); });
    on[i] = {best->x, best->y};
  }
  const Vec2 a = on[1] - on[0], b = on[2] - on[0];
  const double d = 2 * cross(a, b);
  if (!(std::fabs(d) > 1e-3 * dot(a, a))) return {};
  const Vec2 m{(b.y * dot(a, a) - a.y * dot(b, b)) / d, (a.x * dot(b, b) - b.x * dot(a, a)) / d};
  Circle circle = refined(c, {on[0].x + m.x, on[0].y + m.y, length(m)});
  circle.x = shortest_decimal(circle.x, c.tolerance);
  circle.y = shortest_decimal(circle.y, c.tolerance);
  circle.radius = shortest_decimal(2 * circle.radius, 2 * c.tolerance) / 2;
  return circle;
}

// Whether the triangle is a facet of the round wall: its corners on it, its widest chord short
// enough, its normal away from the axis (or towards it, direction -1).
bool fits_wall(const Candidate& c, const Triangle& t, const Circle& circle, int direction) {
  double widest = 0;
  Vec3 middle;
  for (int k = 0; k < 3; ++k) {
    const Vec3& p = c.points[t[k]];
    const Vec3& q = c.points[t[(k + 1) % 3]];
    if (!near(circle.distance(p), circle.radius, c.tolerance)) return false;
    widest = std::max(widest, length(Vec2{p.x - q.x, p.y - q.y}));
    middle += (1.0 / 3) * p;
  }
  const double longest_chord = 2 * circle.radius * std::sin(kPi / kFewestFacets);
  if (widest > longest_chord + 2 * c.tolerance) return false;
  const double half = widest / 2;
  const double sagitta =
      half * half / (circle.radius + std::sqrt(circle.radius * circle.radius - half * half));
  if (!(sagitta < kLargestChordError)) return false;
  const Vec3 n = normal_of(c, t);
  return direction * (n.x * (middle.x - circle.x) + n.y * (middle.y - circle.y)) >= 0;
}

bool all_facets_fit(const Candidate& c, const Circle& outer, const Circle& inner, double z0,
                    double z1) {
  return std::all_of(c.triangles.begin(), c.triangles.end(), [&](const Triangle& t) {
    return fits_plane(c, t, 2, z0, -1) || fits_plane(c, t, 2, z1, 1) || fits_wall(c, t, outer, 1) ||
           (inner.radius > 0 && fits_wall(c, t, inner, -1));
  });
}

bool all_points_between(const Candidate& c, const Circle& outer, double inner_radius) {
  return std::all_of(c.points.begin(), c.points.end(), [&](const Vec3& p) {
    const double r = outer.distance(p);
    return r <= outer.radius + c.tolerance && r >= inner_radius - c.tolerance;
  });
}

std::optional<StockShape> as_round(const Candidate& c) {
  const std::optional<Circle> outer = outer_circle(c);
  if (!outer || !(outer->radius > 16 * c.tolerance)) return {};
  const double z0 = shortest_decimal(c.bounds.lo.z, rounding_of(c.bounds.lo.z));
  const double z1 = shortest_decimal(c.bounds.hi.z, rounding_of(c.bounds.hi.z));
  Circle inner = *outer;
  inner.radius = 0;
  if (!all_facets_fit(c, *outer, inner, z0, z1)) {  // not a cylinder; a tube?
    double least = outer->radius, most = 0;
    for (const Vec3& p : c.points) least = std::min(least, outer->distance(p));
    for (const Vec3& p : c.points)
      if (outer->distance(p) < least + 2 * c.tolerance) most = std::max(most, outer->distance(p));
    inner.radius = shortest_decimal(least + most, 2 * c.tolerance) / 2;
    if (!(inner.radius > 16 * c.tolerance) || !all_facets_fit(c, *outer, inner, z0, z1)) return {};
  }
  if (!all_points_between(c, *outer, inner.radius)) return {};
  const double exact =
      kPi * (outer->radius * outer->radius - inner.radius * inner.radius) * (z1 - z0);
  // Facets change the volume by up to 0.2 % of a disc, of a thin tube by more; a surface that is
  // covered twice by 100 %.
  if (!(std::fabs(c.volume - exact) < 0.25 * exact)) return {};
  StockShape shape;
  shape.kind = inner.radius > 0 ? StockShape::Kind::tube : StockShape::Kind::cylinder;
  shape.outer_radius = outer->radius;
  shape.inner_radius = inner.radius;
  shape.axis_point = {outer->x, outer->y, 0};
  shape.box = {{outer->x - outer->radius, outer->y - outer->radius, z0},
               {outer->x + outer->radius, outer->y + outer->radius, z1}};
  return shape;
}

std::string axis_text(const StockShape& s) {
  if (s.axis_point.x == 0 && s.axis_point.y == 0) return "";
  return fmt::format(", axis at X{:.6g} Y{:.6g}", s.axis_point.x, s.axis_point.y);
}

}  // namespace

std::string describe_shape(const StockShape& s) {
  const Vec3 side = s.box.hi - s.box.lo;
  switch (s.kind) {
    case StockShape::Kind::box:
      return fmt::format("box {:.6g} x {:.6g} x {:.6g} mm", side.x, side.y, side.z);
    case StockShape::Kind::cylinder:
      return fmt::format("cylinder d {:.6g} x {:.6g} mm{}", 2 * s.outer_radius, side.z,
                         axis_text(s));
    case StockShape::Kind::tube:
      return fmt::format("tube d {:.6g} / {:.6g} x {:.6g} mm{}", 2 * s.outer_radius,
                         2 * s.inner_radius, side.z, axis_text(s));
    case StockShape::Kind::mesh:
      break;
  }
  return fmt::format("mesh of {} triangles, {:.6g} x {:.6g} x {:.6g} mm", s.mesh.triangles.size(),
                     side.x, side.y, side.z);
}

StockShape recognise_stock(TriMesh mesh, const StockOptions& options, const std::string& source) {
  const std::string from = source.empty() ? "" : fmt::format(" (from {})", source);
  if (options.exact_primitives)
    if (const std::optional<Candidate> candidate = make_candidate(mesh)) {
      std::optional<StockShape> exact = as_box(*candidate);
      if (!exact) exact = as_round(*candidate);
      // Last, because it sorts: most meshes have failed before.
      if (exact && is_closed(candidate->triangles)) {
        exact->description = describe_shape(*exact) + ", exact" + from;
        return *std::move(exact);
      }
    }
  StockShape shape;
  shape.kind = StockShape::Kind::mesh;
  for (const auto& v : mesh.vertices) extend(shape.box, Vec3{v[0], v[1], v[2]});
  shape.mesh = std::move(mesh);
  shape.description = describe_shape(shape) + from;
  return shape;
}

}  // namespace mrsim
