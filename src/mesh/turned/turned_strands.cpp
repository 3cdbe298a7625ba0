#include "mesh/turned/turned_strands.h"

#include "core/numbers/rounding.h"
#include "core/numbers/vec.h"
#include "mesh/points/surface_search.h"
#include "mesh/points/vertex.h"

#include <cmath>

namespace mrsim::detail {
namespace {

constexpr int kMostHalvings = 16;    ///< of the curve between two points
constexpr double kChordTurn = 0.5;   ///< cosine between the normals at a chord's ends, at least
constexpr double kStraight = 1e-12;  ///< product of two sines: straight at an end, but for rounding
constexpr double kJoined = 0.98;     ///< cosine between normals, for chords over several faces

/// Where the outline passes a line of the lattice. Named by the shortest part of the line that
/// holds it, so that all squares about it agree.
struct LineCrossing {
  std::uint64_t name = 0;
  Vec3 at;
  FieldSample face;
};

// Follows the outline through one square; where the curve is not understood, through its quarters.
class SquareTracer {
 public:
  SquareTracer(const ExactField& field, const HalfPlaneLattice& lattice,
               std::span<const std::uint32_t> candidates, double height)
      : field_(field), lattice_(lattice), candidates_(candidates), height_(height) {}

  TracedSquare trace(const Square& square) {
    look(square);
    return {std::move(strands_), std::move(thin_)};
  }

 private:
  // The crossings of a square's border, counter-clockwise, each with its side of the square.
  struct Border {
    std::vector<LineCrossing> crossings;
    std::vector<int> sides;
    bool first_inside = false;  ///< corner 0
  };

  Probe probe() const { return {field_, candidates_, 0}; }
  FieldSample sample(const Vec3& p) const { return field_.sample(p, candidates_); }

  void look(const Square& q) {
    if (is_clear(q)) return;
    const Border border = border_of(q);
    const std::size_t count = border.crossings.size();
    const std::size_t before = strands_.size();
    bool done = count == 0;
    if (count == 2) {
      // Along the border the part begins where its outline leaves the square.
      const std::size_t first = border.first_inside ? 0 : 1;
      done = connect(q, border.crossings[first], border.crossings[1 - first]);
    }
    if (done && shows_all(q, border, before)) return;
    strands_.resize(before);
    if (q.size > 1) {
      for (int k = 0; k < 4; ++k)
        look({{q.low.x + (k & 1) * (q.size / 2), q.low.z + (k >> 1) * (q.size / 2)}, q.size / 2});
      return;
    }
    // Too small to matter: straight.
    for (std::size_t k = border.first_inside ? 0 : 1; k < count; k += 2) {
      const LineCrossing &a = border.crossings[k], &b = border.crossings[(k + 1) % count];
      strands_.push_back({a.name, b.name, {}, b.at});
      strands_.back().points.push_back({a.at, a.face, 0.5 * distance(a.at, b.at), 0, 0});
    }
  }

  // The surface is farther from the middle than the corners are.
  bool is_clear(const Square& q) const {
    const Vec3 low = lattice_.at(q.low), high = lattice_.at(q.corner(2));
    return std::abs(sample(0.5 * (low + high)).distance) >
           0.5 * distance(low, high) + 2 * kInsideTolerance;
  }

  Border border_of(const Square& q) {
    Border border;
    Vec3 corners[4];
    double d[4];
    for (int k = 0; k < 4; ++k) corners[k] = lattice_.at(q.corner(k));
    field_.distances(corners, candidates_, d, nullptr);
    border.first_inside = is_inside(d[0]);
    for (int side = 0; side < 4; ++side) {
      const std::size_t before = border.crossings.size();
      const int low = side < 2 ? side : (side + 1) % 4, high = side < 2 ? side + 1 : side;
      find_crossings(q.corner(low), side % 2, q.size, d[low], d[high], border.crossings);
      if (side >= 2)
        std::reverse(border.crossings.begin() + static_cast<std::ptrdiff_t>(before),
                     border.crossings.end());
      border.sides.resize(border.crossings.size(), side);
    }
    return border;
  }

  // All crossings on a part of a line, upwards: d is 1-Lipschitz, so that its values at the ends
  // exclude parts of it. The crossings found do not depend on the part that is searched first.
  void find_crossings(LatticeNode low, int axis, std::int32_t size, double at_low, double at_high,
                      std::vector<LineCrossing>& out) {
    const auto node = [&](std::int32_t along) {
      return axis == 0 ? LatticeNode{low.x + along, low.z} : LatticeNode{low.x, low.z + along};
    };
    const Vec3 a = lattice_.at(low), b = lattice_.at(node(size));
    const bool differ = is_inside(at_low) != is_inside(at_high);
    if (!differ && std::abs(at_low) + std::abs(at_high) > distance(a, b)) return;
    if (size > 1) {
      const double middle = sample(lattice_.at(node(size / 2))).distance;
      find_crossings(low, axis, size / 2, at_low, middle, out);
      find_crossings(node(size / 2), axis, size / 2, middle, at_high, out);
    } else if (differ) {
      out.push_back(crossing(low, axis, is_inside(at_low) ? a : b, is_inside(at_low) ? b : a));
    } else if (const auto found = thin_between(probe(), a, b)) {
      const std::int32_t block = kThinBlock * lattice_.per_voxel();
      thin_.push_back({*found, key({low.x / block, 0, low.z / block})});
    }
  }

  LineCrossing crossing(LatticeNode low, int axis, const Vec3& inside, const Vec3& outside) const {
    LineCrossing c;
    c.name = (static_cast<std::uint64_t>(low.x) << 32 | static_cast<std::uint32_t>(low.z)) << 1 |
             static_cast<std::uint64_t>(axis);
    c.at = find_crossing(probe(), inside, outside);
    c.face = sample(c.at);
    // Crossings are looked for at -kInsideTolerance.
    if (std::abs(c.face.distance) <= 2 * kInsideTolerance)
      c.at = c.at - field_.patch_distance(c.at, c.face) * section_normal(c.at, c.face);
    c.at.x = std::max(c.at.x, 0.0);
    if (low.x == 0 && axis == 1) c.at.x = 0;
    return c;
  }

  Vec3 section_normal(const Vec3& p, const FieldSample& face) const {
    Vec3 n = field_.gradient(p, face);
    n.y = 0;
    return n;
  }

  bool connect(const Square& q, const LineCrossing& from, const LineCrossing& to) {
    room_ = {lattice_.at(q.low), lattice_.at(q.corner(2))};
    strands_.push_back({from.name, to.name, {}, to.at});
    return connect({from.at, from.face}, {to.at, to.face}, 0);
  }

  struct End {
    Vec3 at;
    FieldSample face;
  };

  // Appends the points from a up to b, without b. False where the curve between them is not
  // understood: something else may be there.
  bool connect(const End& a, const End& b, int halvings) {
    if (!same_face(a.face, b.face)) return connect_faces(a, b, halvings);
    const Vec3 along = b.at - a.at, n = section_normal(a.at, a.face),
               m = section_normal(b.at, b.face);
    const double size = length(along);
    if (size < kSamePlace) return add(a, b, 0);
    // The curve of one face bends one way only: it lies between the chord and the tangents at its
    // ends.
    const double rise = -dot(n, along) / size, fall = dot(m, along) / size;
    const double turn = std::abs(n.x * m.z - n.z * m.x);
    const double top = turn > kTurnRounding ? size * std::abs(rise * fall) / turn
                                            : size * std::max(std::abs(rise), std::abs(fall));
    const bool bends_one_way = rise * fall >= -kStraight && dot(n, m) > kChordTurn;
    if (bends_one_way && top <= height_) return add(a, b, top);
    Vec3 middle = 0.5 * (a.at + b.at);
    if (halvings == kMostHalvings || !solve_faces(field_, {&a.face, 1}, 1, room_, middle) ||
        !is_on_surface(middle))
      return false;
    return connect(a, {middle, a.face}, halvings + 1) && connect({middle, a.face}, b, halvings + 1);
  }

  bool connect_faces(const End& a, const End& b, int halvings) {
    const FieldSample faces[2] = {a.face, b.face};
    Vec3 corner = 0.5 * (a.at + b.at);
    if (solve_faces(field_, faces, 1, room_, corner) && is_on_surface(corner)) {
      if (!connect(a, {corner, a.face}, halvings)) return false;
      const std::size_t first = strands_.back().points.size();
      if (!connect({corner, b.face}, b, halvings)) return false;
      strands_.back().points[first].bend =
          distance(section_normal(corner, a.face), section_normal(corner, b.face));
      return true;
    }
    // Faces that join nearly smoothly, or so many that all of them lie along the chord.
    if (dot(section_normal(a.at, a.face), section_normal(b.at, b.face)) < kJoined) return false;
    constexpr int kSamples = 8;
    double most = 0;
    for (int k = 1; k < kSamples; ++k)
      most = std::max(most, std::abs(sample(lerp(a.at, b.at, 1.0 * k / kSamples)).distance));
    return most <= height_ && add(a, b, 2 * most);
  }

  bool is_on_surface(const Vec3& p) const {
    return p.x >= room_.lo.x && p.x <= room_.hi.x && p.z >= room_.lo.z && p.z <= room_.hi.z &&
           std::abs(sample(p).distance) <= kOnSurface;
  }

  // The chord from a to b, if the part is no farther from it than `height`. Gauss's three points.
  bool add(const End& a, const End& b, double height) {
    constexpr double kOff = 0.1127016653792583, kWeights[3] = {5.0 / 18, 8.0 / 18, 5.0 / 18};
    const Vec3 places[3] = {lerp(a.at, b.at, kOff), lerp(a.at, b.at, 0.5),
                            lerp(a.at, b.at, 1 - kOff)};
    double d[3], mean = 0;
    field_.distances(places, candidates_, d, nullptr);
    for (int k = 0; k < 3; ++k) {
      if (std::abs(d[k]) > height + 2 * kInsideTolerance) return false;
      mean += kWeights[k] * d[k];
    }
    strands_.back().points.push_back({a.at, a.face, height, mean * distance(a.at, b.at), 0});
    return true;
  }

  // Checks points within the square: is each on the side that the strands found say?
  bool shows_all(const Square& q, const Border& border, std::size_t first) const {
    constexpr int kParts = 4;
    if (q.size < kParts) return true;
    Vec3 places[(kParts - 1) * (kParts - 1)];
    double d[(kParts - 1) * (kParts - 1)];
    int count = 0;
    for (int i = 1; i < kParts; ++i)
      for (int j = 1; j < kParts; ++j)
        places[count++] =
            lattice_.at({q.low.x + i * q.size / kParts, q.low.z + j * q.size / kParts});
    field_.distances(places, candidates_, d, nullptr);
    std::vector<Vec3> material;
    if (strands_.size() > first) material = material_in(q, border, strands_.back());
    for (int k = 0; k < count; ++k) {
      const bool shown = material.empty() ? border.first_inside : holds(material, places[k]);
      if (is_inside(d[k]) != shown && std::abs(d[k]) > height_ + kInsideTolerance) return false;
    }
    return true;
  }

  // The polygon of the material: from where the strand leaves the square, along the border to where
  // it enters, and back on the strand.
  std::vector<Vec3> material_in(const Square& q, const Border& border, const Strand& strand) const {
    const int begin = border.first_inside ? 0 : 1;
    const int entry = border.sides[static_cast<std::size_t>(begin)],
              exit = border.sides[static_cast<std::size_t>(1 - begin)];
    std::vector<Vec3> loop;
    for (const OutlinePoint& p : strand.points) loop.push_back(p.at);
    loop.push_back(strand.end);
    // Corners of the square in the material: the first one's side is known.
    const int around = (entry - exit + 4) % 4;
    const int corners = around == 0 && border.first_inside ? 4 : around;
    for (int k = 1; k <= corners; ++k) loop.push_back(lattice_.at(q.corner((exit + k) % 4)));
    return loop;
  }

  static bool holds(const std::vector<Vec3>& loop, const Vec3& p) {
    bool inside = false;
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const Vec3 &a = loop[k], &b = loop[(k + 1) % loop.size()];
      if ((a.z > p.z) != (b.z > p.z) && p.x < a.x + (p.z - a.z) / (b.z - a.z) * (b.x - a.x))
        inside = !inside;
    }
    return inside;
  }

  const ExactField& field_;
  const HalfPlaneLattice& lattice_;
  std::span<const std::uint32_t> candidates_;
  double height_;
  Box3 room_;  ///< of the square that the last strand passes
  std::vector<Strand> strands_;
  std::vector<FoundThin> thin_;
};

}  // namespace

TracedSquare trace_square(const ExactField& field, const HalfPlaneLattice& lattice,
                          const Square& square, std::span<const std::uint32_t> candidates,
                          double height) {
  return SquareTracer(field, lattice, candidates, height).trace(square);
}

}  // namespace mrsim::detail
