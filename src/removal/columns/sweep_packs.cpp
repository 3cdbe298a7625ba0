#include "removal/columns/sweep_packs.h"

#include "core/heap.h"
#include "core/ordered.h"
#include "core/vec.h"
#include "removal/columns/sweep_columns.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mrsim {
namespace {

constexpr std::size_t kMost = 8, kLeast = 4;  // members of a pack
constexpr double kStraight = 1.0 / 16;        // of the chord: the largest spread
constexpr double kJoined = 1e-9;              // mm: ends of moves that follow one another
constexpr double kShortest = 1e-3;            // mm in plan: shorter chords have no direction
constexpr std::size_t kPart = 1 << 13;        // sweeps that are packed on their own
constexpr double kExpand = 0.7;               // of a pack: smaller regions see its members

// A sweep or a pack, to be packed.
struct Item {
  std::uint32_t number = 0, first = 0, last = 0;
  std::uint32_t form = kOtherForm;
  std::int32_t shape = 0;
  Vec3 start, end;  // of the path
  double spread = 0;
};

Item item_of(const SweepColumns& c, std::uint32_t sweep) {
  Item item;
  item.number = item.first = item.last = sweep;
  const std::uint32_t form = c.tags[sweep] >> kTagShift, row = c.tags[sweep] & kTagRow;
  item.shape = c.refs[sweep].shape;
  if (form == 0) {
    const double* r = c.ball_lines[row].c;
    item.start = {r[BallSlot::x], r[BallSlot::y], r[BallSlot::z]};
    item.end = {r[BallSlot::x] + r[BallSlot::ux] * r[BallSlot::length],
                r[BallSlot::y] + r[BallSlot::uy] * r[BallSlot::length],
                r[BallSlot::z] + r[BallSlot::slope] * r[BallSlot::length]};
    item.form = form;
  } else if (form == 1) {
    const double* r = c.plane_lines[row].c;
    item.start = {r[LineSlot::x], r[LineSlot::y], r[LineSlot::low]};
    item.end = {r[LineSlot::x] + r[LineSlot::dx], r[LineSlot::y] + r[LineSlot::dy],
                r[LineSlot::low]};
    item.form = form;
  }
  return item;
}

// Children are sweeps, or packs that were made one after another.
bool follows(const Item& a, const Item& b) {
  return b.number == a.number + 1 && a.form != kOtherForm && b.form == a.form &&
         b.shape == a.shape && b.first == a.last + 1 && (a.form == 0 || a.start.z == b.start.z) &&
         length(b.start - a.end) <= kJoined;
}

// From the segment that begins at a, d long.
double squared_distance(const Vec3& p, const Vec3& a, const Vec3& d, double inverse) {
  const Vec3 e = p - a;
  const Vec3 off = e - std::clamp(dot(e, d) * inverse, 0.0, 1.0) * d;
  return dot(off, off);
}

// The sweep from the start of an item to b, of its form and tool.
LineRecord chord_of(const SweepColumns& c, const Item& first, const Vec3& b) {
  const std::uint32_t row = c.tags[first.first] & kTagRow;
  LineRecord chord = first.form == 0 ? c.ball_lines[row] : c.plane_lines[row];
  const double dx = b.x - first.start.x, dy = b.y - first.start.y;
  if (first.form == 1) {
    chord.c[LineSlot::dx] = dx, chord.c[LineSlot::dy] = dy;
    return chord;
  }
  const double n = std::sqrt(dx * dx + dy * dy);
  chord.c[BallSlot::ux] = dx / n, chord.c[BallSlot::uy] = dy / n, chord.c[BallSlot::length] = n,
  chord.c[BallSlot::slope] = (b.z - first.start.z) / n;
  return chord;
}

}  // namespace

// Lane k: a child with the record `child`.
void put_child(PackColumns& to, std::size_t k, std::uint32_t form, const double* chord,
               const double* child) {
  const auto put = [&](std::initializer_list<double> values) {
    std::size_t i = 0;
    for (const double v : values) to.c[i++][k] = static_cast<float>(v);
  };
  const double x = child[BallSlot::x] - chord[BallSlot::x],
               y = child[BallSlot::y] - chord[BallSlot::y];
  if (form == 0)
    put({x, y, child[BallSlot::z] - chord[BallSlot::z], child[BallSlot::ux], child[BallSlot::uy],
         child[BallSlot::length], child[BallSlot::slope],
         1 / (1 + child[BallSlot::slope] * child[BallSlot::slope])});
  else
    put({x, y, child[LineSlot::dx], child[LineSlot::dy],
         1 / std::max(child[LineSlot::dx] * child[LineSlot::dx] +
                          child[LineSlot::dy] * child[LineSlot::dy],
                      1e-30),
         0, 0});
}

// The packs of some sweeps, numbered from kFirstPack on.
class SweepPacks::Builder {
 public:
  explicit Builder(const SweepColumns& columns) : columns_(columns) {}

  // Level by level, until nothing more can be packed.
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
      // What bends too much for few moves mostly does for more.
      double spread = n < kLeast ? -1 : spread_of({&items[i], kLeast});
      if (spread >= 0)
        while (n > kLeast && (spread = spread_of({&items[i], n})) < 0) --n;
      if (spread >= 0) {
        above.push_back(add({&items[i], n}, spread));
        i += n;
      } else if (items[i++].number >= kFirstPack) {
        above.push_back(items[i - 1]);
      }
    }
    return packs_.size() > before;
  }

  // How far the paths leave their chord; negative where that is too much.
  static double spread_of(std::span<const Item> items) {
    const Vec3 &a = items.front().start, d = items.back().end - a;
    if (d.x * d.x + d.y * d.y < kShortest * kShortest) return -1;
    const double size = dot(d, d), most = kStraight * kStraight * size, inverse = 1 / size;
    double joints = 0, own = 0;
    for (const Item& item : items) {
      joints = std::max(joints, squared_distance(item.start, a, d, inverse));
      if (joints > most) return -1;
      own = std::max(own, item.spread);
    }
    const double spread = std::sqrt(joints) + own + 4 * kJoined;
    return spread * spread <= most ? spread : -1;
  }

  Item add(std::span<const Item> items, double spread) {
    const Item& first = items.front();
    Item item = first;
    item.number = kFirstPack + static_cast<std::uint32_t>(packs_.size());
    item.last = items.back().last;
    item.end = items.back().end;
    item.spread = spread;
    SweepPack pack;
    pack.first = item.first, pack.last = item.last;
    pack.spread = std::nextafter(static_cast<float>(spread), std::numeric_limits<float>::max());
    const double chord_length = length(item.end - item.start);
    const double reach = columns_.cutter(columns_.refs[item.first]).max_radius();
    pack.length = static_cast<float>(chord_length);
    pack.expand_below =
        static_cast<float>(kExpand * std::max(chord_length, std::sqrt(8 * spread * reach)));
    if (first.number >= kFirstPack) {
      pack.child = first.number - kFirstPack;
      pack.count = static_cast<std::uint32_t>(items.size());
    }
    const LineRecord chord = chord_of(columns_, first, item.end);
    PackColumns& children = packs_.children_.emplace_back();
    for (std::size_t k = 0; k < items.size(); ++k)
      put_child(children, k, item.form, chord.c, record_of(items[k]));
    packs_.packs_.push_back(pack);
    packs_.chords_.push_back(chord);
    return item;
  }

  const double* record_of(const Item& item) const {
    if (item.number >= kFirstPack) return packs_.chord(item.number).c;
    const std::uint32_t row = columns_.tags[item.number] & kTagRow;
    return item.form == 0 ? columns_.ball_lines[row].c : columns_.plane_lines[row].c;
  }

  const SweepColumns& columns_;
  SweepPacks packs_;
};

SweepPacks::SweepPacks(const SweepColumns& columns, int threads) {
  const std::size_t sweeps = columns.refs.size();
  make_in_order((sweeps + kPart - 1) / kPart, threads,
                [&](std::size_t k) {
                  return Builder(columns).build(
                      static_cast<std::uint32_t>(k * kPart),
                      static_cast<std::uint32_t>(std::min((k + 1) * kPart, sweeps)));
                },
                [&](const SweepPacks& part) { append(part, sweeps); });
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
