#include "mesh/turned_outline.h"

#include "core/parallel.h"
#include "core/vec.h"
#include "mesh/contour_cells.h"
#include "mesh/contour_search.h"
#include "mesh/contour_vertex.h"
#include "removal/lattice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace mrsim::detail {
namespace {

constexpr int kMostHalvings = 16;    ///< of the curve between two points
constexpr double kAlong = 0.5;       ///< cosine between the ends of a piece, at least
constexpr double kJoined = 0.98;     ///< the same of pieces over several faces
constexpr double kSamePlace = 1e-7;  ///< mm
constexpr double kSureVoxels = 2;    ///< where d is the same whatever the list

struct Node {
  std::int32_t x = 0, z = 0;
};

// The lattice in the half plane, down to 1 / per_voxel of a voxel; the first line is the axis.
class HalfPlaneLattice {
 public:
  HalfPlaneLattice(const Box3& bounds, double voxel, double finest) : voxel_(voxel) {
    while (voxel / per_voxel_ > finest && per_voxel_ < kMostParts) per_voxel_ *= 2;
    first_z_ = lattice_floor(voxel, bounds.lo.z, kLatticeShift.z) - 1;
    const double longest = std::max(bounds.hi.x, bounds.hi.z - bounds.lo.z);
    while (size_ < longest / voxel + 4) size_ *= 2;
  }
  double voxel() const { return voxel_; }
  std::int32_t per_voxel() const { return per_voxel_; }
  std::int32_t size() const { return size_ * per_voxel_; }  ///< of a square that holds the section
  Vec3 at(Node n) const {
    const double u = static_cast<double>(n.x) / per_voxel_, shift = 1 - kLatticeShift.x;
    const double w = static_cast<double>(n.z) / per_voxel_;
    return {voxel_ * (u < 1 ? u * (1 - shift) : u - shift), 0,
            voxel_ * (static_cast<double>(first_z_) + kLatticeShift.z + w)};
  }

 private:
  static constexpr std::int32_t kMostParts = 1 << 10;
  double voxel_;
  std::int32_t per_voxel_ = 1, size_ = 1;
  std::int64_t first_z_ = 0;
};

struct Square {
  Node low;
  std::int32_t size = 0;
  // Counter-clockwise.
  Node corner(int k) const {
    return {low.x + (k == 1 || k == 2 ? size : 0), low.z + (k >= 2 ? size : 0)};
  }
};

/// Where the outline passes a line of the lattice. Named by the shortest part of the line that
/// holds it, so that all squares about it agree.
struct LineCrossing {
  std::uint64_t name = 0;
  Vec3 at;
  FieldSample face;
};

/// The outline within a square.
struct Strand {
  std::uint64_t from = 0, to = 0;
  std::vector<OutlinePoint> points;  ///< without the end
  Vec3 end;
};

// Follows the outline through one square, and through its quarters where it does not understand
// what it finds there.
class SquareTracer {
 public:
  SquareTracer(const ExactField& field, const HalfPlaneLattice& lattice, double height)
      : field_(field), lattice_(lattice), height_(height) {}

  void trace(const Square& square, std::span<const std::uint32_t> candidates) {
    candidates_ = candidates;
    look(square);
  }
  std::vector<Strand>& strands() { return strands_; }
  std::vector<FoundThin>& thin() { return thin_; }

 private:
  // What passes the border, counter-clockwise, and the side of it on which it does.
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
  // tell where none can be. What is found does not depend on the part one begins with.
  void find_crossings(Node low, int axis, std::int32_t size, double at_low, double at_high,
                      std::vector<LineCrossing>& out) {
    const auto node = [&](std::int32_t along) {
      return axis == 0 ? Node{low.x + along, low.z} : Node{low.x, low.z + along};
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

  LineCrossing crossing(Node low, int axis, const Vec3& inside, const Vec3& outside) const {
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
    const double top = turn > 1e-9 ? size * std::abs(rise * fall) / turn
                                   : size * std::max(std::abs(rise), std::abs(fall));
    const bool bends_one_way = rise * fall >= -1e-12 && dot(n, m) > kAlong;
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
    constexpr double kOff = 0.1127016653792583, kShares[3] = {5.0 / 18, 8.0 / 18, 5.0 / 18};
    const Vec3 places[3] = {lerp(a.at, b.at, kOff), lerp(a.at, b.at, 0.5),
                            lerp(a.at, b.at, 1 - kOff)};
    double d[3], mean = 0;
    field_.distances(places, candidates_, d, nullptr);
    for (int k = 0; k < 3; ++k) {
      if (std::abs(d[k]) > height + 2 * kInsideTolerance) return false;
      mean += kShares[k] * d[k];
    }
    strands_.back().points.push_back({a.at, a.face, height, mean * distance(a.at, b.at), 0});
    return true;
  }

  // Whether points within the square lie on the side on which what was found has them.
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

  // From where the strand leaves the square along the border to where it enters, and back on it.
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
  double height_;
  std::span<const std::uint32_t> candidates_;
  Box3 room_;  ///< of the square that the last strand passes
  std::vector<Strand> strands_;
  std::vector<FoundThin> thin_;
};

struct Leaf {
  Square square;
  Candidates candidates;
};

// The voxels that the surface may pass.
class Leaves {
 public:
  Leaves(const ExactField& field, const HalfPlaneLattice& lattice)
      : field_(field), lattice_(lattice) {
    const Candidates all = field.all();
    descend({{0, 0}, lattice.size()}, all);
  }
  const std::vector<Leaf>& all() const { return leaves_; }

 private:
  void descend(const Square& q, std::span<const std::uint32_t> in) {
    const Box3 box{lattice_.at(q.low), lattice_.at(q.corner(2))};
    Candidates own;
    if (field_.restrict_to(reach_of(box, lattice_.voxel()), kSureVoxels * lattice_.voxel(), in,
                           own) != ExactField::Region::mixed)
      return;
    if (q.size == lattice_.per_voxel()) {
      leaves_.push_back({q, std::move(own)});
      return;
    }
    for (int k = 0; k < 4; ++k)
      descend({{q.low.x + (k & 1) * (q.size / 2), q.low.z + (k >> 1) * (q.size / 2)}, q.size / 2},
              own);
  }

  const ExactField& field_;
  const HalfPlaneLattice& lattice_;
  std::vector<Leaf> leaves_;
};

// What begins where the last piece does takes its place, but for the point of the axis.
void append(const OutlinePoint& p, std::vector<OutlinePoint>& out) {
  if (out.empty() || distance(out.back().at, p.at) >= kSamePlace) {
    out.push_back(p);
    return;
  }
  OutlinePoint& last = out.back();
  last = {last.at.x == 0 ? last.at : p.at, p.face, p.height, p.excess, std::max(last.bend, p.bend)};
}

// Strands end to end: first those that begin at the axis.
std::vector<Outline> joined(const std::vector<Strand>& strands) {
  using Start = std::pair<std::uint64_t, std::size_t>;
  std::vector<Start> starts;
  std::vector<std::uint64_t> ends;
  for (std::size_t k = 0; k < strands.size(); ++k) {
    starts.emplace_back(strands[k].from, k);
    ends.push_back(strands[k].to);
  }
  std::sort(starts.begin(), starts.end());
  std::sort(ends.begin(), ends.end());
  const auto next = [&](const Strand& s) {
    const auto found = std::lower_bound(starts.begin(), starts.end(), Start{s.to, 0});
    return found != starts.end() && found->first == s.to ? found->second : strands.size();
  };
  std::vector<char> used(strands.size(), 0);
  std::vector<Outline> out;
  const auto follow = [&](std::size_t k) {
    Outline line;
    Vec3 end;
    for (; k < strands.size() && !used[k]; k = next(strands[k])) {
      used[k] = 1;
      for (const OutlinePoint& p : strands[k].points) append(p, line.points);
      end = strands[k].end;
    }
    line.closed = k < strands.size();
    if (!line.closed) {
      append({end, line.points.back().face, 0, 0, 0}, line.points);
      line.points.back().at = end;
    }
    out.push_back(std::move(line));
  };
  for (std::size_t k = 0; k < strands.size(); ++k)
    if (!std::binary_search(ends.begin(), ends.end(), strands[k].from)) follow(k);
  for (std::size_t k = 0; k < strands.size(); ++k)
    if (!used[k]) follow(k);
  return out;
}

// A piece or a hole as small as the smallest squares.
FoundThin unresolved(const Outline& line, const HalfPlaneLattice& lattice) {
  const OutlinePoint &a = line.points.front(), &b = line.points.back();
  const auto [low, high] = std::minmax(a.face.owner, b.face.owner);
  const double block = kThinBlock * lattice.voxel();
  const auto index = [&](double x) { return static_cast<std::int32_t>(x / block); };
  const double size = lattice.voxel() / lattice.per_voxel();
  return {{a.at, true, size, {low, high}},
          key({index(a.at.x), 0, index(a.at.z - lattice.at({}).z)})};
}

}  // namespace

TurnedSection turned_section(const ExactField& field, double voxel, double height, double finest,
                             int threads) {
  const HalfPlaneLattice lattice(field.bounds(), voxel, finest);
  const Leaves leaves(field, lattice);
  struct Found {
    std::vector<Strand> strands;
    std::vector<FoundThin> thin;
  };
  std::vector<Found> found(leaves.all().size());
  parallel_for(
      found.size(), threads,
      [&](std::size_t k) {
        SquareTracer tracer(field, lattice, height);
        tracer.trace(leaves.all()[k].square, leaves.all()[k].candidates);
        found[k] = {std::move(tracer.strands()), std::move(tracer.thin())};
      },
      8);
  TurnedSection section;
  section.squares = leaves.all().size();
  std::vector<Strand> strands;
  for (Found& f : found) {
    std::move(f.strands.begin(), f.strands.end(), std::back_inserter(strands));
    section.lost.insert(section.lost.end(), f.thin.begin(), f.thin.end());
  }
  for (Outline& line : joined(strands))
    if (line.points.size() > 2)
      section.outlines.push_back(std::move(line));
    else
      section.lost.push_back(unresolved(line, lattice));
  return section;
}

}  // namespace mrsim::detail
