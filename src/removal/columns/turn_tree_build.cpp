// How the tree of turning sweeps is made.
#include "core/numbers/rounding.h"
#include "core/numbers/vec.h"
#include "core/process/parallel.h"
#include "removal/columns/turn_tree.h"

#include <algorithm>
#include <array>

namespace mrsim {
namespace {

// mm: half a side of the path of a round insert that stays in one place, because a polygon needs a
// side.
constexpr double kPointSide = 1e-6;

double segment_distance(Vec2 a, Vec2 b, Vec2 q) {
  const Vec2 d = b - a, w = q - a;
  const double size = dot(d, d), along = dot(w, d);
  const double t = along <= 0 ? 0 : along >= size ? 1 : along / size;
  return length(w - t * d);
}

// The two ends of a sweep's path, and how far it leaves the segment between them.
struct Path {
  Vec2 start, end;
  double bulge = 0;
};

// The end of a path that is farthest from `from`; the first one of equals.
Vec2 farthest(std::span<const Path> paths, Vec2 from) {
  Vec2 found = from;
  double most = -1;
  for (const Path& path : paths)
    for (const Vec2 p : {path.start, path.end})
      if (const double d = dot(p - from, p - from); d > most) most = d, found = p;
  return found;
}

}  // namespace

// Builds the tree tier by tier; threads make the packs of a tier side by side.
class TurnTree::Builder {
 public:
  Builder(TurnTree& tree, std::span<const ToolShape> shapes, int threads)
      : tree_(tree), shapes_(shapes), threads_(threads), paths_(tree.items_.size()) {
    parallel_for(
        paths_.size(), threads,
        [this](std::size_t i) {
          const TurnSweep& s = sweep_of(i);
          paths_[i] = {s.start, s.end, s.bulge};
        },
        kChildrenOfThread);
  }

  // Adds the packs of the items [from, to), all of one insert. The last one is their root.
  void add(std::uint32_t from, std::uint32_t to) {
    auto tier = add_tier(from, to, true);
    while (tree_.packs_.size() - tier > 1)
      tier = add_tier(tier, static_cast<std::uint32_t>(tree_.packs_.size()), false);
    tree_.roots_.push_back(2 * tier);
    if (tree_.packs_[tier].behind != 0) tree_.roots_.push_back(2 * tier + 1);
  }

 private:
  static constexpr std::size_t kChildrenOfThread = 32;  // worth a thread
  struct Range {
    std::uint32_t from, to;
  };
  struct Made {
    Pack pack;
    std::vector<ConvexPolygon> own;
    std::array<const ConvexPolygon*, kLanes> polygons{};
  };

  // Adds the packs above the items (or packs) [from, to). Returns the first of the new packs.
  std::uint32_t add_tier(std::uint32_t from, std::uint32_t to, bool leaves) {
    const std::size_t count = (to - from + kLanes - 1) / kLanes, first = tree_.packs_.size();
    tree_.packs_.resize(first + count), tree_.size_.resize(first + count);
    ranges_.resize(first + count), chords_.resize(first + count);
    std::vector<Made> tier(count);
    parallel_for(
        count, threads_,
        [&](std::size_t k) {
          const auto a = from + static_cast<std::uint32_t>(k * kLanes),
                     b = std::min<std::uint32_t>(a + kLanes, to);
          ranges_[first + k] = leaves ? Range{a, b} : Range{ranges_[a].from, ranges_[b - 1].to};
          tier[k] = leaves ? leaf(a, b) : inner(a, b);
          chords_[first + k] = chord_of(ranges_[first + k]);
        },
        kChildrenOfThread);
    std::size_t sides = tree_.sides_.size();
    for (Made& made : tier) {
      made.pack.sides = static_cast<std::uint32_t>(sides);
      sides += made.pack.side_count;
    }
    tree_.sides_.resize(sides);
    parallel_for(
        count, threads_,
        [&](std::size_t k) {
          fill_sides(tier[k]);
          tree_.packs_[first + k] = tier[k].pack;
          const Chord& c = chords_[first + k];
          tree_.size_[first + k] = length(c.b - c.a) + 2 * c.away;
        },
        kChildrenOfThread);
    return static_cast<std::uint32_t>(first);
  }

  Made leaf(std::uint32_t from, std::uint32_t to) const {
    Made made = begin(from, to - from);
    Pack& pack = made.pack;
    pack.leaf = true;
    for (std::uint32_t k = 0; k < to - from; ++k) {
      const TurnSweep& s = sweep_of(from + k);
      pack.round[k] = s.round;
      if (!s.one_sided) pack.behind = static_cast<std::uint8_t>(pack.behind | 1u << k);
      if (s.arc || s.polygon.sides.empty())
        pack.curved = static_cast<std::uint8_t>(pack.curved | 1u << k);
      else
        made.polygons[k] = &s.polygon;
    }
    count_sides(made);
    return made;
  }

  Made inner(std::uint32_t from, std::uint32_t to) const {
    Made made = begin(from, to - from);
    Pack& pack = made.pack;
    made.own.resize(to - from);
    for (std::uint32_t k = 0; k < to - from; ++k) {
      const Chord& c = chords_[from + k];
      const InsertOutline& insert = shapes_[shape_of(ranges_[from + k])].insert;
      TurnSweep s = turn_line(insert, c.a, c.b);
      double away = c.away + kRounding;
      if (s.polygon.sides.empty()) {
        s = turn_line(insert, c.a, c.b + Vec2{kPointSide, 0});
        away += kPointSide;
      }
      made.own[k] = std::move(s.polygon);
      made.polygons[k] = &made.own[k];
      pack.round[k] = s.round + away;
      if (tree_.packs_[from + k].behind != 0)
        pack.behind = static_cast<std::uint8_t>(pack.behind | 1u << k);
    }
    count_sides(made);
    return made;
  }

  const TurnSweep& sweep_of(std::size_t item) const { return tree_.turns_[tree_.items_[item].row]; }
  std::size_t shape_of(const Range& items) const {
    return static_cast<std::size_t>(tree_.items_[items.from].shape);
  }

  static Made begin(std::uint32_t first, std::uint32_t lanes) {
    Made made;
    std::fill(made.pack.round, made.pack.round + kLanes, -kInfinity);
    made.pack.first = first;
    made.pack.lanes = static_cast<std::uint8_t>((1u << lanes) - 1);
    return made;
  }

  static void count_sides(Made& made) {
    std::size_t count = 0;
    for (const ConvexPolygon* p : made.polygons)
      if (p != nullptr) count = std::max(count, p->sides.size());
    made.pack.side_count = static_cast<std::uint16_t>(count);
  }

  // Lanes with fewer sides repeat one; those without any are zero.
  void fill_sides(const Made& made) {
    for (std::size_t i = 0; i < made.pack.side_count; ++i) {
      PolygonSides& row = tree_.sides_[made.pack.sides + i];
      for (std::size_t k = 0; k < kLanes; ++k) {
        if (made.polygons[k] == nullptr) continue;
        const std::vector<ConvexPolygon::Side>& sides = made.polygons[k]->sides;
        const ConvexPolygon::Side& side = sides[std::min(i, sides.size() - 1)];
        row.ax[k] = side.a.x, row.ay[k] = side.a.y;
        row.dx[k] = side.direction.x, row.dy[k] = side.direction.y;
        row.length[k] = side.length;
      }
    }
  }

  // All paths lie within `away` of the chord a b.
  struct Chord {
    Vec2 a, b;
    double away = 0;
  };
  Chord chord_of(const Range& items) const {
    const auto paths = std::span(paths_).subspan(items.from, items.to - items.from);
    Chord c;
    c.a = farthest(paths, paths.front().start);
    c.b = farthest(paths, c.a);
    for (const Path& path : paths)
      c.away = std::max({c.away, segment_distance(c.a, c.b, path.start) + path.bulge,
                         segment_distance(c.a, c.b, path.end) + path.bulge});
    return c;
  }

  TurnTree& tree_;
  std::span<const ToolShape> shapes_;
  int threads_;
  std::vector<Path> paths_;    // by item
  std::vector<Range> ranges_;  // of items, by pack
  std::vector<Chord> chords_;  // by pack
};

TurnTree::TurnTree(std::span<const TurnSweep> turns, std::span<const ToolShape> shapes,
                   std::vector<Item> items, int threads)
    : turns_(turns), items_(std::move(items)) {
  std::stable_sort(items_.begin(), items_.end(),
                   [](const Item& a, const Item& b) { return a.shape < b.shape; });
  Builder builder(*this, shapes, threads);
  const auto count = static_cast<std::uint32_t>(items_.size());
  for (std::uint32_t from = 0, to = 0; from < count; from = to) {
    while (to < count && items_[to].shape == items_[from].shape) ++to;
    builder.add(from, to);
  }
}

}  // namespace mrsim
