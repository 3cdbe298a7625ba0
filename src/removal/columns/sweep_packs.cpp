#include "removal/columns/sweep_packs.h"

#include "core/numbers/rounding.h"
#include "core/numbers/vec.h"
#include "core/process/heap.h"
#include "core/process/ordered.h"
#include "removal/columns/sweep_columns.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace mrsim {
namespace {

constexpr std::size_t kMost = 8, kLeast = 4;    // members of a pack
constexpr double kLargestSpread = 1.0 / 16;     // of the chord: the largest spread
constexpr double kShortest = 1e-3;              // mm in plan: shorter chords have no direction
constexpr double kSteepChord = 8;               // slope from which heights say little of a chord
constexpr std::size_t kSweepsOfPart = 1 << 13;  // sweeps that are packed on their own
constexpr double kExpand = 0.7;                 // of a pack: smaller regions see its members

using Form = SweepClass::Form;

// How far paths leave a chord, mm: in plan and upwards, or of strips and lines in space.
struct Spread {
  double plan = 0, up = 0;
  friend Spread operator+(const Spread& a, const Spread& b) {
    return {a.plan + b.plan, a.up + b.up};
  }
};
Spread max(const Spread& a, const Spread& b) {
  return {std::max(a.plan, b.plan), std::max(a.up, b.up)};
}

// A sweep or a pack, to be packed.
struct Item {
  std::uint32_t number = 0, first = 0, last = 0;
  Form form = Form::other;  // strip, line or segment; others are not packed
  SweepKind kind = SweepKind::path;
  std::int32_t shape = 0;
  Vec3 start, end;  // of the path
  Spread spread;
};

// Start and end of a sweep's path, where it is one of those that may be packed.
bool find_ends(const SweepColumns& c, const SweepRef& ref, Item& item) {
  if (item.form == Form::strip) {
    const double* r = c.ball_lines[ref.row].c;
    item.start = {r[BallSlot::x], r[BallSlot::y], r[BallSlot::z]};
    item.end = {r[BallSlot::x] + r[BallSlot::ux] * r[BallSlot::length],
                r[BallSlot::y] + r[BallSlot::uy] * r[BallSlot::length],
                r[BallSlot::z] + r[BallSlot::slope] * r[BallSlot::length]};
    return true;
  }
  if (item.form == Form::line) {
    const double* r = c.plane_lines[ref.row].c;
    item.start = {r[LineSlot::x], r[LineSlot::y], r[LineSlot::low]};
    item.end = item.start + Vec3{r[LineSlot::dx], r[LineSlot::dy], 0};
    return true;
  }
  if (item.form != Form::segment || c.segment_count(item.number) != 1) return false;
  if (ref.kind == SweepKind::profile) {
    const ProfileRow& row = c.profiles[ref.row];
    item.start = {row.c[LineSlot::x], row.c[LineSlot::y], row.z};
    item.end = item.start + Vec3{row.c[LineSlot::dx], row.c[LineSlot::dy], 0};
    return !row.arc;
  }
  if (!c.paths.is_line(ref.row)) return false;
  item.start = c.paths.line(ref.row).start, item.end = c.paths.line(ref.row).end();
  return true;
}

Item item_of(const SweepColumns& c, std::uint32_t sweep) {
  Item item;
  item.number = item.first = item.last = sweep;
  const SweepRef& ref = c.refs[sweep];
  item.form = c.form_of(sweep), item.kind = ref.kind, item.shape = ref.shape;
  if (!find_ends(c, ref, item)) item.form = Form::other;
  return item;
}

// Children are sweeps, or packs that were made one after another.
bool follows(const Item& a, const Item& b) {
  return b.number == a.number + 1 && a.form != Form::other && b.form == a.form &&
         b.kind == a.kind && b.shape == a.shape && b.first == a.last + 1 &&
         (a.form != Form::line || a.start.z == b.start.z) && length(b.start - a.end) <= kRounding;
}

// Squared distance of p from the segment from a to a + d.
double squared_distance(const Vec3& p, const Vec3& a, const Vec3& d, double inverse) {
  const Vec3 e = p - a;
  const Vec3 off = e - std::clamp(dot(e, d) * inverse, 0.0, 1.0) * d;
  return dot(off, off);
}

// The sweep from the start of an item to `end`, of its form and tool; of segments, one that strays
// upwards only.
LineRecord chord_of(const SweepColumns& c, const Item& first, const Vec3& end,
                    const Spread& spread) {
  if (first.form == Form::segment) return segment_record(first.start, end, spread.up);
  const std::uint32_t row = c.tags[first.first] & kTagRow;
  LineRecord chord = first.form == Form::strip ? c.ball_lines[row] : c.plane_lines[row];
  const double dx = end.x - first.start.x, dy = end.y - first.start.y;
  if (first.form == Form::line) {
    chord.c[LineSlot::dx] = dx, chord.c[LineSlot::dy] = dy;
    return chord;
  }
  const double n = std::sqrt(dx * dx + dy * dy);
  chord.c[BallSlot::ux] = dx / n, chord.c[BallSlot::uy] = dy / n, chord.c[BallSlot::length] = n,
  chord.c[BallSlot::slope] = (end.z - first.start.z) / n;
  return chord;
}

// Lane k: a child with the record `child`.
void put_child(PackColumns& to, std::size_t k, Form form, const double* chord,
               const double* child) {
  const auto put = [&](std::initializer_list<double> values) {
    std::size_t i = 0;
    for (const double v : values) to.c[i++][k] = static_cast<float>(v);
  };
  const double x = child[BallSlot::x] - chord[BallSlot::x],
               y = child[BallSlot::y] - chord[BallSlot::y];
  if (form == Form::line)
    return put({x, y, child[LineSlot::dx], child[LineSlot::dy],
                1 / std::max(child[LineSlot::dx] * child[LineSlot::dx] +
                                 child[LineSlot::dy] * child[LineSlot::dy],
                             kLeastSquare),
                0, 0});
  const double slope = child[BallSlot::slope];
  put({x, y, child[BallSlot::z] - chord[BallSlot::z], child[BallSlot::ux], child[BallSlot::uy],
       child[BallSlot::length], slope,
       form == Form::strip ? 1 / (1 + slope * slope) : child[BallSlot::error]});
}

}  // namespace

// The packs of some sweeps, numbered from kFirstPack on.
class SweepPacks::Builder {
 public:
  explicit Builder(const SweepColumns& columns) : columns_(columns) {
    for (const ToolShape& shape : columns.shapes)
      slopes_.push_back(shape.turning ? 1
                                      : std::max<double>(height_tool(shape.cutter).steepest, 1));
  }

  // Packs of packs, until nothing more can be packed.
  SweepPacks build(std::uint32_t first, std::uint32_t end) {
    std::vector<Item> items, above;
    items.reserve(end - first);
    for (std::uint32_t i = first; i < end; ++i) items.push_back(item_of(columns_, i));
    for (bool packed = true; packed; std::swap(items, above)) packed = pack(items, above);
    for (const Item& item : items)
      if (item.number >= kFirstPack) packs_.roots_.push_back(item.number);
    return std::move(packs_);
  }

 private:
  // The packs of `items`, and those of them that are in none.
  bool pack(const std::vector<Item>& items, std::vector<Item>& above) {
    above.clear();
    const std::size_t before = packs_.size();
    for (std::size_t i = 0; i < items.size();) {
      std::size_t n = 1;
      while (n < kMost && i + n < items.size() && follows(items[i + n - 1], items[i + n])) ++n;
      // Moves that bend too much for a small pack mostly bend too much for a larger one.
      std::optional<Spread> spread;
      if (n >= kLeast) spread = spread_of({&items[i], kLeast});
      if (spread)
        while (n > kLeast && !(spread = spread_of({&items[i], n}))) --n;
      if (spread) {
        above.push_back(add({&items[i], n}, *spread));
        i += n;
      } else if (items[i++].number >= kFirstPack) {
        above.push_back(items[i - 1]);
      }
    }
    return packs_.size() > before;
  }

  // How far the paths leave their chord; nothing where that is too much.
  std::optional<Spread> spread_of(std::span<const Item> items) const {
    const Vec3 &a = items.front().start, d = items.back().end - a;
    if (d.x * d.x + d.y * d.y < kShortest * kShortest) return std::nullopt;
    return items[0].form == Form::segment ? spread_of_segments(items, a, d)
                                          : spread_in_space(items, a, d);
  }
  static std::optional<Spread> spread_in_space(std::span<const Item> items, const Vec3& a,
                                               const Vec3& d) {
    const double size = dot(d, d), most = kLargestSpread * kLargestSpread * size,
                 inverse = 1 / size;
    double joints = 0, own = 0;
    for (const Item& item : items) {
      joints = std::max(joints, squared_distance(item.start, a, d, inverse));
      if (joints > most) return std::nullopt;
      own = std::max(own, item.spread.plan);
    }
    const double spread = std::sqrt(joints) + own + 4 * kRounding;
    if (spread * spread > most) return std::nullopt;
    return Spread{spread};
  }
  // The spread in plan and upwards, both at one place along the chord. None where a joint lies
  // beyond an end of the chord.
  std::optional<Spread> spread_of_segments(std::span<const Item> items, const Vec3& a,
                                           const Vec3& d) const {
    const double n = std::sqrt(d.x * d.x + d.y * d.y), ux = d.x / n, uy = d.y / n, m = d.z / n;
    if (std::fabs(m) > kSteepChord) return std::nullopt;
    Spread joints, own;
    for (const Item& item : items) {
      const Vec3 q = item.start - a;
      const double along = q.x * ux + q.y * uy;
      if (along < -kRounding || along > n + kRounding) return std::nullopt;
      joints = max(joints, {std::fabs(q.y * ux - q.x * uy), std::fabs(q.z - m * along)});
      own = max(own, item.spread);
    }
    const double room = 4 * kRounding * (1 + kSteepChord);
    const Spread spread = joints + own + Spread{room, room};
    if (in_height(items[0], spread) > kLargestSpread * n) return std::nullopt;
    return spread;
  }
  // By how much the spread may change the height of a tool, mm, about.
  double in_height(const Item& item, const Spread& spread) const {
    if (item.form != Form::segment) return spread.plan;
    return spread.up + slopes_[static_cast<std::size_t>(item.shape)] * spread.plan;
  }

  Item add(std::span<const Item> items, const Spread& spread) {
    const Item& first = items.front();
    Item item = first;
    item.number = kFirstPack + static_cast<std::uint32_t>(packs_.size());
    item.last = items.back().last;
    item.end = items.back().end;
    item.spread = spread;
    SweepPack pack;
    pack.first = item.first, pack.last = item.last;
    pack.spread =
        std::nextafter(static_cast<float>(spread.plan), std::numeric_limits<float>::max());
    const double chord_length = length(item.end - item.start);
    const double reach = columns_.cutter(columns_.refs[item.first]).max_radius();
    pack.length = static_cast<float>(chord_length);
    pack.expand_below = static_cast<float>(
        kExpand * std::max(chord_length, std::sqrt(8 * in_height(first, spread) * reach)));
    if (first.number >= kFirstPack) {
      pack.child = first.number - kFirstPack;
      pack.count = static_cast<std::uint32_t>(items.size());
    }
    const LineRecord chord = chord_of(columns_, first, item.end, spread);
    PackColumns& children = packs_.children_.emplace_back();
    for (std::size_t k = 0; k < items.size(); ++k)
      put_child(children, k, item.form, chord.c, record_of(items[k]));
    packs_.packs_.push_back(pack);
    packs_.chords_.push_back(chord);
    return item;
  }

  const double* record_of(const Item& item) const {
    if (item.number >= kFirstPack) return packs_.chord(item.number).c;
    if (item.form == Form::segment) return columns_.segments[columns_.first_segment[item.number]].c;
    const std::uint32_t row = columns_.tags[item.number] & kTagRow;
    return item.form == Form::strip ? columns_.ball_lines[row].c : columns_.plane_lines[row].c;
  }

  const SweepColumns& columns_;
  std::vector<double> slopes_;  // of the tools' undersides, by shape; 1 or more
  SweepPacks packs_;
};

SweepPacks::SweepPacks(const SweepColumns& columns, int threads) {
  const std::size_t sweeps = columns.refs.size();
  make_in_order((sweeps + kSweepsOfPart - 1) / kSweepsOfPart, threads,
                [&](std::size_t k) {
                  return Builder(columns).build(
                      static_cast<std::uint32_t>(k * kSweepsOfPart),
                      static_cast<std::uint32_t>(std::min((k + 1) * kSweepsOfPart, sweeps)));
                },
                [&](const SweepPacks& part) { append(part, sweeps); });
  if (packs_.empty()) return;
  leaf_of_.resize(sweeps);
  for (std::size_t k = 0; k < packs_.size(); ++k)
    if (packs_[k].count == 0)
      std::fill(leaf_of_.begin() + packs_[k].first, leaf_of_.begin() + packs_[k].last + 1,
                kFirstPack + static_cast<std::uint32_t>(k));
}

void SweepPacks::append(const SweepPacks& part, std::size_t sweeps) {
  if (packs_.empty() && part.size() > 0) {
    const std::size_t most = sweeps / (kLeast - 1) + 1;  // pages are not touched
    reserve_large(packs_, most), reserve_large(chords_, most), reserve_large(children_, most);
  }
  const auto base = static_cast<std::uint32_t>(packs_.size());
  for (SweepPack pack : part.packs_) {
    pack.child += base;
    packs_.push_back(pack);
  }
  for (const std::uint32_t root : part.roots_) roots_.push_back(base + root);
  chords_.insert(chords_.end(), part.chords_.begin(), part.chords_.end());
  children_.insert(children_.end(), part.children_.begin(), part.children_.end());
}

}  // namespace mrsim
