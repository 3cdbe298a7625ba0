#include "compare/blame/blame.h"
#include "compare/blame/hints.h"
#include "compare/blame/regions.h"
#include "compare/distance/align.h"
#include "compare/distance/hausdorff.h"
#include "compare/distance/sampling.h"
#include "compare/distance/volumes.h"
#include "core/numbers/vec.h"
#include "core/process/memory_limit.h"
#include "core/text/text_io.h"
#include "mesh/solid/check.h"
#include "mesh/solid/half_edges.h"
#include <mrsim/compare.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr std::size_t kIcpPoints = 20000;
constexpr std::size_t kIcpThinned = 10;  // of those, where many starts are tried
constexpr double kFarBetter = 0.5;       // of the RMS of the usual start
// Bytes, as measured (docs/limits.md).
constexpr double kSampleBytes = 80, kTriangleBytes = 400;

void validate(const CompareOptions& o) {
  const auto usage = [](const std::string& code, const std::string& text) {
    throw Error(code, text, Error::Kind::usage);
  };
  if (o.accept) {
    const Acceptance& a = *o.accept;
    if (!std::isfinite(a.lo) || !std::isfinite(a.hi) || a.lo > 0 || a.hi < 0 || !(a.lo < a.hi))
      usage("accept-invalid",
            "a tolerance is T above 0 or LO,HI with LO <= 0 <= HI, such as 0.02 or -0.02,0.05");
  }
  if (!(o.density >= 0) || !std::isfinite(o.density))
    usage("density-invalid", "the density of samples is a number of points per mm2, 0 or more");
  if (!(o.hausdorff_error >= 0)) usage("hausdorff-invalid", "the error bound is 0 mm or more");
}

void step(const CompareOptions& options, double share) {
  if (options.progress && !options.progress("compare", share))
    throw Error("cancelled", "the comparison was stopped");
}

// The start, or a turn by quarters where that is far better: ICP does not find it by itself.
RigidTransform turned_start(const std::vector<Vec3>& points, const NominalSurface& surface,
                            const RigidTransform& start, const std::vector<RigidTransform>& turns,
                            int threads) {
  std::vector<Vec3> some;
  for (std::size_t i = 0; i < points.size(); i += kIcpThinned) some.push_back(points[i]);
  RigidTransform best = start;
  double least = kFarBetter * rms_at(some, surface, start, threads);
  for (const RigidTransform& turn : turns) {
    const double rms = rms_at(some, surface, turn, threads);
    if (rms < least) best = turn, least = rms;
  }
  return best;
}

RigidTransform find_alignment(const TriMesh& part, const TriMesh& nominal,
                              const NominalSurface& surface, const CompareOptions& options) {
  if (options.align == Alignment::none) return {};
  const Box3 from = mesh_bounds(part), to = mesh_bounds(nominal);
  const RigidTransform boxes = align_boxes(from, to);
  if (options.align == Alignment::bbox) return boxes;
  SurfaceSamples samples = sample_surface(part, kIcpPoints);
  samples.points.resize(samples.spread);
  // Near enough already: ICP is better off from there than from the boxes, which an excess moves.
  const bool near = length(boxes.shift) < 0.05 * distance(to.lo, to.hi);
  const RigidTransform start =
      turned_start(samples.points, surface, near ? RigidTransform{} : boxes,
                   quarter_turns(from, to), options.threads);
  return icp(samples.points, surface, start, options.threads).transform;
}

// The samples' largest distance, where the search for the true one starts.
HausdorffBound hausdorff_of(const TriMesh& from, const DeviationField& field,
                            const TriMesh& to_mesh, const NominalSurface& to, double error,
                            const CompareOptions& options) {
  std::size_t worst = 0;
  for (std::size_t i = 0; i < field.hits.size(); ++i)
    if (std::abs(field.hits[i].distance) > std::abs(field.hits[worst].distance)) worst = i;
  const FlatPatches patches(to_mesh, to, options.threads);
  return directed_hausdorff(from, to, patches, std::abs(field.hits[worst].distance),
                            field.samples.points[worst], error, kHausdorffPieces, options.threads);
}

void fill_hausdorff(const TriMesh& part, const TriMesh& nominal, const DeviationField& of_part,
                    const DeviationField& of_nominal, const NominalSurface& part_surface,
                    const NominalSurface& nominal_surface, const CompareOptions& options,
                    Comparison& out) {
  const double largest = std::max({out.part.max, -out.part.min, out.nominal.max, -out.nominal.min});
  const double error =
      options.hausdorff_error > 0 ? options.hausdorff_error : kUsualError.of(largest);
  out.part_to_nominal = hausdorff_of(part, of_part, nominal, nominal_surface, error, options);
  out.nominal_to_part = hausdorff_of(nominal, of_nominal, part, part_surface, error, options);
  const bool first = out.part_to_nominal.lower >= out.nominal_to_part.lower;
  out.hausdorff = first ? out.part_to_nominal : out.nominal_to_part;
  out.hausdorff.upper = std::max(out.part_to_nominal.upper, out.nominal_to_part.upper);
}

void fill_vertices(const TriMesh& part, const DeviationField& field, Comparison& out) {
  out.vertex_deviation.assign(part.vertices.size(), 0);
  std::vector<bool> seen(part.vertices.size(), false);
  std::size_t next = field.samples.spread;  // vertices follow in the order of first use
  for (const auto& t : part.triangles)
    for (const std::uint32_t v : t)
      if (!seen[v]) {
        seen[v] = true;
        out.vertex_deviation[v] = float(field.hits[next++].distance);
      }
}

// The search for the Hausdorff distance may find a worse point than the samples did.
void include(const Vec3& place, const NominalSurface& surface, double sign,
             DeviationFigures& figures) {
  const double d = sign * surface.at(place).distance;
  if (d < figures.min) {
    figures.min = d;
    figures.min_place = place;
  }
  if (d > figures.max) {
    figures.max = d;
    figures.max_place = place;
  }
}

bool within(const DeviationFigures& f, const Acceptance& band) {
  return f.min >= band.lo && f.max <= band.hi;
}

void fill_deviations(const TriMesh& part, const TriMesh& nominal,
                     const NominalSurface& nominal_surface, const CompareOptions& options,
                     const std::vector<std::vector<std::string>>& texts, Comparison& out) {
  const std::size_t points =
      sample_count(options, surface_area(part)) + sample_count(options, surface_area(nominal));
  require_memory(kSampleBytes * double(points) +
                     kTriangleBytes * double(part.triangles.size() + nominal.triangles.size()),
                 fmt::format("a comparison at {} points", points),
                 "a smaller --density or a coarser mesh takes less");
  const NominalSurface part_surface(part, options.threads);
  SurfaceSamples samples = sample_surface(part, sample_count(options, surface_area(part)));
  const DeviationField of_part = measure(std::move(samples), nominal_surface, 1, options.threads);
  step(options, 0.3);
  samples = sample_surface(nominal, sample_count(options, surface_area(nominal)));
  const DeviationField of_nominal = measure(std::move(samples), part_surface, -1, options.threads);
  step(options, 0.5);
  out.part = figures_of(of_part, out.band);
  out.nominal = figures_of(of_nominal, out.band);
  out.histogram = histogram_of(of_part, out.band);
  fill_vertices(part, of_part, out);
  fill_hausdorff(part, nominal, of_part, of_nominal, part_surface, nominal_surface, options, out);
  include(out.part_to_nominal.place, nominal_surface, 1, out.part);
  include(out.nominal_to_part.place, part_surface, -1, out.nominal);
  if (options.accept) out.accepted = within(out.part, out.band) && within(out.nominal, out.band);
  step(options, 0.8);
  const FaceLines lines(part);
  out.lines = line_figures(of_part, lines, out.band);
  out.regions = find_regions({part, nominal, of_part, of_nominal, lines, texts}, out.band,
                             std::max<std::size_t>(1, options.max_regions), out.region_count);
  if (options.hints)
    out.hints = find_hints(part, of_part, nominal_surface, lines, out.band, options.threads);
}

}  // namespace

double narrow_side(const Acceptance& accept) {
  return accept.lo < 0 && accept.hi > 0 ? std::min(-accept.lo, accept.hi) : accept.hi - accept.lo;
}

Acceptance parse_acceptance(const std::string& text) {
  const std::size_t comma = text.find(',');
  const auto lo = parse_number(text.substr(0, comma), true);
  const auto hi = comma == std::string::npos ? lo : parse_number(text.substr(comma + 1), true);
  if (!lo || !hi)
    throw Error("accept-invalid", "'" + text + "' is no tolerance: T or LO,HI in mm",
                Error::Kind::usage);
  CompareOptions options;
  options.accept = comma == std::string::npos ? Acceptance{-*lo, *lo} : Acceptance{*lo, *hi};
  validate(options);
  return *options.accept;
}

void require_nominal(const TriMesh& nominal, const std::string& name, int threads) {
  require_comparable(nominal, "nominal", name, threads);
}

Comparison compare(const TriMesh& part, const TriMesh& nominal, const CompareOptions& options,
                   const std::vector<std::vector<std::string>>& texts) {
  const auto begin = std::chrono::steady_clock::now();
  validate(options);
  Comparison out;
  out.band = options.accept.value_or(Acceptance{});
  out.align = options.align;
  out.origin = part.origin;
  out.text = texts;
  out.part_volume = require_comparable(part, "part", "", options.threads);
  out.nominal_volume = require_comparable(nominal, "nominal", "", options.threads);
  require_same_place(mesh_bounds(part), mesh_bounds(nominal), options.align);
  step(options, 0);
  const NominalSurface surface(nominal, options.threads);
  out.transform = find_alignment(part, nominal, surface, options);
  const TriMesh moved = transformed(part, out.transform);
  fill_deviations(moved, nominal, surface, options, texts, out);
  const VolumeDifference volumes =
      volume_difference(moved, nominal, std::size_t(1) << 18, options.threads);
  out.excess_volume = volumes.only_first;
  out.gouge_volume = volumes.only_second;
  out.volume_error = volumes.error;
  out.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  out.memory = peak_memory();
  step(options, 1);
  return out;
}

}  // namespace mrsim
