#include "compare/report/display_mesh.h"

#include "compare/distance/align.h"
#include "core/numbers/rounding.h"
#include "core/numbers/trig.h"
#include "core/numbers/vec.h"
#include "mesh/solid/half_edges.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr std::uint32_t kNoVertex = ~0u;
constexpr int kMostPasses = 10;

double size_of(const TriMesh& mesh) {
  Box3 box;
  for (const auto& v : mesh.vertices) extend(box, to_vec(v));
  return distance(box.lo, box.hi);
}

std::vector<float> deviations(const std::vector<Vec3>& points, const NominalSurface& nominal,
                              int threads) {
  std::vector<SurfaceHit> hits(points.size());
  nominal.query(points, hits, threads);
  std::vector<float> out(points.size());
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = float(hits[i].distance);
  return out;
}

// One pass: the vertex in the middle of each half edge that is split.
struct Split {
  std::vector<std::uint32_t> middle;  // 3 #F
  std::size_t count = 0;
};

Split choose_splits(DisplayMesh& display, const NominalSurface& nominal, double band, double size,
                    std::size_t room, int threads) {
  const TriMesh& mesh = display.mesh;
  const std::vector<std::uint32_t> opposite = find_opposites(mesh, threads);
  std::vector<std::uint32_t> edges;
  std::vector<Vec3> middles;
  for (std::uint32_t h = 0; h < opposite.size(); ++h) {
    if (is_half_edge(opposite[h]) && opposite[h] < h) continue;
    const Vec3 a = to_vec(mesh.vertices[origin_of(mesh, h)]),
               b = to_vec(mesh.vertices[target_of(mesh, h)]);
    if (distance(a, b) <= size / 500) continue;
    edges.push_back(h);
    middles.push_back(lerp(a, b, 0.5));
  }
  const std::vector<float> found = deviations(middles, nominal, threads);
  Split out{std::vector<std::uint32_t>(opposite.size(), kNoVertex), 0};
  for (std::size_t i = 0; i < edges.size() && out.count < room; ++i) {
    const std::uint32_t h = edges[i], from = origin_of(mesh, h), to = target_of(mesh, h);
    const double mean = (double(display.deviation[from]) + double(display.deviation[to])) / 2;
    const bool is_long =
        distance(to_vec(mesh.vertices[from]), to_vec(mesh.vertices[to])) > size / 64;
    if (!is_long && std::abs(double(found[i]) - mean) <= band) continue;
    const auto vertex = std::uint32_t(mesh.vertices.size());
    const Vec3& p = middles[i];
    display.mesh.vertices.push_back({float(p.x), float(p.y), float(p.z)});
    display.deviation.push_back(found[i]);
    out.middle[h] = vertex;
    if (is_half_edge(opposite[h])) out.middle[opposite[h]] = vertex;
    ++out.count;
  }
  return out;
}

// The triangles of one face with 0 to 3 split edges; the shorter diagonal where there is a choice.
void emit(const TriMesh& mesh, std::size_t face, const Split& split,
          std::vector<std::array<std::uint32_t, 3>>& out) {
  std::array<std::uint32_t, 3> v = mesh.triangles[face], m;
  int splits = 0;
  for (std::size_t k = 0; k < 3; ++k) splits += (m[k] = split.middle[3 * face + k]) != kNoVertex;
  // Turned until the split edges come first, or the whole one last.
  for (int turn = 0; turn < 2; ++turn)
    if ((splits == 1 && m[0] == kNoVertex) || (splits == 2 && m[2] != kNoVertex)) {
      std::rotate(v.begin(), v.begin() + 1, v.end());
      std::rotate(m.begin(), m.begin() + 1, m.end());
    }
  if (splits == 0) {
    out.push_back(v);
  } else if (splits == 1) {
    out.insert(out.end(), {{v[0], m[0], v[2]}, {m[0], v[1], v[2]}});
  } else if (splits == 2) {
    const auto apart = [&](std::uint32_t a, std::uint32_t b) {
      return distance(to_vec(mesh.vertices[a]), to_vec(mesh.vertices[b]));
    };
    out.push_back({m[0], v[1], m[1]});
    if (apart(v[0], m[1]) < apart(m[0], v[2]))
      out.insert(out.end(), {{v[0], m[0], m[1]}, {v[0], m[1], v[2]}});
    else
      out.insert(out.end(), {{v[0], m[0], v[2]}, {m[0], m[1], v[2]}});
  } else {
    out.insert(out.end(), {{v[0], m[0], m[2]}, {m[0], v[1], m[1]}, {m[2], m[1], v[2]}, m});
  }
}

void apply_splits(TriMesh& mesh, const Split& split) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::int32_t> owners;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    emit(mesh, f, split, triangles);
    if (!mesh.owners.empty()) owners.resize(triangles.size(), mesh.owners[f]);
  }
  mesh.triangles = std::move(triangles);
  mesh.owners = std::move(owners);
}

// Cell of each vertex on a grid with `cells` along the longest side.
std::vector<std::uint64_t> cells_of(const TriMesh& mesh, double cells) {
  Box3 box;
  for (const auto& v : mesh.vertices) extend(box, to_vec(v));
  const Vec3 size = box.hi - box.lo;
  // A mesh whose points all lie in one place has one cell.
  const double scale = cells / std::max({size.x, size.y, size.z, kRounding});
  std::vector<std::uint64_t> out(mesh.vertices.size());
  for (std::size_t v = 0; v < out.size(); ++v) {
    const Vec3 p = scale * (to_vec(mesh.vertices[v]) - box.lo);
    out[v] = std::uint64_t(p.x) << 42 | std::uint64_t(p.y) << 21 | std::uint64_t(p.z);
  }
  return out;
}

DisplayMesh cluster(const DisplayMesh& fine, double cells) {
  const std::vector<std::uint64_t> cell = cells_of(fine.mesh, cells);
  std::vector<std::uint32_t> order(cell.size()), target(cell.size());
  for (std::uint32_t v = 0; v < order.size(); ++v) order[v] = v;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return cell[a] < cell[b]; });
  DisplayMesh out;
  out.mesh.origin = fine.mesh.origin;
  for (std::size_t i = 0, end = 0; i < order.size(); i = end) {
    Vec3 mean;
    float worst = 0;
    for (end = i; end < order.size() && cell[order[end]] == cell[order[i]]; ++end) {
      mean += to_vec(fine.mesh.vertices[order[end]]);
      const float d = fine.deviation[order[end]];
      if (std::abs(d) > std::abs(worst)) worst = d;
      target[order[end]] = std::uint32_t(out.mesh.vertices.size());
    }
    mean = (1.0 / double(end - i)) * mean;
    const auto nearest = *std::min_element(order.begin() + long(i), order.begin() + long(end),
                                           [&](std::uint32_t a, std::uint32_t b) {
                                             return distance(to_vec(fine.mesh.vertices[a]), mean) <
                                                    distance(to_vec(fine.mesh.vertices[b]), mean);
                                           });
    out.mesh.vertices.push_back(fine.mesh.vertices[nearest]);
    out.deviation.push_back(worst);
  }
  for (std::size_t f = 0; f < fine.mesh.triangles.size(); ++f) {
    const auto& t = fine.mesh.triangles[f];
    const std::array<std::uint32_t, 3> k{target[t[0]], target[t[1]], target[t[2]]};
    if (k[0] == k[1] || k[1] == k[2] || k[2] == k[0]) continue;
    out.mesh.triangles.push_back(k);
    if (!fine.mesh.owners.empty()) out.mesh.owners.push_back(fine.mesh.owners[f]);
  }
  return out;
}

}  // namespace

DisplayMesh refine_for_display(const TriMesh& part, const NominalSurface& nominal, double band,
                               std::size_t most, int threads) {
  DisplayMesh out{part, {}};
  std::vector<Vec3> points;
  for (const auto& v : part.vertices) points.push_back(to_vec(v));
  out.deviation = deviations(points, nominal, threads);
  const double size = size_of(part);
  for (int pass = 0; pass < kMostPasses && out.mesh.triangles.size() < most; ++pass) {
    const std::size_t room = (most - out.mesh.triangles.size()) / 2;  // a split adds two
    const Split split = choose_splits(out, nominal, band, size, room, threads);
    if (split.count == 0) break;
    apply_splits(out.mesh, split);
  }
  return out;
}

DisplayMesh cluster_for_display(const DisplayMesh& fine, std::size_t most) {
  if (fine.mesh.triangles.size() <= most) return fine;
  DisplayMesh out;
  // A surface of n triangles has about sqrt(n) / 2 cells along a side; too fine a guess is halved.
  for (double cells = std::sqrt(double(most)); cells > 4; cells *= 0.75) {
    out = cluster(fine, cells);
    if (out.mesh.triangles.size() <= most) break;
  }
  return out;
}

std::vector<std::array<std::uint32_t, 2>> crease_lines(const TriMesh& mesh, double angle) {
  const std::vector<std::uint32_t> opposite = find_opposites(mesh);
  const double least = sincos(angle).cos;
  std::vector<std::array<std::uint32_t, 2>> out;
  for (std::uint32_t h = 0; h < opposite.size(); ++h) {
    if (is_half_edge(opposite[h])) {
      if (opposite[h] < h) continue;
      const Vec3 a = normalized(area_normal(mesh, h / 3)),
                 b = normalized(area_normal(mesh, opposite[h] / 3));
      if (dot(a, b) >= least) continue;
    } else if (opposite[h] != kBoundaryEdge) {
      continue;
    }
    out.push_back({origin_of(mesh, h), target_of(mesh, h)});
  }
  return out;
}

std::array<std::uint8_t, 3> deviation_color(double deviation, const Acceptance& band,
                                            DeviationScheme scheme) {
  using Color = std::array<double, 3>;
  struct Scheme {
    Color good, light_excess, excess, light_gouge, gouge;
  };
  static constexpr Scheme kStandard{
      {88, 166, 92}, {132, 190, 232}, {20, 76, 168}, {240, 150, 110}, {178, 24, 32}};
  // Blue and orange differ for every kind of colour blindness, and both from a light grey.
  static constexpr Scheme kSafe{
      {204, 204, 197}, {120, 180, 226}, {0, 84, 158}, {244, 176, 100}, {190, 78, 0}};
  const Scheme& s = scheme == DeviationScheme::safe ? kSafe : kStandard;
  const double width = band.hi - band.lo;
  const bool good = deviation >= band.lo && deviation <= band.hi, excess = deviation > 0;
  const double beyond = excess ? deviation - band.hi : band.lo - deviation;
  const double t = std::clamp(beyond / width, 0.0, 1.0);
  std::array<std::uint8_t, 3> out;
  for (std::size_t k = 0; k < 3; ++k) {
    const double light = excess ? s.light_excess[k] : s.light_gouge[k];
    const double deep = excess ? s.excess[k] : s.gouge[k];
    out[k] = std::uint8_t(good ? s.good[k] : light + t * (deep - light));
  }
  return out;
}

std::vector<ColorLabel> deviation_legend(const Acceptance& band, DeviationScheme scheme) {
  const double width = band.hi - band.lo, edge = width * 1e-6;
  const auto at = [&](double d, std::string text) {
    return ColorLabel{deviation_color(d, band, scheme), std::move(text)};
  };
  return {at(band.hi + width, fmt::format("{:+.4g} mm and more: material left", band.hi + width)),
          at(band.hi + width / 2, fmt::format("{:+.4g} mm", band.hi + width / 2)),
          at(band.hi + edge, fmt::format("above {:+.4g} mm", band.hi)),
          at(0, fmt::format("{:+.4g} .. {:+.4g} mm: in tolerance", band.lo, band.hi)),
          at(band.lo - edge, fmt::format("below {:+.4g} mm", band.lo)),
          at(band.lo - width / 2, fmt::format("{:+.4g} mm", band.lo - width / 2)),
          at(band.lo - width, fmt::format("{:+.4g} mm and less: gouge", band.lo - width))};
}

TriMesh deviation_mesh(const TriMesh& part, const TriMesh& nominal, const Comparison& comparison,
                       DeviationScheme scheme, int threads) {
  const NominalSurface surface(nominal, threads);
  const double fine = (comparison.band.hi - comparison.band.lo) / 10;
  DisplayMesh display =
      refine_for_display(transformed(part, comparison.transform), surface, fine,
                         std::max<std::size_t>(500000, part.triangles.size() * 2), threads);
  display.mesh.colors.clear();
  for (const float d : display.deviation)
    display.mesh.colors.push_back(deviation_color(double(d), comparison.band, scheme));
  display.mesh.legend = deviation_legend(comparison.band, scheme);
  return std::move(display.mesh);
}

}  // namespace mrsim
