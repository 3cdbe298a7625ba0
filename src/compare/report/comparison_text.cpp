// What people and CI dashboards read of a comparison.
#include "compare/distance/align.h"
#include "core/numbers/units.h"
#include "core/text/printable.h"
#include "core/text/text_io.h"
#include <mrsim/compare.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr std::size_t kShownRegions = 10;

std::string place_text(const Vec3& p) {
  return fmt::format("({:.3f}, {:.3f}, {:.3f})", p.x, p.y, p.z);
}

std::string line_text(const BlamedLine& l) {
  std::string out = l.line > 0 ? fmt::format("{}:{}", l.file, l.line) : l.file;
  if (!l.text.empty()) out += "  " + l.text;
  if (!l.tool.empty()) out += fmt::format("  [tool {}]", l.tool);
  return printable(out);
}

std::string figures_text(const char* name, const DeviationFigures& f) {
  return fmt::format(
      "{:<17} min {:+.4f} at {}, max {:+.4f} at {} mm\n"
      "                  mean {:+.4f}, median {:+.4f}, |mean| {:.4f}, RMS {:.4f}, sigma {:.4f} mm\n"
      "                  1 % {:+.4f}, 5 % {:+.4f}, 95 % {:+.4f}, 99 % {:+.4f} mm; in tolerance "
      "{:.2f} %\n"
      "                  {} samples, {:.3g} a mm2, and {} vertices\n",
      name, f.min, place_text(f.min_place), f.max, place_text(f.max_place), f.mean, f.median,
      f.mean_absolute, f.rms, f.deviation, f.p1, f.p5, f.p95, f.p99, 100 * f.in_tolerance,
      f.samples, f.density, f.vertices);
}

std::string region_text(const DeviationRegion& r, std::size_t number) {
  std::string out = fmt::format("{:>3}. {} {:+.4f} mm at {}, {:.2f} mm2, {:.3f} mm3\n", number,
                                r.gouge ? "gouge " : "excess", r.worst, place_text(r.place),
                                r.area > 0 ? r.area : r.nominal_area, r.volume);
  if (r.stock_share > 0.5) out += "       on the stock's own surface: no line cut here\n";
  for (const BlamedLine& l : r.lines)
    out += fmt::format("       {} {}\n",
                       l.beside ? fmt::format("{:.2f} mm away:", l.distance)
                                : fmt::format("{:>3.0f} % cut by:", 100 * l.share),
                       line_text(l));
  return out;
}

std::string transform_text(const Comparison& c) {
  if (c.align == Alignment::none) return "";
  const auto& r = c.transform.rotation;
  return fmt::format(
      "Aligned ({}): turned by {:.4f} degrees, moved by {} mm\n"
      "                  [{:.9f} {:.9f} {:.9f}; {:.9f} {:.9f} {:.9f}; {:.9f} {:.9f} {:.9f}]\n",
      c.align == Alignment::icp ? "icp" : "bbox", degrees(angle_of(c.transform)),
      place_text(c.transform.shift), r[0].x, r[0].y, r[0].z, r[1].x, r[1].y, r[1].z, r[2].x, r[2].y,
      r[2].z);
}

// Whether the bound of the largest distance alone decides the verdict.
bool is_proven(const Comparison& c) {
  return !*c.accepted || c.hausdorff.upper <= std::min(-c.band.lo, c.band.hi);
}

// With as many digits as show on which side of the limit it is.
std::string found_text(double found, double limit) {
  int digits = 4;
  for (double scale = 1e4; digits < 9; scale *= 10, ++digits) {
    const double shown = std::round(found * scale) / scale;
    if ((shown < limit) == (found < limit) && (shown > limit) == (found > limit)) break;
  }
  return fmt::format("{:+.{}f}", found, digits);
}

std::string verdict_text(const Comparison& c) {
  if (!c.accepted)
    return fmt::format("No tolerance was given (--accept): regions are beyond {:+g} .. {:+g} mm\n",
                       c.band.lo, c.band.hi);
  std::string out = fmt::format("{}: tolerance {:+g} .. {:+g} mm, found {} .. {} mm",
                                *c.accepted ? "ACCEPTED" : "REJECTED", c.band.lo, c.band.hi,
                                found_text(std::min(c.part.min, c.nominal.min), c.band.lo),
                                found_text(std::max(c.part.max, c.nominal.max), c.band.hi));
  if (*c.accepted && !is_proven(c))
    out += fmt::format("; by samples: proven is that no distance exceeds {:.4f} mm",
                       c.hausdorff.upper);
  return out + "\n";
}

std::string xml(const std::string& text) { return xml_escaped(to_utf8(text)); }

}  // namespace

std::string comparison_text(const Comparison& c) {
  std::string out = transform_text(c);
  out += figures_text("Part to nominal:", c.part);
  out += figures_text("Nominal to part:", c.nominal);
  out += fmt::format(
      "Hausdorff:        {:.4f} .. {:.4f} mm (part to nominal {:.4f} .. {:.4f}, nominal to part "
      "{:.4f} .. {:.4f})\n",
      c.hausdorff.lower, c.hausdorff.upper, c.part_to_nominal.lower, c.part_to_nominal.upper,
      c.nominal_to_part.lower, c.nominal_to_part.upper);
  out += fmt::format(
      "Volume:           part {:.3f}, nominal {:.3f}, material left {:.3f}, gouged {:.3f} mm3\n",
      c.part_volume, c.nominal_volume, c.excess_volume, c.gouge_volume);
  if (c.region_count > 0) out += fmt::format("Regions out of tolerance: {}\n", c.region_count);
  for (std::size_t i = 0; i < std::min(c.regions.size(), kShownRegions); ++i)
    out += region_text(c.regions[i], i + 1);
  if (c.region_count > kShownRegions)
    out += fmt::format("     ... and {} more\n", c.region_count - kShownRegions);
  for (const ComparisonHint& h : c.hints) out += fmt::format("Hint: {} [{}]\n", h.text, h.code);
  out +=
      fmt::format("Compared in {:.2f} s, {:.0f} MB at most\n", c.seconds, double(c.memory) / 1e6);
  return out + verdict_text(c);
}

std::string comparison_junit(const Comparison& c) {
  const bool rejected = c.accepted && !*c.accepted;
  const std::size_t failures = rejected ? 1 + c.regions.size() : 0;
  std::string out = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<testsuites tests=\"{0}\" failures=\"{1}\">\n"
      " <testsuite name=\"mrsim compare {2}\" tests=\"{0}\" failures=\"{1}\" skipped=\"{3}\">\n",
      1 + c.regions.size(), failures, xml(c.part_name), c.accepted ? 0 : 1 + c.regions.size());
  const auto add = [&](const std::string& name, const std::string& message) {
    out += fmt::format("  <testcase classname=\"mrsim.compare\" name=\"{}\">", xml(name));
    if (!c.accepted)
      out += "<skipped message=\"no tolerance was given\"/>";
    else if (rejected)
      out += fmt::format("<failure message=\"{}\">{}</failure>",
                         xml(message.substr(0, message.find('\n'))), xml(message));
    out += "</testcase>\n";
  };
  std::string verdict = verdict_text(c);
  verdict.pop_back();
  add(c.part_name + " against " + c.nominal_name, verdict);
  for (std::size_t i = 0; i < c.regions.size(); ++i) {
    const DeviationRegion& r = c.regions[i];
    add(fmt::format("region {}: {} of {:.4f} mm", i + 1, r.gouge ? "gouge" : "excess",
                    std::abs(r.worst)),
        region_text(r, i + 1));
  }
  return out + " </testsuite>\n</testsuites>\n";
}

std::string comparison_junit(const FailedComparison& failed) {
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<testsuites tests=\"1\" failures=\"1\">\n"
      " <testsuite name=\"mrsim compare {0}\" tests=\"1\" failures=\"1\">\n"
      "  <testcase classname=\"mrsim.compare\" name=\"{0} against {1}\">"
      "<failure message=\"{2}\">{3}</failure></testcase>\n"
      " </testsuite>\n</testsuites>\n",
      xml(failed.part_name), xml(failed.nominal_name), xml(failed.error_code),
      xml(failed.error_text));
}

}  // namespace mrsim
