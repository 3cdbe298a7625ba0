/// mrsim: how far a part is from its drawing, and which line of the program is to blame.
///
/// Signs: positive = material left (excess), negative = cut too deep (gouge). Distances are exact
/// to rounding; what is approximate is the choice of points, and HausdorffBound says how much that
/// matters. Same inputs, same numbers, for any number of threads. The mathematics: docs/compare.md.
///
/// Example:
///     mrsim::CompareOptions options;
///     options.accept = mrsim::Acceptance{-0.02, 0.02};
///     const mrsim::Comparison c = mrsim::compare(part, nominal, options);
///     if (!c.accepted.value()) puts(mrsim::comparison_json(c).c_str());
#pragma once

#include <mrsim/options.h>
#include <mrsim/types.h>

#include <optional>
#include <string>
#include <vector>

namespace mrsim {

/// The tolerance of the part in mm. Requires: finite, lo <= 0 <= hi, lo < hi.
struct Acceptance {
  double lo = -0.02, hi = 0.02;
};
/// The narrower side of a tolerance that has two, else its width, mm.
MRSIM_API double narrow_side(const Acceptance& accept);
/// "0.05" or "-0.02,0.05". Throws Error of kind usage, "accept-invalid".
MRSIM_API Acceptance parse_acceptance(const std::string& text);

enum class Alignment : std::uint8_t { none, bbox, icp };

struct CompareOptions {
  /// Default: none, then nothing is judged, and regions and colours use +-0.02 mm.
  std::optional<Acceptance> accept;
  /// How the part is moved onto the nominal first. Default: not at all.
  Alignment align = Alignment::none;
  /// Samples per mm^2 of surface. Requires: >= 0; 0 = as many as give `samples`.
  double density = 0;
  /// Samples on each of the two surfaces where no density is given.
  std::size_t samples = 200000;
  /// Width of the bounds that the Hausdorff distances are driven to, mm; 0 = the larger of 1e-4 and
  /// a hundredth of the distance. What was reached is in the result.
  double hausdorff_error = 0;
  /// Regions to describe; all are counted. Requires: >= 1.
  std::size_t max_regions = 50;
  /// Look for a shifted part, tools of a wrong size and the like. Default: yes.
  bool hints = true;
  int threads = 0;
  Progress progress;
};

/// p -> R p + shift; rows of R.
struct RigidTransform {
  std::array<Vec3, 3> rotation{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  Vec3 shift;
  friend bool operator==(const RigidTransform&, const RigidTransform&) = default;
};

/// Figures of one direction, mm. Extremes are over samples, vertices and the points that the search
/// for the Hausdorff distance tried; all else is over samples, which stand for equal areas.
struct DeviationFigures {
  std::size_t samples = 0, vertices = 0;
  double density = 0;  ///< samples per mm^2
  double area = 0;     ///< mm^2 of the surface that was sampled
  double min = 0, max = 0, mean = 0, median = 0, mean_absolute = 0, rms = 0, deviation = 0;
  double p1 = 0, p5 = 0, p50 = 0, p95 = 0, p99 = 0;
  double in_tolerance = 1;                 ///< share of the area
  double excess_area = 0, gouge_area = 0;  ///< mm^2 out of tolerance
  Vec3 min_place, max_place;
};

/// The true distance lies in [lower, upper].
struct HausdorffBound {
  double lower = 0, upper = 0;
  Vec3 place;  ///< where `lower` was found
};

/// A line of the program that cut (or, for `beside`, borders) a region.
struct BlamedLine {
  std::string file;
  int line = 0;         ///< 1-based
  std::string text;     ///< UTF-8, empty when the program is not at hand
  std::string tool;     ///< id
  bool beside = false;  ///< did not cut the region itself: the nearest surface that is cut
  double share = 0;     ///< of the region's deviation (area x distance); 0 for `beside`
  double worst = 0;     ///< mm, signed; `beside`: 0
  double distance = 0;  ///< mm from the worst place to its surface; 0 when it cut there
};

struct DeviationRegion {
  bool gouge = false;
  Vec3 place;        ///< of the worst value, on the part or on the nominal
  Vec3 normal;       ///< outward, of the surface it lies on
  double worst = 0;  ///< mm, signed
  double mean = 0;   ///< mm, signed
  Box3 extent;
  double area = 0;                ///< mm^2 of the part's surface
  double nominal_area = 0;        ///< mm^2 of the nominal's
  double volume = 0;              ///< mm^3 between the surfaces, first order
  double stock_share = 0;         ///< of the deviation that lies on uncut stock
  std::vector<BlamedLine> lines;  ///< the guiltiest first, at most 8
};

/// Deviation of what one line cut.
struct LineFigures {
  std::int32_t file = -1, line = 0, tool = -1;  ///< as in OwnerTable; all -1, 0, -1 = stock
  double area = 0, mean = 0, min = 0, max = 0, out_area = 0;
};

struct Histogram {
  double lo = 0, hi = 0;  ///< mm; the outer bins hold what lies beyond
  std::vector<double> share;
};

/// A suspicion in one sentence, such as a shifted part.
struct ComparisonHint {
  std::string code, text;
};

struct Comparison {
  std::string part_name, nominal_name;
  Acceptance band;  ///< what `in_tolerance`, regions and colours use
  std::optional<bool> accepted;
  RigidTransform transform;  ///< what was applied to the part
  Alignment align = Alignment::none;
  DeviationFigures part;     ///< the part's surface to the nominal
  DeviationFigures nominal;  ///< the nominal's surface to the part
  HausdorffBound part_to_nominal, nominal_to_part, hausdorff;
  double part_volume = 0, nominal_volume = 0;
  double excess_volume = 0, gouge_volume = 0;  ///< part outside nominal, nominal outside part
  double volume_error = 0;                     ///< standard error of the two
  std::size_t region_count = 0;
  std::vector<DeviationRegion> regions;  ///< worst first
  std::vector<LineFigures> lines;        ///< in the order of the program, stock first
  Histogram histogram;
  std::vector<ComparisonHint> hints;
  std::vector<float> vertex_deviation;         ///< #V of the part, mm
  OwnerTable origin;                           ///< the part's
  std::vector<std::vector<std::string>> text;  ///< lines of origin.files, empty = not at hand
  std::size_t memory = 0;                      ///< the most that the process has held, bytes
  double seconds = 0;
};

/// Deviation of `part` from `nominal`, both in mm. `texts[i]` holds the lines of
/// part.origin.files[i]; may be shorter or empty. Throws Error "compare-empty",
/// "compare-not-finite", "compare-too-far", "compare-nominal-open", "compare-part-open",
/// "compare-apart", "compare-units", "memory", "cancelled", and of kind usage "accept-invalid",
/// "density-invalid", "density-too-large", "hausdorff-invalid". Cost: a search in a tree of
/// triangles for each sample and vertex, O((samples + #V) log #F) for usual parts.
MRSIM_API Comparison compare(const TriMesh& part, const TriMesh& nominal,
                             const CompareOptions& options = {},
                             const std::vector<std::vector<std::string>>& texts = {});

/// Throws what compare() would throw for this nominal, before a long run; `name` is what messages
/// call it. Cost: sorting its edges.
MRSIM_API void require_nominal(const TriMesh& nominal, const std::string& name, int threads = 0);

/// One JSON object, schema in docs/compare.md ("schema": 1). Without times and memory, so that
/// equal inputs give equal bytes.
MRSIM_API std::string comparison_json(const Comparison& comparison);
/// JUnit XML: a test case for the verdict and one for each region.
MRSIM_API std::string comparison_junit(const Comparison& comparison);

/// A comparison that has ended with an Error.
struct FailedComparison {
  std::string part_name, nominal_name;
  std::string error_code, error_text;
};
/// comparison_json() of one of these: its verdict is "failed", and what is not known is null.
MRSIM_API std::string comparison_json(const FailedComparison& failed);
MRSIM_API std::string comparison_junit(const FailedComparison& failed);

/// The lines that `mrsim compare` prints, mm.
MRSIM_API std::string comparison_text(const Comparison& comparison);

enum class DeviationScheme : std::uint8_t { standard, safe };
/// `part` (moved by the comparison's transform) with a colour at every vertex: blue = material
/// left, green (safe: near white) = in tolerance, red (safe: orange) = gouge. Long triangles are
/// split so that the colours are right inside of them; the surface stays the same. Requires:
/// `comparison` is of these two meshes. Cost: a search in a tree of triangles for each vertex.
MRSIM_API TriMesh deviation_mesh(const TriMesh& part, const TriMesh& nominal,
                                 const Comparison& comparison,
                                 DeviationScheme scheme = DeviationScheme::standard,
                                 int threads = 0);

}  // namespace mrsim
