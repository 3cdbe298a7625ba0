#include "mesh/surface/ridge_strip.h"

#include "mesh/solid/exact_predicates.h"
#include "mesh/solid/self_intersection.h"

#include <algorithm>
#include <functional>
#include <queue>
#include <set>
#include <tuple>
#include <utility>

namespace mrsim::detail {
namespace {

constexpr int kStripRounds = 16;

using Triangle = std::array<std::uint32_t, 3>;

bool is_gone(const Triangle& x) { return x[0] == x[1] || x[1] == x[2] || x[2] == x[0]; }

bool has(const Triangle& x, std::uint32_t v) { return x[0] == v || x[1] == v || x[2] == v; }

// Whether every crease through p passes through q.
bool is_on_creases(const SurfacePoint& p, const SurfacePoint& q) {
  return std::all_of(p.faces, p.faces + p.count,
                     [&](const FieldSample& f) { return has_face(q, f); });
}

// The two faces of p that meet in a crease through all three.
bool share_crease(const SurfacePoint& p, const SurfacePoint& q, const SurfacePoint& r) {
  int shared = 0;
  for (int k = 0; k < p.count; ++k) shared += has_face(q, p.faces[k]) && has_face(r, p.faces[k]);
  return shared >= 2;
}

}  // namespace

RidgeStrip::RidgeStrip(std::vector<Vec3>& vertices, std::vector<Triangle>& triangles,
                       std::vector<RidgeVertex> ridge, NormalOf normal_of, int threads)
    : vertices_(vertices),
      triangles_(triangles),
      ridge_(std::move(ridge)),
      normal_of_(std::move(normal_of)),
      threads_(threads),
      index_(vertices.size(), -1),
      joined_(ridge_.size()),
      members_(ridge_.size()),
      fresh_(ridge_.size()),
      touched_(ridge_.size()),
      reset_(ridge_.size()),
      is_back_(ridge_.size()),
      has_slid_(ridge_.size()) {
  for (std::size_t k = 0; k < ridge_.size(); ++k) {
    RidgeVertex& r = ridge_[k];
    index_[r.vertex] = joined_[k] = static_cast<std::int32_t>(k);
    members_[k] = {joined_[k]};
    before_.push_back(vertices_[r.vertex]);
    if (r.moves) vertices_[r.vertex] = r.point.position = snap(r.point.position);
  }
  find_stars();
}

std::uint32_t RidgeStrip::now(std::uint32_t vertex) const {
  const std::int32_t p = index_of(vertex);
  return p < 0 ? vertex : of(joined_[static_cast<std::size_t>(p)]).vertex;
}

void RidgeStrip::find_stars() {
  first_.assign(ridge_.size() + 1, 0);
  for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
    bool is_near = false;
    for (const std::uint32_t v : triangles_[t])
      if (const std::int32_t p = index_of(v); p >= 0) {
        ++first_[static_cast<std::size_t>(p) + 1];
        is_near = true;
      }
    if (is_near) near_.push_back(t);
  }
  for (std::size_t k = 1; k < first_.size(); ++k) first_[k] += first_[k - 1];
  stars_.resize(first_.back());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (const std::uint32_t t : near_)
    for (const std::uint32_t v : triangles_[t])
      if (const std::int32_t p = index_of(v); p >= 0)
        stars_[next[static_cast<std::size_t>(p)]++] = t;
}

// The remaining triangles about a vertex and about all that were joined into it, some of them
// twice.
std::vector<std::uint32_t> RidgeStrip::star(std::int32_t p) const {
  std::vector<std::uint32_t> out;
  for (const std::int32_t m : members_[static_cast<std::size_t>(p)])
    for (std::uint32_t k = first_[static_cast<std::size_t>(m)];
         k < first_[static_cast<std::size_t>(m) + 1]; ++k)
      if (!is_gone(now(triangles_[stars_[k]]))) out.push_back(stars_[k]);
  return out;
}

// All its corners lie on one crease, or it looks the wrong way: two corners have passed each other.
bool RidgeStrip::is_spoiled(std::uint32_t triangle) const {
  const Triangle x = now(triangles_[triangle]);
  const std::int32_t a = index_of(x[0]), b = index_of(x[1]), c = index_of(x[2]);
  if (a >= 0 && b >= 0 && c >= 0 && share_crease(of(a).point, of(b).point, of(c).point))
    return true;
  return looks_away(triangle, x);
}

bool RidgeStrip::looks_away(std::uint32_t triangle, const Triangle& x) const {
  const Vec3 &a = vertices_[x[0]], &b = vertices_[x[1]], &c = vertices_[x[2]];
  return dot(cross(b - a, c - a), normal_of_(triangle)) <= 0;
}

void RidgeStrip::join() {
  struct Side {
    double squared;
    std::int32_t a, b;
    bool operator>(const Side& s) const {
      return std::tie(squared, a, b) > std::tie(s.squared, s.a, s.b);
    }
  };
  const auto side = [&](std::int32_t a, std::int32_t b) {
    const Vec3 d = of(b).point.position - of(a).point.position;
    return Side{dot(d, d), std::min(a, b), std::max(a, b)};
  };
  std::priority_queue<Side, std::vector<Side>, std::greater<>> sides;
  const auto add_sides = [&](std::uint32_t t) {
    const Triangle x = now(triangles_[t]);
    if (is_gone(x) || !is_spoiled(t)) return;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t a = index_of(x[k]), b = index_of(x[(k + 1) % 3]);
      if (a >= 0 && b >= 0) sides.push(side(a, b));
    }
  };
  for (const std::uint32_t t : near_) add_sides(t);
  while (!sides.empty()) {
    const Side s = sides.top();
    sides.pop();
    const Side t = side(joined_[static_cast<std::size_t>(s.a)],
                        joined_[static_cast<std::size_t>(s.b)]);  // lengthened by joins since
    if (t.a == t.b) continue;
    if (t.squared > s.squared) {
      sides.push(t);
      continue;
    }
    for (const auto& [from, to] : {std::pair(t.a, t.b), std::pair(t.b, t.a)})
      if (join_if(from, to, true)) {
        for (const std::uint32_t about : star(to)) add_sides(about);
        break;
      }
  }
}

// The side must belong to a spoiled triangle, and no other vertex be beside both of its ends than
// the two that are opposite to it. A smooth point must not spoil more.
bool RidgeStrip::join_if(std::int32_t from, std::int32_t to, bool must_be_spoiled) {
  const bool is_smooth = of(from).point.count == 1;
  if (!(of(from).moves || of(to).moves || is_smooth) ||
      !is_on_creases(of(from).point, of(to).point))
    return false;
  const std::uint32_t a = of(from).vertex, b = of(to).vertex;
  std::set<std::uint32_t> about_a, about_b, opposite;
  bool is_bad = false;
  for (const std::uint32_t t : star(from)) {
    const Triangle x = now(triangles_[t]);
    about_a.insert(x.begin(), x.end());
    if (!has(x, b)) {
      Triangle joined = x;
      std::replace(joined.begin(), joined.end(), a, b);
      if ((is_smooth || !must_be_spoiled) && looks_away(t, joined)) return false;
      continue;
    }
    opposite.insert(x.begin(), x.end());
    is_bad = is_bad || is_spoiled(t);
  }
  for (const std::uint32_t t : star(to)) {
    const Triangle x = now(triangles_[t]);
    about_b.insert(x.begin(), x.end());
  }
  if ((must_be_spoiled && !is_bad) || opposite.size() != 4) return false;
  for (const std::uint32_t v : about_a)
    if (about_b.count(v) > 0 && opposite.count(v) == 0) return false;
  auto& mine = members_[static_cast<std::size_t>(from)];
  auto& all = members_[static_cast<std::size_t>(to)];
  for (const std::int32_t m : mine) joined_[static_cast<std::size_t>(m)] = to;
  all.insert(all.end(), mine.begin(), mine.end());
  mine.clear();
  return true;
}

// A vertex whose new place makes triangles meet is joined into its nearest neighbour on the ridge,
// where it may fit. Tried once for each vertex.
bool RidgeStrip::join_neighbour(std::int32_t p) {
  const auto k = static_cast<std::size_t>(p);
  if (of(p).point.count != 2 || !of(p).moves || has_slid_[k]) return false;
  has_slid_[k] = 1;
  std::vector<std::pair<double, std::int32_t>> next;
  for (const std::uint32_t t : star(p))
    for (const std::uint32_t v : now(triangles_[t]))
      if (const std::int32_t q = index_of(v); q >= 0 && q != p && of(q).point.count >= 2)
        next.emplace_back(distance(of(q).point.position, of(p).point.position), q);
  std::sort(next.begin(), next.end());
  for (const auto& [far, q] : next)
    if (!is_back_[static_cast<std::size_t>(q)] && join_if(p, q, false)) {
      touch(members_[static_cast<std::size_t>(q)]);
      return true;
    }
  return false;
}

void RidgeStrip::touch(std::span<const std::int32_t> indices) {
  for (const std::int32_t p : indices) {
    const auto k = static_cast<std::size_t>(p);
    fresh_[k] = touched_[k] = reset_[k] = 1;
  }
}

bool RidgeStrip::has_corner(std::uint32_t triangle, std::span<const char> flags) const {
  const Triangle& x = triangles_[triangle];
  return std::any_of(x.begin(), x.end(), [&](std::uint32_t v) {
    return index_of(v) >= 0 && flags[static_cast<std::size_t>(index_of(v))];
  });
}

bool RidgeStrip::put_back(std::int32_t p) {
  std::vector<std::int32_t> members;
  members.swap(members_[static_cast<std::size_t>(joined_[static_cast<std::size_t>(p)])]);
  bool any = members.size() > 1;
  for (const std::int32_t m : members) {
    const auto k = static_cast<std::size_t>(m);
    RidgeVertex& r = ridge_[k];
    joined_[k] = m;
    members_[k] = {m};
    any = any || r.moves;
    if (r.moves) vertices_[r.vertex] = before_[k], is_back_[k] = 1;
    r.moves = false;
  }
  if (any) touch(members);
  return any;
}

bool RidgeStrip::put_back_corners(std::uint32_t triangle) {
  bool any = false;
  for (const std::uint32_t v : triangles_[triangle])
    if (const std::int32_t p = index_of(v); p >= 0) any = put_back(p) || any;
  return any;
}

bool RidgeStrip::put_back_flat() {
  bool any = false;
  for (const std::uint32_t t : near_) {
    const Triangle x = now(triangles_[t]);
    if (is_gone(x) || !has_corner(t, touched_)) continue;
    const Vec3 &a = vertices_[x[0]], &b = vertices_[x[1]], &c = vertices_[x[2]];
    if (is_degenerate(a, b, c)) any = put_back_corners(t) || any;
  }
  return any;
}

// After vertices were put back, two triangles may lie on one side of an edge: theirs go back, too.
bool RidgeStrip::put_back_doubled() {
  struct Edge {
    std::uint32_t a, b, triangle;
  };
  // Marks corners: of two triangles that meet, one has a corner that was put back.
  std::vector<char> is_corner(vertices_.size(), 0);
  bool is_back = false;
  for (const std::uint32_t t : near_)
    if (has_corner(t, reset_)) {
      for (const std::uint32_t v : now(triangles_[t])) is_corner[v] = 1;
      is_back = true;
    }
  if (!is_back) return false;
  std::vector<Edge> edges;
  for (const std::uint32_t t : near_) {
    const Triangle x = now(triangles_[t]);
    if (is_gone(x)) continue;
    for (std::size_t k = 0; k < 3; ++k)
      if (is_corner[x[k]] && is_corner[x[(k + 1) % 3]]) edges.push_back({x[k], x[(k + 1) % 3], t});
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& s, const Edge& t) {
    return std::tie(s.a, s.b, s.triangle) < std::tie(t.a, t.b, t.triangle);
  });
  bool any = false;
  for (std::size_t k = 1; k < edges.size(); ++k)
    if (edges[k].a == edges[k - 1].a && edges[k].b == edges[k - 1].b)
      for (const std::size_t i : {k - 1, k}) any = put_back_corners(edges[i].triangle) || any;
  return any;
}

// Tests the triangles about the vertices put back last; at first, all that have changed. Of each
// pair that meets, the vertex goes back that takes part in most such pairs.
bool RidgeStrip::put_back_meeting() {
  std::vector<Triangle> alive;
  std::vector<std::uint32_t> numbers;
  std::vector<char> chosen;
  for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
    const Triangle x = now(triangles_[t]);
    if (is_gone(x)) continue;
    alive.push_back(x);
    numbers.push_back(t);
    chosen.push_back(has_corner(t, fresh_));
  }
  std::fill(fresh_.begin(), fresh_.end(), 0);
  const auto pairs = self_intersections(vertices_, alive, threads_, chosen);
  std::vector<std::uint32_t> parts(ridge_.size(), 0);
  const auto each_corner = [&](const auto& pair, const auto& act) {
    for (const std::uint32_t t : {numbers[pair.first], numbers[pair.second]})
      for (const std::uint32_t v : triangles_[t])
        if (index_of(v) >= 0)
          act(static_cast<std::size_t>(joined_[static_cast<std::size_t>(index_of(v))]));
  };
  for (const auto& pair : pairs) each_corner(pair, [&](std::size_t p) { ++parts[p]; });
  bool any = false;
  for (const auto& pair : pairs) {
    bool is_fresh = false;
    std::int32_t worst = -1;
    each_corner(pair, [&](std::size_t p) {
      is_fresh = is_fresh || fresh_[p];
      if (!ridge_[p].moves && members_[p].size() < 2) return;
      if (worst < 0 || parts[p] > parts[static_cast<std::size_t>(worst)])
        worst = static_cast<std::int32_t>(p);
    });
    if (!is_fresh && worst >= 0) any = join_neighbour(worst) || put_back(worst) || any;
  }
  return any;
}

void RidgeStrip::put_back_crossed() {
  for (std::size_t k = 0; k < ridge_.size(); ++k)
    fresh_[k] = touched_[k] = ridge_[k].moves || joined_[k] != static_cast<std::int32_t>(k);
  for (int round = 0; round < kStripRounds; ++round) {
    while (put_back_flat() || put_back_doubled()) {
    }
    if (!put_back_meeting()) return;
  }
  for (const std::uint32_t t : near_) put_back_corners(t);
}

RidgeStrip::Left RidgeStrip::finish() {
  Left left;
  std::size_t n = 0, next = 0;
  for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
    const bool is_near = next < near_.size() && near_[next] == t;
    next += is_near;
    const Triangle x = now(triangles_[t]);
    if (is_gone(x)) continue;
    if (is_near) left.near.push_back(static_cast<std::uint32_t>(n));
    left.triangles.push_back(t);
    triangles_[n++] = x;
  }
  triangles_.resize(n);
  return left;
}

const SurfacePoint* RidgeStrip::find(std::uint32_t vertex) const {
  const std::int32_t p = index_of(vertex);
  if (p < 0 || is_back_[static_cast<std::size_t>(p)]) return nullptr;
  return &of(p).point;
}

}  // namespace mrsim::detail
