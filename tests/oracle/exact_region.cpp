#include "oracle/exact_region.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/General_polygon_set_2.h>
#include <CGAL/Gps_circle_segment_traits_2.h>

namespace mrsim::testing {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Number = Kernel::FT;
using Point = Kernel::Point_2;
using Traits = CGAL::Gps_circle_segment_traits_2<Kernel>;
using Polygon = Traits::Polygon_2;
using Holed = Traits::Polygon_with_holes_2;
using Curve = Traits::Curve_2;
using Piece = Traits::X_monotone_curve_2;
using Set = CGAL::General_polygon_set_2<Traits>;

constexpr double kPi = std::numbers::pi;
// Where an arc runs along the segment it draws: a span of 2e-7 rad is left out, 1e-14 of R high.
constexpr double kGraze = 1e-7;

struct Unit {
  Number x, y;
};

// A rational point of the unit circle at the angle, by half of its tangent.
Unit unit(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  const Number t = s / (1 + std::fabs(c)), below = 1 + t * t;
  const Number x = (1 - t * t) / below;
  return {c < 0 ? Number(-x) : x, 2 * t / below};
}

Point point(Vec2 p) { return {p.x, p.y}; }
Point at(Vec2 center, const Number& radius, const Unit& u) {
  return {center.x + radius * u.x, center.y + radius * u.y};
}

// A closed boundary of segments and arcs, made a polygon the right way round.
class Outline {
 public:
  void line(const Point& a, const Point& b) {
    if (a != b) add(Curve(a, b));
  }
  /// The shorter way, of less than half a turn.
  void arc(const Point& a, const Point& b, Vec2 center, double radius, bool left) {
    const Kernel::Circle_2 circle(point(center), Number(radius) * radius,
                                  left ? CGAL::COUNTERCLOCKWISE : CGAL::CLOCKWISE);
    add(Curve(circle, {a.x(), a.y()}, {b.x(), b.y()}));
  }
  void circle(Vec2 center, double radius) {
    add(Curve(Kernel::Circle_2(point(center), Number(radius) * radius, CGAL::COUNTERCLOCKWISE)));
  }
  Polygon polygon() {
    if (polygon_.orientation() == CGAL::CLOCKWISE) polygon_.reverse_orientation();
    return polygon_;
  }

 private:
  void add(const Curve& curve) {
    std::vector<boost::variant<Traits::Point_2, Piece>> parts;
    Traits().make_x_monotone_2_object()(curve, std::back_inserter(parts));
    for (const auto& part : parts) polygon_.push_back(boost::get<Piece>(part));
  }
  Polygon polygon_;
};

Vec2 to_double(const Traits::Point_2& p) {
  return {CGAL::to_double(p.x()), CGAL::to_double(p.y())};
}

// Angle from a to b about the centre of an x-monotone arc: at most half a turn.
double turn_of(const Piece& piece, Vec2 a, Vec2 b) {
  const double angle = std::atan2(cross(a, b), dot(a, b));
  const bool left = piece.orientation() == CGAL::COUNTERCLOCKWISE;
  if (std::fabs(angle) < 1) return left ? std::max(angle, 0.0) : std::min(angle, 0.0);
  return left ? std::fabs(angle) : -std::fabs(angle);
}

ExactRegion::Measure measure(const Polygon& polygon) {
  ExactRegion::Measure sum;
  for (auto it = polygon.curves_begin(); it != polygon.curves_end(); ++it) {
    const Vec2 p = to_double(it->source()), q = to_double(it->target());
    const double twice = cross(p, q);
    ++sum.pieces;
    sum.area += twice / 2;
    sum.moment += twice * (p.x + q.x) / 6;
    if (it->is_linear()) {
      sum.outline += length(q - p);
      continue;
    }
    const auto circle = it->supporting_circle();
    const Vec2 center{CGAL::to_double(circle.center().x()), CGAL::to_double(circle.center().y())};
    const double radius = std::sqrt(CGAL::to_double(circle.squared_radius()));
    const double turn = turn_of(*it, p - center, q - center), half = turn / 2;
    const double segment = radius * radius / 2 * (turn - std::sin(turn));
    sum.outline += radius * std::fabs(turn);
    sum.turns += std::fabs(turn);
    const Vec2 chord = q - p;
    const double sine = std::sin(half);
    // The segment's centroid lies beyond the middle of the arc's chord, to the right of it.
    const double across = length(chord) > 0 ? chord.y / length(chord) : 0;
    sum.area += segment;
    sum.moment += segment * center.x +
                  2.0 / 3 * radius * radius * radius * sine * sine * std::fabs(sine) * across;
  }
  return sum;
}

// The parts of a turn between the directions that a segment grazes.
std::vector<std::pair<double, double>> spans(double begin, double sweep, double normal) {
  const double lo = std::min(begin, begin + sweep), hi = std::max(begin, begin + sweep);
  std::vector<std::pair<double, double>> out;
  for (double k = std::floor((lo - normal) / (kPi / 2)) - 1;; ++k) {
    const double from = normal + k * (kPi / 2) + kGraze, to = from + kPi / 2 - 2 * kGraze;
    if (from >= hi) return out;
    const double a = std::max(from, lo), b = std::min(to, hi);
    if (b > a + kGraze / 10) out.emplace_back(a, b);
  }
}

}  // namespace

struct ExactRegion::Pieces {
  std::vector<Polygon> polygons;  // not united yet
  std::optional<Set> set;

  void add(Outline outline) {
    polygons.push_back(outline.polygon());
    set.reset();
  }
  const Set& united() {
    if (!set) {
      set.emplace();
      set->join(polygons.begin(), polygons.end());
    }
    return *set;
  }
};

ExactRegion::ExactRegion() : pieces_(std::make_unique<Pieces>()) {}
ExactRegion::ExactRegion(ExactRegion&&) noexcept = default;
ExactRegion& ExactRegion::operator=(ExactRegion&&) noexcept = default;
ExactRegion::~ExactRegion() = default;

void ExactRegion::add_disc(Vec2 center, double radius) {
  if (radius <= 0) return;
  Outline o;
  o.circle(center, radius);
  pieces_->add(std::move(o));
}

void ExactRegion::add_bar(Vec2 a, Vec2 b, double radius) {
  add_disc(a, radius);
  add_disc(b, radius);
  if (radius <= 0 || (a.x == b.x && a.y == b.y)) return;
  const Unit u = unit(std::atan2(b.x - a.x, a.y - b.y));  // across
  const Point corners[] = {at(a, radius, u), at(a, -radius, u), at(b, -radius, u),
                           at(b, radius, u)};
  Outline o;
  for (int k = 0; k < 4; ++k) o.line(corners[k], corners[(k + 1) % 4]);
  pieces_->add(std::move(o));
}

void ExactRegion::add_arc(Vec2 center, double radius, double begin, double sweep, double width) {
  if (std::fabs(sweep) > 2 * kPi) sweep = std::copysign(2 * kPi, sweep);
  const int count = width > 0 ? 1 + static_cast<int>(std::fabs(sweep) / 1.6) : 0;
  const double outer = radius + width, inner = std::max(0.0, radius - width);
  Unit u = unit(begin);
  for (int k = 1; k <= count; ++k) {
    Unit v = unit(begin + sweep * k / count);
    Outline o;
    const bool left = sweep > 0;
    o.line(at(center, inner, u), at(center, outer, u));
    o.arc(at(center, outer, u), at(center, outer, v), center, outer, left);
    o.line(at(center, outer, v), at(center, inner, v));
    if (inner > 0) o.arc(at(center, inner, v), at(center, inner, u), center, inner, !left);
    pieces_->add(std::move(o));
    u = v;
  }
  for (const double angle : {begin, begin + sweep})
    add_disc(center + radius * Vec2{std::cos(angle), std::sin(angle)}, width);
}

void ExactRegion::add_polygon(std::span<const Vec2> corners) {
  if (corners.size() < 3) return;
  Outline o;
  for (std::size_t k = 0; k < corners.size(); ++k)
    o.line(point(corners[k]), point(corners[(k + 1) % corners.size()]));
  pieces_->add(std::move(o));
}

void ExactRegion::add_drawn_segment(Vec2 a, Vec2 b, double radius, double begin, double sweep) {
  const double normal = std::atan2(b.x - a.x, a.y - b.y);
  for (const auto& [from, to] : spans(begin, sweep, normal)) {
    const Unit u = unit(from), v = unit(to);
    Outline o;
    o.arc(at(a, radius, u), at(a, radius, v), a, radius, true);
    o.line(at(a, radius, v), at(b, radius, v));
    o.arc(at(b, radius, v), at(b, radius, u), b, radius, false);
    o.line(at(b, radius, u), at(a, radius, u));
    pieces_->add(std::move(o));
  }
}

void ExactRegion::add_mirrored() {
  const std::size_t count = pieces_->polygons.size();
  for (std::size_t k = 0; k < count; ++k) {
    Polygon mirrored;
    const Polygon& original = pieces_->polygons[k];
    std::vector<Piece> reversed(original.curves_begin(), original.curves_end());
    std::reverse(reversed.begin(), reversed.end());
    for (const Piece& c : reversed) {
      const Traits::Point_2 p(-c.target().x(), c.target().y()), q(-c.source().x(), c.source().y());
      if (c.is_linear()) {
        const auto l = c.supporting_line();
        mirrored.push_back(Piece(Kernel::Line_2(-l.a(), l.b(), l.c()), p, q));
      } else {
        const auto s = c.supporting_circle();
        const Kernel::Circle_2 circle({-s.center().x(), s.center().y()}, s.squared_radius());
        mirrored.push_back(Piece(circle, p, q, c.orientation()));
      }
    }
    pieces_->polygons.push_back(mirrored);
  }
  pieces_->set.reset();
}

ExactRegion::Measure ExactRegion::within(Vec2 lo, Vec2 hi) const {
  Outline box;
  const Point corners[] = {{lo.x, lo.y}, {hi.x, lo.y}, {hi.x, hi.y}, {lo.x, hi.y}};
  for (int k = 0; k < 4; ++k) box.line(corners[k], corners[(k + 1) % 4]);
  Set cut = pieces_->united();
  cut.intersection(box.polygon());
  std::vector<Holed> parts;
  cut.polygons_with_holes(std::back_inserter(parts));
  Measure sum;
  const auto add = [&](const Polygon& polygon) {
    const Measure m = measure(polygon);  // holes run clockwise
    sum.area += m.area, sum.moment += m.moment;
    sum.outline += m.outline, sum.turns += m.turns, sum.pieces += m.pieces;
  };
  for (const Holed& part : parts) {
    add(part.outer_boundary());
    std::for_each(part.holes_begin(), part.holes_end(), add);
  }
  return sum;
}

bool ExactRegion::crosses_axis() const {
  for (const Polygon& polygon : pieces_->polygons)
    if (polygon.bbox().xmin() < 0) return true;
  return false;
}

bool ExactRegion::contains(Vec2 p) const {
  return pieces_->united().oriented_side(Traits::Point_2(Number(p.x), Number(p.y))) ==
         CGAL::ON_POSITIVE_SIDE;
}

}  // namespace mrsim::testing
