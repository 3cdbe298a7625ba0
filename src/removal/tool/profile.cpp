#include "removal/tool/profile.h"

#include "core/numbers/rounding.h"
#include "core/process/error.h"
#include "removal/tool/profile_pieces.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mrsim {
namespace {

constexpr double kSameCorner = 1e-12;  // of the radius: rounding of corners

Vec2 left_of(Vec2 d) { return {-d.y, d.x}; }

// Direction of travel at a point of the edge (on the arc: perpendicular to the radius).
Vec2 tangent_at(const ProfileEdge& e, Vec2 at) {
  if (!e.is_arc()) return e.direction;
  const Vec2 t = (1 / e.radius) * left_of(at - e.center);
  return e.convex ? t : -1.0 * t;
}

// Whether the direction w from the centre falls within the arc's sector (less than a full turn; at
// half a turn both forms agree).
bool in_sector(const ProfileEdge& e, Vec2 w) {
  Vec2 s = e.a - e.center, t = e.b - e.center;
  if (!e.convex) std::swap(s, t);
  const bool left_of_start = cross(s, w) >= 0, right_of_end = cross(w, t) >= 0;
  return cross(s, t) >= 0 ? left_of_start && right_of_end : left_of_start || right_of_end;
}

// Signed distance to the edge continued beyond its ends.
double side(const ProfileEdge& e, Vec2 q) {
  if (!e.is_arc()) return -cross(e.direction, q - e.a);
  const double d = length(q - e.center) - e.radius;
  return e.convex ? d : -d;
}

}  // namespace

Vec2 outward(const ProfileEdge& e, Vec2 q) {
  if (!e.is_arc()) return {e.direction.y, -e.direction.x};
  const Vec2 w = q - e.center;
  const double n = length(w);
  if (n == 0) return {e.convex ? 1.0 : -1.0, 0};
  return (e.convex ? 1 / n : -1 / n) * w;
}

struct Profile::Foot {
  double distance = std::numeric_limits<double>::infinity();  // unsigned
  std::size_t edge = 0;
  int at_corner = -1;  // corner index, -1 inside the edge
};

Profile::Profile(std::vector<ProfileEdge> edges) : edges_(std::move(edges)) {
  MRSIM_ASSERT(!edges_.empty());
  for (ProfileEdge& e : edges_) {
    if (e.is_arc()) continue;
    const bool ray = std::isinf(e.b.y);
    e.length = ray ? e.b.y : mrsim::length(e.b - e.a);
    e.direction = ray ? Vec2{0, 1} : (1 / e.length) * (e.b - e.a);
  }
  find_patches();
  find_flags();
}

void Profile::find_patches() {
  corners_.assign(edges_.size() + 1, Corner::convex);
  std::int32_t patch = 0;
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    if (i > 0) {
      const Vec2 in = tangent_at(edges_[i - 1], edges_[i].a),
                 out = tangent_at(edges_[i], edges_[i].a);
      const double turn = cross(in, out);
      if (turn > -kTurnRounding && turn < kTurnRounding && dot(in, out) > 0)
        corners_[i] = Corner::smooth;
      else
        corners_[i] = turn > 0 ? Corner::convex : Corner::reflex;
      if (corners_[i] != Corner::smooth) ++patch;
    }
    edges_[i].patch = patch;
  }
  // Where the profile leaves the axis at a right angle its mirror image continues it.
  const Vec2 first = tangent_at(edges_.front(), edges_.front().a);
  if (first.y < kTurnRounding) corners_.front() = Corner::smooth;
  const ProfileEdge& last = edges_.back();
  if (!std::isinf(last.b.y) && tangent_at(last, last.b).y < kTurnRounding)
    corners_.back() = Corner::smooth;
}

double Profile::max_radius_below(double z) const {
  double most = 0;
  for (const ProfileEdge& e : edges_) {
    if (e.a.y > z) break;  // edges never go down
    most = std::max(most, e.a.x);
    const double top = std::min(z, e.b.y);
    if (e.is_arc()) {
      const double dy =
          std::clamp(e.convex ? 0.0 : top - e.center.y, e.a.y - e.center.y, top - e.center.y);
      const double dx = std::sqrt(std::max(0.0, e.radius * e.radius - dy * dy));
      most = std::max(most, e.center.x + (e.convex ? dx : -dx));
    } else if (std::isinf(e.length) || e.b.y <= z) {
      most = std::max(most, e.b.x);
    } else {
      most = std::max(most, e.a.x + (top - e.a.y) * (e.b.x - e.a.x) / (e.b.y - e.a.y));
    }
  }
  return most;
}

bool Profile::has_sharp_tip() const {
  const Vec2 from = tangent_at(edges_.front(), edges_.front().a);
  return from.x > kTurnRounding && from.y > kTurnRounding;
}

void Profile::find_flags() {
  open_top_ = std::isinf(edges_.back().b.y);
  bottom_ = edges_.front().a.y;
  top_ = edges_.back().b.y;
  widest_ = bottom_;
  double previous = 0;
  bool falling = false;
  for (const ProfileEdge& e : edges_) {
    const Vec2 from = tangent_at(e, e.a), to = e.is_arc() ? tangent_at(e, e.b) : from;
    if (e.is_arc() && !e.convex) is_convex_ = false;
    // An arc that bulges out passes its widest point where its tangent turns from out to in.
    const bool over = e.is_arc() && e.convex && from.x > kTurnRounding && to.x < -kTurnRounding;
    const double reach = over ? e.center.x + e.radius : std::isinf(e.b.y) ? e.a.x : e.b.x;
    const double at = over ? e.center.y : std::isinf(e.b.y) ? e.a.y : e.b.y;
    const bool dips = e.is_arc() && !e.convex && from.x < 0 && to.x > 0;
    if (reach > previous && falling) unimodal_ = false;
    if (dips) unimodal_ = false;
    if (e.a.x > max_radius_) max_radius_ = e.a.x, widest_ = e.a.y;
    if (reach > max_radius_) max_radius_ = reach, widest_ = at;
    if (over || reach < previous || dips) falling = true;
    previous = std::isinf(e.b.y) ? e.a.x : e.b.x;
  }
  for (std::size_t i = 1; i < edges_.size(); ++i)
    if (corners_[i] == Corner::reflex) is_convex_ = false;
  rising_ = open_top_ && !falling;
  find_slab();
  find_disc();
  if (!is_convex_)
    pieces_ = std::make_shared<const std::vector<Profile>>(convex_pieces_of(edges_, corners_));
}

// Flat, bull-nose and ball: [disc of `core`] [quarter circle of `round`] wall [top].
void Profile::find_slab() {
  const std::size_t lid = open_top_ ? 0 : 1, n = edges_.size() - lid;
  if (bottom_ != 0 || n < 2 || n > 3) return;
  const ProfileEdge &low = edges_[n - 2], &wall = edges_[n - 1], &first = edges_.front();
  if (wall.is_arc() || wall.direction.x != 0) return;
  if (lid == 1 && (edges_.back().is_arc() || edges_.back().direction.y != 0)) return;
  const bool disc = !first.is_arc() && first.direction.y == 0;
  const bool quarter = low.is_arc() && low.convex && low.center.y == low.b.y &&
                       low.center.x == low.a.x && low.center.x + low.radius == low.b.x;
  if (n == 2 && disc) {
    is_end_mill_ = true, core_ = max_radius_, round_ = 0;
  } else if (quarter && (n == 2 ? low.center.x == 0 : disc) && top_ >= 2 * low.radius) {
    is_end_mill_ = true, core_ = low.center.x, round_ = low.radius;
  }
}

// [disc] [quarter circle] [wall] [quarter circle] [lid], none of the quarters above half the
// height.
void Profile::find_disc() {
  if (open_top_ || bottom_ != 0) return;
  const auto same = [this](Vec2 a, Vec2 b) { return length(a - b) <= kSameCorner * max_radius_; };
  std::size_t k = 0;
  const auto is_line = [&](Vec2 across) {
    return k < edges_.size() && !edges_[k].is_arc() && dot(edges_[k].direction, across) == 0;
  };
  const auto is_quarter = [&](Vec2 from, Vec2 to) {
    if (k == edges_.size() || !edges_[k].is_arc() || !edges_[k].convex) return false;
    const ProfileEdge& e = edges_[k];
    return same(e.a, e.center + e.radius * from) && same(e.b, e.center + e.radius * to);
  };
  Disc d{.top = top_};
  if (is_line({0, 1})) d.core = edges_[k++].b.x;
  if (is_quarter({0, -1}, {1, 0})) d.round = edges_[k++].radius;
  if (!same({d.core + d.round, 0}, {max_radius_, 0})) return;
  if (is_line({1, 0})) ++k;
  if (is_quarter({1, 0}, {0, 1})) d.lid_round = edges_[k++].radius;
  if (is_line({0, 1})) ++k;
  d.lid_core = max_radius_ - d.lid_round;
  if (k == edges_.size() && 2 * std::max(d.round, d.lid_round) <= top_) disc_ = d;
}

Profile::Foot Profile::nearest(Vec2 q) const {
  Foot best;
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    const ProfileEdge& e = edges_[i];
    Foot foot{0, i, -1};
    if (e.is_arc()) {
      if (in_sector(e, q - e.center)) {
        const double d = side(e, q);
        foot.distance = d < 0 ? -d : d;
      } else {
        const double to_a = length(q - e.a), to_b = length(q - e.b);
        foot.distance = to_a <= to_b ? to_a : to_b;
        foot.at_corner = static_cast<int>(to_a <= to_b ? i : i + 1);
      }
    } else {
      const double t = dot(q - e.a, e.direction);
      if (t <= 0) {
        foot.distance = length(q - e.a), foot.at_corner = static_cast<int>(i);
      } else if (t >= e.length) {
        foot.distance = length(q - e.b), foot.at_corner = static_cast<int>(i + 1);
      } else {
        const double d = side(e, q);
        foot.distance = d < 0 ? -d : d;
      }
    }
    if (foot.distance < best.distance) best = foot;
  }
  return best;
}

// At a corner both edges decide, by their tangents. For where they join nearly smoothly, rounding
// makes the corner the nearest point of places on either side.
bool Profile::is_outside(const Foot& f, Vec2 q) const {
  const ProfileEdge& e = edges_[f.edge];
  if (f.at_corner < 0 || corners_[f.at_corner] == Corner::smooth) return side(e, q) > 0;
  const auto corner = static_cast<std::size_t>(f.at_corner);
  const Vec2 at = corner == f.edge ? e.a : e.b;
  const bool here = dot(outward(e, at), q - at) > 0;
  const std::size_t other = corner == f.edge ? corner - 1 : corner;
  if (other >= edges_.size()) return here;  // on the axis
  const bool there = dot(outward(edges_[other], at), q - at) > 0;
  return corners_[corner] == Corner::convex ? here || there : here && there;
}

double Profile::distance(Vec2 q) const {
  const Foot f = nearest(q);
  return is_outside(f, q) ? f.distance : -f.distance;
}

ProfileSample Profile::sample(Vec2 q) const {
  const Foot f = nearest(q);
  const ProfileEdge& e = edges_[f.edge];
  const Corner corner = f.at_corner < 0 ? Corner::smooth : corners_[f.at_corner];
  ProfileSample s{is_outside(f, q) ? f.distance : -f.distance, outward(e, q), e.patch};
  if (f.at_corner >= 0 && f.distance > 0 && corner != Corner::smooth) {
    const Vec2 v = static_cast<std::size_t>(f.at_corner) == f.edge ? e.a : e.b;
    s.curvature = 1 / s.distance;
    s.gradient = s.curvature * (q - v);
  } else if (e.is_arc()) {
    s.curvature = 1 / (e.convex ? e.radius + s.distance : s.distance - e.radius);
  }
  return s;
}

const ProfileEdge* Profile::nearest_edge(Vec2 q, std::int32_t patch) const {
  const ProfileEdge* best = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const ProfileEdge& e : edges_) {
    if (e.patch != patch) continue;
    double d;
    if (e.is_arc()) {
      const double to_a = length(q - e.a), to_b = length(q - e.b), s = side(e, q);
      d = in_sector(e, q - e.center) ? (s < 0 ? -s : s) : to_a < to_b ? to_a : to_b;
    } else {
      const double t = dot(q - e.a, e.direction);
      const double along = t < 0 ? -t : t > e.length ? t - e.length : 0, s = side(e, q);
      d = std::sqrt(along * along + s * s);
    }
    if (d < least) least = d, best = &e;
  }
  return best;
}

Vec2 Profile::gradient(Vec2 q, std::int32_t patch) const {
  const ProfileEdge* edge = nearest_edge(q, patch);
  return edge != nullptr ? outward(*edge, q) : sample(q).gradient;
}

double Profile::face_distance(Vec2 q, std::int32_t patch) const {
  const ProfileEdge* edge = nearest_edge(q, patch);
  return edge != nullptr ? side(*edge, q) : distance(q);
}

Profile Profile::drawn_out(double travel) const {
  std::vector<ProfileEdge> out;
  bool above = false;
  const auto add = [&](ProfileEdge e) {
    if (above) e.a.y += travel, e.b.y += travel, e.center.y += travel;
    out.push_back(e);
  };
  for (const ProfileEdge& e : edges_) {
    if (!above && e.a.x == max_radius_ && e.a.y == widest_ && !e.is_arc() && e.direction.x == 0) {
      out.push_back({.a = e.a, .b = {e.b.x, e.b.y + travel}});
      above = true;
      continue;
    }
    if (!above && e.a.x == max_radius_ && e.a.y == widest_) {
      out.push_back({.a = e.a, .b = {e.a.x, e.a.y + travel}});
      above = true;
    } else if (!above && e.is_arc() && e.a.y < widest_ && widest_ < e.b.y) {
      // The arc passes the widest place: it is cut there.
      ProfileEdge low = e, high = e;
      low.b = high.a = {max_radius_, widest_};
      add(low);
      out.push_back({.a = low.b, .b = {max_radius_, widest_ + travel}});
      above = true;
      add(high);
      continue;
    }
    add(e);
  }
  return Profile(std::move(out));
}

Profile Profile::extended_up() const {
  std::vector<ProfileEdge> out;
  for (const ProfileEdge& e : edges_)
    out.push_back({.a = e.a, .b = e.b, .center = e.center, .radius = e.radius, .convex = e.convex});
  const bool has_lid = !edges_.back().is_arc() && edges_.back().direction.y == 0;
  if (has_lid) out.pop_back();
  const ProfileEdge* last = out.empty() ? nullptr : &edges_[out.size() - 1];
  if (last != nullptr && !last->is_arc() && last->direction.x == 0)
    out.back().b.y = std::numeric_limits<double>::infinity();
  else if (const Vec2 end = edges_.back().a; last != nullptr)
    out.push_back({.a = end, .b = {end.x, std::numeric_limits<double>::infinity()}});
  return out.empty() ? *this : Profile(std::move(out));
}

int Profile::nearest_corner(Vec2 q) const {
  int best = -1;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < edges_.size(); ++i) {
    const double d = length(q - edges_[i].a);
    if (corners_[i] == Corner::convex && d < least) least = d, best = static_cast<int>(i);
  }
  return best;
}

bool Profile::foot_is_corner(Vec2 q) const {
  const Foot f = nearest(q);
  return f.at_corner > 0 && corners_[f.at_corner] == Corner::convex && f.distance > 0;
}

Vec2 Profile::corner_direction(int corner) const {
  const ProfileEdge &before = edges_[corner - 1], &after = edges_[corner];
  const Vec2 in = tangent_at(before, after.a), out = tangent_at(after, after.a);
  return {in.y + out.y, -in.x - out.x};
}

int Profile::corner_side(int corner) const {
  const ProfileEdge &before = edges_[corner - 1], &after = edges_[corner];
  const double in = tangent_at(before, after.a).x, out = tangent_at(after, after.a).x;
  return in >= 0 && out >= 0 ? -1 : in <= 0 && out <= 0 ? 1 : 0;
}

double Profile::support(Vec2 n) const {
  if (open_top_ && n.y > 0) return std::numeric_limits<double>::infinity();
  const double size = length(n);
  double most = -std::numeric_limits<double>::infinity();
  for (const ProfileEdge& e : edges_) {
    most = std::max(most, dot(n, e.a));
    if (!std::isinf(e.b.y)) most = std::max(most, dot(n, e.b));
    if (!e.is_arc() || !e.convex || size == 0) continue;
    // A value of the whole circle counts only where its point in this direction lies on the arc.
    const Vec2 far = e.center + (e.radius / size) * n;
    if (far.y >= e.a.y && far.y <= e.b.y) most = std::max(most, dot(n, far));
  }
  return most;
}

// Chains come first among the pieces; a new one begins amid each concave arc as well.
const Profile& Profile::piece_of_edge(std::size_t edge) const {
  const auto count = static_cast<std::ptrdiff_t>(edge);
  const auto begin = corners_.begin() + 1;
  const auto corners = std::count(begin, begin + count, Corner::reflex);
  const auto arcs = std::count_if(edges_.begin(), edges_.begin() + count,
                                  [](const ProfileEdge& e) { return e.is_arc() && !e.convex; });
  return (*pieces_)[static_cast<std::size_t>(corners + arcs)];
}

bool Profile::bends_in(std::int32_t patch) const {
  return std::ranges::any_of(
      edges_, [&](const ProfileEdge& e) { return e.patch == patch && e.is_arc() && !e.convex; });
}

const Profile& Profile::piece_of_patch(std::int32_t patch) const {
  std::size_t edge = 0;
  while (edge + 1 < edges_.size() && edges_[edge].patch != patch) ++edge;
  return piece_of_edge(edge);
}

const Profile& Profile::piece_of_corner(int corner) const {
  return piece_of_edge(std::min(static_cast<std::size_t>(corner), edges_.size() - 1));
}

}  // namespace mrsim
