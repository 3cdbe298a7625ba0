#include "compare/distance/sampling.h"

#include "core/numbers/vec.h"
#include "core/process/error.h"
#include "core/process/parallel.h"
#include "mesh/solid/check.h"
#include "mesh/solid/half_edges.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr std::size_t kMostSamples = 5'000'000;

Vec3 point_in_face(const TriMesh& mesh, std::size_t face, std::size_t index) {
  auto [u, v] = spread_point(index);
  if (u + v > 1) {
    u = 1 - u;
    v = 1 - v;
  }
  const Vec3 a = corner(mesh, face, 0);
  return a + u * (corner(mesh, face, 1) - a) + v * (corner(mesh, face, 2) - a);
}

void add_vertices(const TriMesh& mesh, SurfaceSamples& out) {
  std::vector<bool> seen(mesh.vertices.size(), false);
  for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f)
    for (const std::uint32_t v : mesh.triangles[f]) {
      if (seen[v]) continue;
      seen[v] = true;
      out.points.push_back(to_vec(mesh.vertices[v]));
      out.faces.push_back(f);
    }
}

double percentile(const std::vector<double>& sorted, double share) {
  const double at = share * double(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const double above = sorted[std::min(below + 1, sorted.size() - 1)];
  return sorted[below] + (at - double(below)) * (above - sorted[below]);
}

void find_extremes(const DeviationField& field, DeviationFigures& out) {
  std::size_t least = 0, most = 0;
  for (std::size_t i = 1; i < field.hits.size(); ++i) {
    if (field.hits[i].distance < field.hits[least].distance) least = i;
    if (field.hits[i].distance > field.hits[most].distance) most = i;
  }
  out.min = field.hits[least].distance;
  out.max = field.hits[most].distance;
  out.min_place = field.samples.points[least];
  out.max_place = field.samples.points[most];
}

}  // namespace

Vec2 spread_point(std::size_t k) {
  constexpr double kRatio1 = 0.7548776662466927,
                   kRatio2 = 0.5698402909980532;  // g^3 = g + 1: 1/g, 1/g^2
  const double u = 0.5 + kRatio1 * double(k), v = 0.5 + kRatio2 * double(k);
  return {u - std::floor(u), v - std::floor(v)};
}

std::size_t sample_count(const CompareOptions& options, double area) {
  const double wanted = options.density > 0 ? options.density * area : double(options.samples);
  if (options.density > 0 && wanted > double(kMostSamples))
    throw Error(
        "density-too-large",
        fmt::format("{:g} samples per mm2 are {:.3g} on a surface of {:.6g} mm2; at most "
                    "{} are taken, {:.3g} per mm2",
                    options.density, wanted, area, kMostSamples, double(kMostSamples) / area),
        Error::Kind::usage);
  return static_cast<std::size_t>(std::clamp(std::ceil(wanted), 100.0, double(kMostSamples)));
}

SurfaceSamples sample_surface(const TriMesh& mesh, std::size_t count) {
  SurfaceSamples out;
  out.area = surface_area(mesh);
  out.weight = out.area / double(count);
  out.points.reserve(count + mesh.vertices.size());
  out.faces.reserve(count + mesh.vertices.size());
  double summed = 0;
  for (std::uint32_t f = 0; f < mesh.triangles.size() && out.weight > 0; ++f) {
    summed += length(area_normal(mesh, f)) / 2;
    while (out.points.size() < count && (double(out.points.size()) + 0.5) * out.weight <= summed) {
      out.points.push_back(point_in_face(mesh, f, out.points.size()));
      out.faces.push_back(f);
    }
  }
  out.spread = out.points.size();
  add_vertices(mesh, out);
  return out;
}

DeviationField measure(SurfaceSamples samples, const NominalSurface& other, double sign,
                       int threads) {
  DeviationField field{std::move(samples), {}};
  field.hits.resize(field.samples.points.size());
  other.query(field.samples.points, field.hits, threads);
  for (SurfaceHit& hit : field.hits) hit.distance *= sign;
  return field;
}

DeviationFigures figures_of(const DeviationField& field, const Acceptance& band) {
  const SurfaceSamples& s = field.samples;
  DeviationFigures out;
  out.samples = s.spread;
  out.vertices = s.points.size() - s.spread;
  out.area = s.area;
  out.density = s.area > 0 ? double(s.spread) / s.area : 0;
  find_extremes(field, out);
  if (s.spread == 0) return out;
  std::vector<double> sorted(s.spread);
  std::size_t excess = 0, gouge = 0;
  double sum = 0, absolute = 0, square = 0;
  for (std::size_t i = 0; i < s.spread; ++i) {
    const double d = sorted[i] = field.hits[i].distance;
    sum += d;
    absolute += std::abs(d);
    square += d * d;
    excess += d > band.hi;
    gouge += d < band.lo;
  }
  const double n = double(s.spread);
  out.mean = sum / n;
  out.mean_absolute = absolute / n;
  out.rms = std::sqrt(square / n);
  for (const double d : sorted) out.deviation += (d - out.mean) * (d - out.mean);
  out.deviation = std::sqrt(out.deviation / n);
  std::sort(sorted.begin(), sorted.end());
  out.p1 = percentile(sorted, 0.01);
  out.p5 = percentile(sorted, 0.05);
  out.median = out.p50 = percentile(sorted, 0.5);
  out.p95 = percentile(sorted, 0.95);
  out.p99 = percentile(sorted, 0.99);
  out.excess_area = double(excess) * s.weight;
  out.gouge_area = double(gouge) * s.weight;
  out.in_tolerance = 1 - double(excess + gouge) / n;
  return out;
}

Histogram histogram_of(const DeviationField& field, const Acceptance& band) {
  constexpr int kBins = 60;  // the band takes the middle third
  const double width = (band.hi - band.lo) / 20;
  Histogram out{band.lo - 20 * width, band.hi + 20 * width, std::vector<double>(kBins, 0.0)};
  for (std::size_t i = 0; i < field.samples.spread; ++i) {
    const double at = (field.hits[i].distance - out.lo) / width;
    const int bin = at >= kBins ? kBins - 1 : at > 0 ? int(at) : 0;
    out.share[std::size_t(bin)] += 1.0 / double(field.samples.spread);
  }
  return out;
}

}  // namespace mrsim
