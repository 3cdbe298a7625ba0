#include "compare/step/face_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <BRepAdaptor_Surface.hxx>

namespace mrsim {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

constexpr int kRounds = 24;
constexpr std::size_t kMostTriangles = 20'000'000;  // of one face
constexpr double kThin = 0.001;                     // mm: the height of a sliver
constexpr std::uint32_t kNone = UINT32_MAX;
// The part of the allowed distance that the middles of a triangle's sides may have: its own middle
// can be a third farther from the face than they are.
constexpr double kSideShare = 0.7;
// Barycentric places on a triangle where the face is evaluated: centre, sides, towards the corners.
constexpr double kPlaces[][3] = {{1 / 3., 1 / 3., 1 / 3.},
                                 {.5, .5, 0},
                                 {0, .5, .5},
                                 {.5, 0, .5},
                                 {2 / 3., 1 / 6., 1 / 6.},
                                 {1 / 6., 2 / 3., 1 / 6.},
                                 {1 / 6., 1 / 6., 2 / 3.}};

struct Side {
  std::uint64_t corners;  // the smaller index in the upper half
  std::size_t use;        // 3 x triangle + side
  bool operator<(const Side& o) const {
    return std::pair(corners, use) < std::pair(o.corners, o.use);
  }
};

std::vector<Side> sides_of(const FaceMesh& mesh) {
  std::vector<Side> sides;
  sides.reserve(mesh.triangles.size() * 3);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(mesh.triangles[t][i], mesh.triangles[t][(i + 1) % 3]);
      sides.push_back({std::uint64_t(low) << 32 | high, 3 * t + i});
    }
  std::sort(sides.begin(), sides.end());
  return sides;
}

// For each side of each triangle the new point in its middle, or kNone. Sides of one triangle
// alone are the border's.
std::vector<std::uint32_t> add_middles(const BRepAdaptor_Surface& face, double distance,
                                       FaceMesh& mesh) {
  const std::vector<Side> sides = sides_of(mesh);
  std::vector<std::uint32_t> middles(sides.size(), kNone);
  for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
    if (sides[i].corners != sides[i + 1].corners) continue;
    const auto a = std::uint32_t(sides[i].corners >> 32), b = std::uint32_t(sides[i].corners);
    const gp_XY place = (mesh.places[a] + mesh.places[b]) * 0.5;
    const gp_XYZ on = face.Value(place.X(), place.Y()).XYZ();
    if (distance_from_segment(on, mesh.points[a], mesh.points[b]) > kSideShare * distance) {
      middles[sides[i].use] = middles[sides[i + 1].use] = std::uint32_t(mesh.points.size());
      mesh.points.push_back(on);
      mesh.places.push_back(place);
    }
    ++i;
  }
  return middles;
}

// The parts of a triangle that is cut at the middles of some of its sides.
void divide(const FaceMesh& mesh, Triangle t, std::array<std::uint32_t, 3> middles,
            std::vector<Triangle>& out) {
  const auto count =
      std::count_if(middles.begin(), middles.end(), [](std::uint32_t m) { return m != kNone; });
  if (count == 0) return out.push_back(t);
  // Turned so that the first side has a middle, and the last one has none unless all have one.
  while (middles[0] == kNone || (count == 2 && middles[1] == kNone)) {
    std::rotate(t.begin(), t.begin() + 1, t.end());
    std::rotate(middles.begin(), middles.begin() + 1, middles.end());
  }
  const auto [a, b, c] = t;
  const auto [ab, bc, ca] = middles;
  if (count == 1) {
    out.insert(out.end(), {{a, ab, c}, {ab, b, c}});
  } else if (count == 3) {
    out.insert(out.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  } else {
    out.push_back({ab, b, bc});
    const double one = (mesh.points[a] - mesh.points[bc]).SquareModulus();
    const double other = (mesh.points[ab] - mesh.points[c]).SquareModulus();
    if (one < other)
      out.insert(out.end(), {{a, ab, bc}, {a, bc, c}});
    else
      out.insert(out.end(), {{a, ab, c}, {ab, bc, c}});
  }
}

}  // namespace

double distance_from_segment(const gp_XYZ& p, const gp_XYZ& a, const gp_XYZ& b) {
  const gp_XYZ way = b - a;
  const double t = way.SquareModulus() > 0 ? (p - a).Dot(way) / way.SquareModulus() : 0;
  return (p - (a + way * std::clamp(t, 0.0, 1.0))).Modulus();
}

void refine(const BRepAdaptor_Surface& face, double distance, FaceMesh& mesh) {
  for (int round = 0; round < kRounds && mesh.triangles.size() < kMostTriangles; ++round) {
    const std::size_t before = mesh.points.size();
    const std::vector<std::uint32_t> middles = add_middles(face, distance, mesh);
    if (mesh.points.size() == before) return;
    std::vector<Triangle> finer;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      divide(mesh, mesh.triangles[t], {middles[3 * t], middles[3 * t + 1], middles[3 * t + 2]},
             finer);
    mesh.triangles = std::move(finer);
  }
}

double deviation_of(const BRepAdaptor_Surface& face, const FaceMesh& mesh) {
  double worst = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const gp_XYZ &p = mesh.points[a], &q = mesh.points[b], &r = mesh.points[c];
    const gp_XYZ normal = (q - p).Crossed(r - p);
    const double area = normal.Modulus();
    const double longest = std::max({(q - p).Modulus(), (r - q).Modulus(), (p - r).Modulus()});
    // The plane of a sliver is not known; its neighbours are measured along the sides they share.
    if (area <= kThin * longest) continue;
    for (const auto& w : kPlaces) {
      const gp_XY at = mesh.places[a] * w[0] + mesh.places[b] * w[1] + mesh.places[c] * w[2];
      const gp_XYZ on = face.Value(at.X(), at.Y()).XYZ();
      worst = std::max(worst, std::abs(normal.Dot(on - p)) / area);
    }
  }
  return worst;
}

}  // namespace mrsim
