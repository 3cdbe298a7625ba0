#include "compare/blame/hints.h"

#include "compare/distance/align.h"
#include "core/numbers/units.h"
#include "core/numbers/vec.h"
#include "mesh/solid/half_edges.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr double kMmPerMetre = 1000;
constexpr double kFactorError = 0.05;  // of a factor between two units, as sizes show it
constexpr double kApart = 3;           // sizes: parts farther apart have different origins

constexpr double kFewSamples = 20;    // out of tolerance: fewer show nothing
constexpr double kToolShare = 0.15;   // of what a tool cut, out of tolerance, that may be its size
constexpr std::size_t kFewLines = 2;  // on which it must show
constexpr double kEvenSpread = 0.25;  // of the mean: a wrong size is off by the same everywhere
constexpr double kLevel = 0.9;        // cosine between a normal and Z, from which a face is a floor
constexpr double kShiftShare = 0.02;  // of all that was cut, out of tolerance, that may be a shift
constexpr std::size_t kFitted = 10000;  // points that a move is fitted to, about
constexpr double kFits = 0.25;          // of the RMS before: what a move must leave at most
constexpr double kShownTurn = 0.01;     // degrees

std::string factor_text(double factor) { return factor == kMmPerMetre ? "1000" : "25.4"; }

// What the files' units may be, when `larger` is `factor` times the size of the other.
std::string unit_guess(double factor, const std::string& larger, const std::string& smaller) {
  if (factor == kMmPerInch)
    return fmt::format("is the {} in inches, or was the {} converted twice?", smaller, larger);
  return fmt::format("is the {} in metres, or the {} in micrometres?", smaller, larger);
}

// Samples of what one tool cut: all of them, those out of tolerance, and of the latter those on
// floors; and the sums of the deviations out of tolerance and of their squares.
struct ToolErrors {
  double all = 0, out = 0, floors = 0, sum = 0, square = 0;
  std::set<LineKey> lines;
};

std::map<std::int32_t, ToolErrors> errors_by_tool(const TriMesh& part, const DeviationField& field,
                                                  const FaceLines& lines, const Acceptance& band) {
  std::map<std::int32_t, ToolErrors> out;
  for (std::size_t i = 0; i < field.samples.spread; ++i) {
    const std::uint32_t face = field.samples.faces[i];
    const LineKey& key = lines.of(face);
    if (key.is_stock()) continue;
    ToolErrors& tool = out[key.tool];
    tool.all += 1;
    const double d = field.hits[i].distance;
    if (d >= band.lo && d <= band.hi) continue;
    tool.out += 1;
    tool.sum += d;
    tool.square += d * d;
    tool.floors += std::abs(normalized(area_normal(part, face)).z) > kLevel;
    tool.lines.insert(key);
  }
  return out;
}

void hint_tools(const TriMesh& part, const DeviationField& field, const FaceLines& lines,
                const Acceptance& band, std::vector<ComparisonHint>& out) {
  for (const auto& [index, tool] : errors_by_tool(part, field, lines, band)) {
    if (tool.out < kToolShare * tool.all || tool.out < kFewSamples || tool.lines.size() < kFewLines)
      continue;
    const double mean = tool.sum / tool.out;
    const double spread = std::sqrt(std::max(0.0, tool.square / tool.out - mean * mean));
    if (spread > kEvenSpread * std::abs(mean)) continue;
    const BlamedLine name = name_line({0, 0, index}, part.origin, {});
    const bool floors = tool.floors > 0.5 * tool.out;
    out.push_back(
        {"tool-size",
         fmt::format("{} lines of {} are all off by about {:+.3f} mm {}: check its {}",
                     tool.lines.size(), name.tool.empty() ? "one tool" : "tool " + name.tool, mean,
                     floors ? "in depth" : "sideways",
                     floors ? "length and the Z of the work offset"
                            : "diameter and radius register, of a turning tool its X offset")});
  }
}

void hint_shift(const DeviationField& field, const NominalSurface& nominal, const FaceLines& lines,
                const Acceptance& band, int threads, std::vector<ComparisonHint>& out) {
  std::vector<std::size_t> cut;
  std::size_t beyond = 0;
  for (std::size_t i = 0; i < field.samples.spread; ++i) {
    if (lines.any_cut() && lines.of(field.samples.faces[i]).is_stock()) continue;
    cut.push_back(i);
    const double d = field.hits[i].distance;
    beyond += d < band.lo || d > band.hi;
  }
  if (double(beyond) < kFewSamples || double(beyond) < kShiftShare * double(cut.size())) return;
  std::vector<Vec3> points;
  const std::size_t step = cut.size() / kFitted + 1;
  for (std::size_t i = 0; i < cut.size(); i += step) points.push_back(field.samples.points[cut[i]]);
  const IcpResult fit = icp(points, nominal, {}, threads);
  const double size = distance(nominal.tree().bounds().lo, nominal.tree().bounds().hi);
  if (fit.rms_after > kFits * fit.rms_before || length(fit.transform.shift) > size) return;
  const Vec3 centre = 0.5 * (nominal.tree().bounds().lo + nominal.tree().bounds().hi);
  const Vec3 move = apply(fit.transform, centre) - centre;
  const double turn = degrees(angle_of(fit.transform));
  out.push_back(
      {"part-shifted",
       fmt::format("{} would fit after a move by ({:+.3f}, {:+.3f}, {:+.3f}) mm{}: RMS {:.4f} -> "
                   "{:.4f} mm. Check the work offset{}",
                   lines.any_cut() ? "what was cut" : "the part", move.x, move.y, move.z,
                   turn > kShownTurn ? fmt::format(" and a turn by {:.3f} degrees", turn) : "",
                   fit.rms_before, fit.rms_after,
                   lines.any_cut() ? "" : ", or compare with --align icp")});
}

}  // namespace

void require_same_place(const Box3& part, const Box3& nominal, Alignment align) {
  const double p = distance(part.lo, part.hi), n = distance(nominal.lo, nominal.hi);
  for (const double factor : {kMmPerInch, kMmPerMetre})
    for (const bool part_larger : {true, false}) {
      const double ratio = part_larger ? p / n : n / p;
      if (std::abs(ratio / factor - 1) > kFactorError) continue;
      const std::string larger = part_larger ? "part" : "nominal";
      const std::string smaller = part_larger ? "nominal" : "part";
      throw Error(
          "compare-units",
          fmt::format("the {} is {} times as large as the {} ({:.4g} and {:.4g} mm across): "
                      "{}",
                      larger, factor_text(factor), smaller, part_larger ? p : n,
                      part_larger ? n : p, unit_guess(factor, larger, smaller)));
    }
  const Vec3 gap = max(max(part.lo - nominal.hi, nominal.lo - part.hi), {0, 0, 0});
  if (align == Alignment::none && length(gap) > kApart * std::max(p, n))
    throw Error("compare-apart",
                fmt::format("part and nominal are {:.6g} mm apart, with sizes of {:.4g} and {:.4g} "
                            "mm: they have different origins; --align bbox or icp moves the part",
                            length(gap), p, n));
}

std::vector<ComparisonHint> find_hints(const TriMesh& part, const DeviationField& field,
                                       const NominalSurface& nominal, const FaceLines& lines,
                                       const Acceptance& band, int threads) {
  std::vector<ComparisonHint> out;
  hint_shift(field, nominal, lines, band, threads, out);
  hint_tools(part, field, lines, band, out);
  return out;
}

}  // namespace mrsim
