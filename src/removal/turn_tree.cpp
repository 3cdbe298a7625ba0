#include "removal/turn_tree.h"

#include "core/vec.h"

#include <algorithm>
#include <array>

namespace mrsim {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Room for rounding in a bound, mm: coordinates up to 10 m.
constexpr double kBoundSlack = 1e-9;

// A pack of this many times the size of a region goes into its list unopened.
constexpr double kSmall = 8;

// Of a path without length, where the insert is a disc: a polygon needs a side.
constexpr double kShortest = 1e-6;

double segment_distance(Vec2 a, Vec2 b, Vec2 q) {
  const Vec2 d = b - a, w = q - a;
  const double size = dot(d, d), along = dot(w, d);
  const double t = along <= 0 ? 0 : along >= size ? 1 : along / size;
  return length(w - t * d);
}

Vec2 farthest(std::span<const Vec2> points, Vec2 from) {
  return *std::max_element(points.begin(), points.end(), [&](Vec2 a, Vec2 b) {
    return dot(a - from, a - from) < dot(b - from, b - from);
  });
}

}  // namespace

class TurnTree::Builder {
 public:
  Builder(TurnTree& tree, std::span<const ToolShape> shapes) : tree_(tree), shapes_(shapes) {}

  // The packs of the items [from, to), all of one insert; the last one is their root.
  void add(std::uint32_t from, std::uint32_t to) {
    auto level = static_cast<std::uint32_t>(tree_.packs_.size());
    for (std::uint32_t i = from; i < to; i += kLanes)
      add_leaf(i, std::min<std::uint32_t>(i + kLanes, to));
    for (;;) {
      const auto end = static_cast<std::uint32_t>(tree_.packs_.size());
      if (end - level == 1) break;
      for (std::uint32_t child = level; child < end; child += kLanes)
        add_inner(child, std::min<std::uint32_t>(child + kLanes, end));
      level = end;
    }
    const auto root = static_cast<std::uint32_t>(tree_.packs_.size() - 1);
    tree_.roots_.push_back(2 * root);
    if (tree_.packs_[root].behind != 0) tree_.roots_.push_back(2 * root + 1);
  }

 private:
  struct Range {
    std::uint32_t from, to;
  };

  void add_leaf(std::uint32_t from, std::uint32_t to) {
    Pack pack = begin(from, to - from);
    pack.leaf = true;
    std::array<const ConvexPolygon*, kLanes> polygons{};
    for (std::uint32_t k = 0; k < to - from; ++k) {
      const TurnSweep& s = tree_.turns_[tree_.items_[from + k].row];
      pack.round[k] = s.round;
      if (!s.one_sided) pack.behind = static_cast<std::uint8_t>(pack.behind | 1u << k);
      if (s.arc || s.polygon.sides.empty())
        pack.pieces = static_cast<std::uint8_t>(pack.pieces | 1u << k);
      else
        polygons[k] = &s.polygon;
    }
    end(pack, polygons, {from, to});
  }

  void add_inner(std::uint32_t from, std::uint32_t to) {
    Pack pack = begin(from, to - from);
    std::array<ConvexPolygon, kLanes> made;
    std::array<const ConvexPolygon*, kLanes> polygons{};
    for (std::uint32_t k = 0; k < to - from; ++k) {
      const Chord& c = chords_[from + k];
      const InsertOutline& insert = shapes_[shape_of(ranges_[from + k])].insert;
      TurnSweep s = turn_line(insert, c.a, c.b);
      double away = c.away + kBoundSlack;
      if (s.polygon.sides.empty()) {
        s = turn_line(insert, c.a, c.b + Vec2{kShortest, 0});
        away += kShortest;
      }
      made[k] = std::move(s.polygon);
      polygons[k] = &made[k];
      pack.round[k] = s.round + away;
      if (tree_.packs_[from + k].behind != 0)
        pack.behind = static_cast<std::uint8_t>(pack.behind | 1u << k);
    }
    end(pack, polygons, {ranges_[from].from, ranges_[to - 1].to});
  }

  std::size_t shape_of(const Range& items) const {
    return static_cast<std::size_t>(tree_.items_[items.from].shape);
  }

  static Pack begin(std::uint32_t first, std::uint32_t lanes) {
    Pack pack;
    std::fill(pack.round, pack.round + kLanes, -kInfinity);
    pack.first = first;
    pack.lanes = static_cast<std::uint8_t>((1u << lanes) - 1);
    return pack;
  }

  // Lanes with fewer sides repeat one; those without any are zero.
  void end(Pack& pack, const std::array<const ConvexPolygon*, kLanes>& polygons,
           const Range& items) {
    std::size_t count = 0;
    for (const ConvexPolygon* p : polygons)
      if (p != nullptr) count = std::max(count, p->sides.size());
    pack.sides = static_cast<std::uint32_t>(tree_.sides_.size());
    pack.side_count = static_cast<std::uint16_t>(count);
    for (std::size_t i = 0; i < count; ++i) {
      PolygonSides& row = tree_.sides_.emplace_back();
      for (std::size_t k = 0; k < kLanes; ++k) {
        if (polygons[k] == nullptr) continue;
        const ConvexPolygon::Side& side =
            polygons[k]->sides[std::min(i, polygons[k]->sides.size() - 1)];
        row.ax[k] = side.a.x, row.ay[k] = side.a.y;
        row.dx[k] = side.direction.x, row.dy[k] = side.direction.y;
        row.length[k] = side.length;
      }
    }
    tree_.packs_.push_back(pack);
    ranges_.push_back(items);
    chords_.push_back(chord_of(items));
    const Chord& c = chords_.back();
    tree_.size_.push_back(length(c.b - c.a) + 2 * c.away);
  }

  // All paths lie within `away` of the chord a b.
  struct Chord {
    Vec2 a, b;
    double away = 0;
  };
  Chord chord_of(const Range& items) {
    points_.clear();
    for (std::uint32_t i = items.from; i < items.to; ++i) {
      const TurnSweep& s = tree_.turns_[tree_.items_[i].row];
      points_.push_back(s.start), points_.push_back(s.end);
    }
    Chord c;
    c.a = farthest(points_, points_.front());
    c.b = farthest(points_, c.a);
    for (std::uint32_t i = items.from; i < items.to; ++i) {
      const TurnSweep& s = tree_.turns_[tree_.items_[i].row];
      c.away = std::max({c.away, segment_distance(c.a, c.b, s.start) + s.bulge,
                         segment_distance(c.a, c.b, s.end) + s.bulge});
    }
    return c;
  }

  TurnTree& tree_;
  std::span<const ToolShape> shapes_;
  std::vector<Range> ranges_;  // of items, by pack
  std::vector<Chord> chords_;  // by pack
  std::vector<Vec2> points_;
};

TurnTree::TurnTree(std::span<const TurnSweep> turns, std::span<const ToolShape> shapes,
                   std::vector<Item> items)
    : turns_(turns), items_(std::move(items)) {
  std::stable_sort(items_.begin(), items_.end(),
                   [](const Item& a, const Item& b) { return a.shape < b.shape; });
  Builder builder(*this, shapes);
  const auto count = static_cast<std::uint32_t>(items_.size());
  for (std::uint32_t from = 0, to = 0; from < count; from = to) {
    while (to < count && items_[to].shape == items_[from].shape) ++to;
    builder.add(from, to);
  }
}

void TurnTree::append_sweeps(std::uint32_t pack, std::vector<std::uint32_t>& out) const {
  const Pack& p = packs_[pack / 2];
  for (std::uint32_t k = 0; k < kLanes && (p.lanes >> k & 1u) != 0; ++k) {
    if (p.leaf)
      out.push_back(items_[p.first + k].sweep);
    else
      append_sweeps(2 * (p.first + k), out);
  }
}

void TurnTree::measure(const Pack& pack, double x, double z, double* out) const {
  sweep_kernels().polygons(sides_.data() + pack.sides, pack.side_count, pack.round, x, z, out);
  for (std::size_t k = 0; pack.pieces >> k != 0; ++k)
    if ((pack.pieces >> k & 1u) != 0)
      out[k] = section_distance(turns_[items_[pack.first + k].row], {x, z});
}

// The nearest child first; its packs are searched before its siblings are looked at again.
void TurnTree::nearest(std::uint32_t pack, double rho, double z, Nearest& best) const {
  struct Open {
    double bound;
    std::uint32_t pack;
  };
  constexpr std::size_t kMostOpen = 128;  // eight on each of the levels of 2^32 sweeps
  Open open[kMostOpen];
  alignas(64) double d[kLanes];
  const bool behind = pack % 2 != 0;
  const double x = behind ? -rho : rho;
  std::size_t count = 0;
  open[count++] = {-kInfinity, pack / 2};
  while (count > 0) {
    const Open at = open[--count];
    if (at.bound > best.distance) continue;
    const Pack& p = packs_[at.pack];
    measure(p, x, z, d);
    const unsigned lanes = behind ? p.behind : p.lanes;
    const std::size_t from = count;
    for (std::uint32_t k = 0; lanes >> k != 0; ++k) {
      if ((lanes >> k & 1u) == 0 || d[k] > best.distance) continue;
      if (p.leaf) {
        const Item& item = items_[p.first + k];
        if (d[k] < best.distance || item.sweep < best.sweep)
          best = {d[k], item.sweep, item.row, behind};
        continue;
      }
      std::size_t place = count++;
      for (; place > from && open[place - 1].bound < d[k]; --place) open[place] = open[place - 1];
      open[place] = {d[k], p.first + k};
    }
  }
}

// What can be nearest in a region. A sweep i goes if it is farther than another can be, or if its
// tangent at the centre is, at each corner, above the distance of the nearest sweep j: between the
// corners d_j is convex and the tangent is flat and below d_i.
class TurnTree::Narrowing {
 public:
  Narrowing(const TurnTree& tree, const TurnRegion& region, const Nearest& best, double limit,
            double slack)
      : tree_(tree), region_(region), nearest_(best.distance), radius_(length(region.half)) {
    limit_ = std::min(limit, best.distance + 2 * radius_ + slack);
    if (best.sweep == ~0u) return;
    const TurnSweep& j = tree.turns_[best.row];
    if (j.arc) return;
    beaten_ = true;
    for (int k = 0; k < 4; ++k)
      corner_[k] = section_distance(j, seen(corner(k), best.behind)) + slack;
  }

  // Appends what is left of a pack.
  void narrow(std::uint32_t pack, Packs& out) {
    const Pack& p = tree_.packs_[pack / 2];
    const unsigned kept = kept_lanes(pack);
    if (kept == 0) return;
    // Children of a small pack are told apart at the point itself, all at once.
    const bool one = (kept & (kept - 1)) == 0;
    if (p.leaf || (!one && tree_.size_[pack / 2] <= kSmall * radius_)) return out.push_back(pack);
    for (std::uint32_t k = 0; kept >> k != 0; ++k)
      if ((kept >> k & 1u) != 0) narrow(2 * (p.first + k) + pack % 2, out);
  }

  void members(std::uint32_t pack, std::vector<Member>& out) {
    const Pack& p = tree_.packs_[pack / 2];
    const unsigned kept = kept_lanes(pack);
    for (std::uint32_t k = 0; kept >> k != 0; ++k) {
      if ((kept >> k & 1u) == 0) continue;
      if (!p.leaf) {
        members(2 * (p.first + k) + pack % 2, out);
        continue;
      }
      const Item& item = tree_.items_[p.first + k];
      out.push_back({item.sweep, item.row, pack % 2 != 0});
    }
  }

 private:
  // The children that may be nearest somewhere.
  unsigned kept_lanes(std::uint32_t pack) const {
    const Pack& p = tree_.packs_[pack / 2];
    const bool behind = pack % 2 != 0;
    const Vec2 q = seen(region_.center, behind);
    alignas(64) double d[kLanes];
    tree_.measure(p, q.x, q.y, d);
    const unsigned lanes = behind ? p.behind : p.lanes;
    unsigned kept = 0;
    for (std::uint32_t k = 0; lanes >> k != 0; ++k)
      if ((lanes >> k & 1u) != 0 && is_kept(p, k, behind, d[k])) kept |= 1u << k;
    return kept;
  }

  Vec2 corner(int k) const {
    return region_.center +
           Vec2{k & 1 ? region_.half.x : -region_.half.x, k & 2 ? region_.half.y : -region_.half.y};
  }

  static Vec2 seen(Vec2 q, bool behind) { return {behind ? -q.x : q.x, q.y}; }

  bool is_kept(const Pack& p, std::size_t lane, bool behind, double d) const {
    if (d > limit_) return false;
    if (!beaten_ || d <= nearest_ || (p.pieces >> lane & 1u) != 0) return true;
    const Vec2 u = normal(p, lane, seen(region_.center, behind));
    double support = -kInfinity;
    for_each_side(p, lane,
                  [&](const ConvexPolygon::Side& s) { support = std::max(support, dot(u, s.a)); });
    for (int k = 0; k < 4; ++k)
      if (dot(u, seen(corner(k), behind)) - support - p.round[lane] <= corner_[k]) return true;
    return false;
  }

  template <typename Body>
  void for_each_side(const Pack& p, std::size_t lane, Body body) const {
    for (std::size_t i = p.sides; i < p.sides + p.side_count; ++i) {
      const PolygonSides& s = tree_.sides_[i];
      body(ConvexPolygon::Side{{s.ax[lane], s.ay[lane]}, {s.dx[lane], s.dy[lane]}, s.length[lane]});
    }
  }

  // Unit normal of the polygon where it is nearest to q. It need not be right: the plane across it
  // that touches the polygon bounds the distance whatever its direction.
  Vec2 normal(const Pack& p, std::size_t lane, Vec2 q) const {
    double most = -kInfinity, least = kInfinity;
    Vec2 flat, off;
    for_each_side(p, lane, [&](const ConvexPolygon::Side& s) {
      const double n = side_of(s, q);
      if (n > most) most = n, flat = right_of(s.direction);
      if (n <= 0) return;
      const Vec2 w = q - foot_on(s, q);
      if (dot(w, w) < least) least = dot(w, w), off = w;
    });
    const double n = length(off);
    return most > 0 && n > 0 ? (1 / n) * off : flat;
  }

  const TurnTree& tree_;
  const TurnRegion& region_;
  double nearest_, radius_, limit_;
  bool beaten_ = false;
  std::array<double, 4> corner_{};
};

void TurnTree::narrow(const TurnRegion& region, const Nearest& best, double limit, double slack,
                      std::span<const std::uint32_t> in, Packs& out) const {
  out.clear();
  Narrowing narrowing(*this, region, best, limit, slack);
  for (const std::uint32_t pack : in) narrowing.narrow(pack, out);
}

void TurnTree::members(const TurnRegion& region, const Nearest& best, double limit, double slack,
                       std::span<const std::uint32_t> in, std::vector<Member>& out) const {
  Narrowing narrowing(*this, region, best, limit, slack);
  for (const std::uint32_t pack : in) narrowing.members(pack, out);
}

}  // namespace mrsim
