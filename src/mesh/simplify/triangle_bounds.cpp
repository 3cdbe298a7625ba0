#include "mesh/simplify/triangle_bounds.h"

#include "mesh/points/vertex.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

namespace mrsim::detail {
namespace {

constexpr double kIntrusion = 1.5;  ///< factor on the distance of a face that is not the triangle's
constexpr double kFlat = 2e-5;      ///< mm: deviations that rounding of coordinates explains
constexpr double kEvenShare = 0.15, kUneven = 0.4;  ///< shares of second and third differences
constexpr double kSmoothAngle = 0.05;  ///< sine below which a crease is measured from its faces
constexpr double kNearlySmooth =
    0.9;                         ///< cosine between a triangle and faces that join nearly smoothly
constexpr double kTaper = -0.5;  ///< cosine below which a face across a crease makes a sharp edge
constexpr int kRefinements = 3;  ///< of a triangle into quarters
constexpr int kSides = 4;        ///< nodes at quarters of the sides and between
constexpr double kNoDistance = std::numeric_limits<double>::infinity();

// Node (i, j): i quarters towards b, j towards c.
struct Nodes {
  double value[kSides + 1][kSides + 1];

  double largest() const {
    double most = 0;
    for (int i = 0; i <= kSides; ++i)
      for (int j = 0; i + j <= kSides; ++j) most = std::max(most, std::abs(value[i][j]));
    return most;
  }
  // What the distance can do between the nodes: a share of its second differences where it bends
  // evenly, a larger one of their change, for a bend between two nodes.
  double remainder() const {
    double second = 0, third = 0;
    const auto along = [&](int i, int j, int u, int v, int n) {
      double last = 0;
      for (int k = 1; k < n; ++k) {
        const double d = value[i + (k - 1) * u][j + (k - 1) * v] - 2 * value[i + k * u][j + k * v] +
                         value[i + (k + 1) * u][j + (k + 1) * v];
        second = std::max(second, std::abs(d));
        if (k > 1) third = std::max(third, std::abs(d - last));
        last = d;
      }
    };
    for (int k = 0; k + 2 <= kSides; ++k) {
      along(0, k, 1, 0, kSides - k);
      along(k, 0, 0, 1, kSides - k);
      along(kSides - k, 0, -1, 1, kSides - k);
    }
    return kEvenShare * second + kUneven * third;
  }
};

Vec3 node_at(const Vec3& a, const Vec3& b, const Vec3& c, double i, double j) {
  return (1.0 / kSides) * ((kSides - i - j) * a + i * b + j * c);
}

double largest_of(const FaceRange& range) { return std::max(-range.lo, range.hi); }

using Quarters = std::array<Corners3, 4>;

Quarters quarters(const Corners3& t) {
  const Corners3 m{0.5 * (t[1] + t[2]), 0.5 * (t[2] + t[0]), 0.5 * (t[0] + t[1])};
  return {m, {t[0], m[2], m[1]}, {m[2], t[1], m[0]}, {m[1], m[0], t[2]}};
}

// Encloses the quarters of a triangle, then the quarters of these, until all enclosures are within
// the limit or a value of g exceeds it. Infinite where nothing is known of a part.
double refined(FaceDistances& distances, const FieldSample& face, const Corners3& t, double limit,
               int depth) {
  const Quarters parts = quarters(t);
  for (const Vec3& p : parts[0])
    if (const double g = std::abs(distances(p, face)); g > limit) return g;
  double most = 0;
  for (const Corners3& part : parts) {
    double enclosed = largest_of(distances.field().patch_range(part, face));
    if (enclosed > limit && depth > 1) enclosed = refined(distances, face, part, limit, depth - 1);
    most = std::max(most, enclosed);
    if (most > limit) break;
  }
  return most;
}

// Whether anything is known of a quarter: the faces of some sweeps are never enclosed, others only
// where the triangle is small.
bool has_known_part(const ExactField& field, const FieldSample& face, const Corners3& t) {
  const Quarters parts = quarters(t);
  return std::any_of(parts.begin(), parts.end(), [&](const Corners3& part) {
    return std::isfinite(largest_of(field.patch_range(part, face)));
  });
}

double sampled_bound(FaceDistances& distances, const FieldSample& face, const Vec3& a,
                     const Vec3& b, const Vec3& c, double limit) {
  Nodes nodes;
  double most = 0;
  const auto measure = [&](int i, int j) {
    const Vec3 p = node_at(a, b, c, i, j);
    nodes.value[i][j] = distances(p, face);
    most = std::max(most, std::abs(nodes.value[i][j]));
  };
  for (int i = 0; i <= kSides; i += kSides / 2)
    for (int j = 0; i + j <= kSides; j += kSides / 2) measure(i, j);
  measure(1, 1);
  if (most > limit || most < kFlat) return most;
  for (int i = 0; i <= kSides; ++i)
    for (int j = 0; i + j <= kSides; ++j)
      if ((i % 2 || j % 2) && !(i == 1 && j == 1)) measure(i, j);
  return nodes.largest() + nodes.remainder();
}

// Distance of a node on a triangle's side from the crease on which the side lies. The crease is
// where the face `across`, which decides d at the node, meets the face that runs along the
// triangle; that one is looked up `depth` mm below the node and gives the sign. Infinite where no
// such face is found, or where the edge is too sharp.
double crease_distance(FaceDistances& distances, const CellOctree& tree, const Vec3& p,
                       const FieldSample& across, const Vec3& normal, double depth) {
  const ExactField& field = distances.field();
  const Vec3 out = field.gradient(p, across);
  if (!(dot(normal, out) > kTaper * length(normal))) return kNoDistance;
  const Vec3 beneath = p - (std::max(across.distance, 0.0) + depth) * out;
  const FieldSample along = tree.sample_at(beneath, tree.locate(beneath));
  if (!(dot(normal, field.gradient(beneath, along)) > kNearlySmooth * length(normal)))
    return kNoDistance;
  return std::copysign(crease_bound(distances, along, across, p, p), distances(p, along));
}

// Distance of a place from the face that decides d there. In the material it is |d|; in a sweep d
// may be less than the depth, by the root of 2 at most.
double depth_under(FaceDistances& distances, const Vec3& p, const FieldSample& face) {
  const double d = std::abs(face.distance);
  return face.distance < kFlat ? d : std::clamp(distances(p, face), d, kIntrusion * d);
}

// Distance of a node from the part where `other` decides d, not the triangle's face; half as much
// again, as the other face may reach farther in between the nodes, unless both are one surface
// here. In the air beside an edge d is only the larger distance of its two faces: the place of
// `other` that is nearest may be cut off by the triangle's face, and the edge is what is nearest.
double distance_beside(FaceDistances& distances, const Vec3& p, const FieldSample& face,
                       const FieldSample& other) {
  const double d = std::abs(other.distance), g = distances(p, face);
  const double room = std::abs(other.distance - g) < 0.25 * d ? 1 : kIntrusion;
  if (other.distance < kFlat) return room * d;
  const double depth = depth_under(distances, p, other);
  const double along =
      dot(distances.field().gradient(p, face), distances.field().gradient(p, other));
  if (g - depth * along <= 0) return std::max(room * d, depth);
  return std::max(room * d, crease_bound(distances, face, other, p, p));
}

}  // namespace

double largest_distance(FaceDistances& distances, const CellOctree& tree, const FieldSample& face,
                        const Vec3& a, const Vec3& b, const Vec3& c, double limit,
                        std::int32_t& cell) {
  // Interior nodes and middles first; all of them where the triangle spans many voxels.
  // One order, however the corners are numbered: centroid, middles, inner nodes, quarters, eighths.
  static constexpr double kThird = 4.0 / 3;
  static constexpr double kOrder[19][2] = {{kThird, kThird}, {2, 2},   {2, 0},    {0, 2},   {1, 1},
                                           {1, 2},           {2, 1},   {1, 0},    {3, 0},   {0, 1},
                                           {0, 3},           {1, 3},   {3, 1},    {.5, 0},  {0, .5},
                                           {3.5, 0},         {0, 3.5}, {3.5, .5}, {.5, 3.5}};
  const double longest = std::max({distance(a, b), distance(b, c), distance(c, a)});
  const double voxel = tree.lattice().voxel();
  const int count = longest <= voxel ? 1 : longest <= 4 * voxel ? 4 : 19;
  double most = 0;
  for (int k = 0; k < count; ++k) {
    const Vec3 p = node_at(a, b, c, kOrder[k][0], kOrder[k][1]);
    cell = tree.locate(p, cell);
    if (tree.node(cell).plain && same_face(tree.node(cell).face, face)) continue;
    const FieldSample s = tree.sample_at(p, cell);
    most = std::max(
        most, same_face(s, face) ? std::abs(s.distance) : distance_beside(distances, p, face, s));
    if (most > limit) return most;
  }
  return most;
}

TriangleBound triangle_bound(FaceDistances& distances, const FieldSample& face, const Vec3& a,
                             const Vec3& b, const Vec3& c, double limit) {
  const ExactField& field = distances.field();
  const Corners3 t{a, b, c};
  const double enclosed = largest_of(field.patch_range(t, face));
  if (enclosed <= limit) {
    if (std::isfinite(enclosed)) return {enclosed, true};
  } else if (std::isfinite(enclosed) || has_known_part(field, face, t)) {
    const double found = refined(distances, face, t, limit, kRefinements);
    if (std::isfinite(found)) return {found, true};
  }
  return {sampled_bound(distances, face, a, b, c, limit), false};
}

double part_bound(FaceDistances& distances, const CellOctree& tree, const Vec3& a, const Vec3& b,
                  const Vec3& c, double limit) {
  const ExactField& field = distances.field();
  // The nodes in groups, in the order in which they are likely to show a miss: the middles, the
  // inner nodes, the quarters.
  static constexpr int kOrder[12][2] = {{2, 0}, {0, 2}, {2, 2}, {1, 1}, {2, 1}, {1, 2},
                                        {1, 0}, {3, 0}, {0, 1}, {0, 3}, {3, 1}, {1, 3}};
  static constexpr int kGroups[3] = {3, 6, 12};
  Nodes nodes;
  nodes.value[0][0] = nodes.value[kSides][0] = nodes.value[0][kSides] = 0;  // vertices are exact
  const Vec3 normal = cross(b - a, c - a);
  const double area = length(normal);
  const double depth =
      std::min(limit, std::max({distance(a, b), distance(b, c), distance(c, a)}) / kSides);
  FieldSample face;  // the first along the triangle
  bool has_face = false, has_several = false, has_crease = false;
  std::int32_t cell = 0;
  double most = 0;
  int k = 0;
  for (const int end : kGroups) {
    for (; k < end; ++k) {
      const auto [i, j] = kOrder[k];
      const Vec3 p = node_at(a, b, c, i, j);
      cell = tree.locate(p, cell);
      const FieldSample s = tree.sample_at(p, cell);
      double& value = nodes.value[i][j];
      value = std::copysign(depth_under(distances, p, s), s.distance);
      if (dot(normal, field.gradient(p, s)) > kNearlySmooth * area) {
        if (!has_face) face = s;
        has_face = true;
        has_several = has_several || !same_face(s, face);
      } else {
        const bool is_on_side = i == 0 || j == 0 || i + j == kSides;
        value = is_on_side ? crease_distance(distances, tree, p, s, normal, depth) : kNoDistance;
        if (!std::isfinite(value)) return kNoDistance;
        has_crease = true;
      }
      most = std::max(most, std::abs(value));
    }
    if (most > limit) return most;
  }
  // One face that ends in a crease is measured by itself.
  if (has_crease && !has_several) return kNoDistance;
  return most + nodes.remainder();
}

double excess_over(const ExactField& field, const CellOctree& tree, const FieldSample& face,
                   const Vec3& a, const Vec3& b, const Vec3& c, double limit) {
  struct Orbit {
    double weight, corner, others;
  };
  static constexpr Orbit kOrbits[2] = {{0.223381589678011, 0.108103018168070, 0.445948490915965},
                                       {0.109951743655322, 0.816847572980459, 0.091576213509771}};
  double mean = 0;
  std::int32_t cell = 0;
  for (const Orbit& orbit : kOrbits)
    for (const auto& [p, q, r] : {std::tie(a, b, c), std::tie(b, c, a), std::tie(c, a, b)}) {
      const Vec3 x = orbit.corner * p + orbit.others * (q + r);
      double d = field.patch_distance(x, face);
      if (std::abs(d) > limit) {
        cell = tree.locate(x, cell);
        d = tree.sample_at(x, cell).distance;
      }
      mean += orbit.weight * d;
    }
  return mean * 0.5 * length(cross(b - a, c - a));
}

double crease_bound(FaceDistances& distances, const FieldSample& f, const FieldSample& g,
                    const Vec3& a, const Vec3& b) {
  const Vec3 p = 0.5 * (a + b);
  const Vec3 n = distances.field().gradient(p, f), m = distances.field().gradient(p, g);
  const double x = distances(p, f), y = distances(p, g);
  const double ab = dot(n, m), det = 1 - ab * ab;
  if (det < kSmoothAngle * kSmoothAngle) return std::max(std::abs(x), std::abs(y));
  return std::sqrt(std::max((x * x - 2 * ab * x * y + y * y) / det, 0.0));
}

}  // namespace mrsim::detail
