// The machine-readable result; its schema is in docs/compare.md.
#include "core/text/text_io.h"
#include <mrsim/compare.h>

#include <algorithm>

#include <nlohmann/json.hpp>

namespace mrsim {
namespace {

using Json = nlohmann::ordered_json;

// Infinities, which JSON lacks, stand for "nothing": an empty extent.
Json number(double x) { return x - x == 0 ? Json(x == 0 ? 0.0 : x) : Json(nullptr); }
Json point(const Vec3& p) { return {number(p.x), number(p.y), number(p.z)}; }

Json figures_json(const DeviationFigures& f) {
  return {{"samples", f.samples},
          {"vertices", f.vertices},
          {"density", number(f.density)},
          {"area", number(f.area)},
          {"min", number(f.min)},
          {"min_at", point(f.min_place)},
          {"max", number(f.max)},
          {"max_at", point(f.max_place)},
          {"mean", number(f.mean)},
          {"median", number(f.median)},
          {"mean_absolute", number(f.mean_absolute)},
          {"rms", number(f.rms)},
          {"standard_deviation", number(f.deviation)},
          {"percentiles",
           {{"1", number(f.p1)},
            {"5", number(f.p5)},
            {"50", number(f.p50)},
            {"95", number(f.p95)},
            {"99", number(f.p99)}}},
          {"in_tolerance", number(f.in_tolerance)},
          {"excess_area", number(f.excess_area)},
          {"gouge_area", number(f.gouge_area)}};
}

Json bound_json(const HausdorffBound& b) {
  return {{"lower", number(b.lower)}, {"upper", number(b.upper)}, {"at", point(b.place)}};
}

Json line_json(const BlamedLine& l) {
  Json out{{"file", to_utf8(l.file)},
           {"line", l.line},
           {"text", to_utf8(l.text)},
           {"tool", to_utf8(l.tool)},
           {"role", l.beside ? "beside" : "cut"}};
  if (l.beside)
    out["distance"] = number(l.distance);
  else
    out.update({{"share", number(l.share)}, {"worst", number(l.worst)}});
  return out;
}

Json region_json(const DeviationRegion& r) {
  Json lines = Json::array();
  for (const BlamedLine& l : r.lines) lines.push_back(line_json(l));
  return {{"kind", r.gouge ? "gouge" : "excess"},
          {"worst", number(r.worst)},
          {"mean", number(r.mean)},
          {"at", point(r.place)},
          {"normal", point(r.normal)},
          {"extent", {point(r.extent.lo), point(r.extent.hi)}},
          {"area", number(r.area)},
          {"nominal_area", number(r.nominal_area)},
          {"volume", number(r.volume)},
          {"stock_share", number(r.stock_share)},
          {"lines", std::move(lines)}};
}

Json program_lines_json(const Comparison& c) {
  Json out = Json::array();
  for (const LineFigures& l : c.lines) {
    const auto name = [](const std::vector<std::string>& list, std::int32_t i) {
      return i >= 0 && std::size_t(i) < list.size() ? Json(to_utf8(list[std::size_t(i)]))
                                                    : Json(nullptr);
    };
    out.push_back({{"file", name(c.origin.files, l.file)},
                   {"line", l.line > 0 ? Json(l.line) : Json(nullptr)},
                   {"tool", name(c.origin.tools, l.tool)},
                   {"area", number(l.area)},
                   {"mean", number(l.mean)},
                   {"min", number(l.min)},
                   {"max", number(l.max)},
                   {"out_area", number(l.out_area)}});
  }
  return out;
}

Json transform_json(const RigidTransform& t) {
  Json rows = Json::array();
  for (const Vec3& row : t.rotation) rows.push_back(point(row));
  return {{"rotation", std::move(rows)}, {"shift", point(t.shift)}};
}

}  // namespace

std::string comparison_json(const Comparison& c) {
  constexpr std::array kAlign{"none", "bbox", "icp"};
  Json out{{"schema", 1},
           {"unit", "mm"},
           {"part", to_utf8(c.part_name)},
           {"nominal", to_utf8(c.nominal_name)},
           {"error", nullptr},
           {"verdict", !c.accepted   ? "none"
                       : *c.accepted ? "accepted"
                                     : "rejected"},
           {"proven",
            c.accepted && (!*c.accepted || c.hausdorff.upper <= std::min(-c.band.lo, c.band.hi))},
           {"tolerance", {{"lo", number(c.band.lo)}, {"hi", number(c.band.hi)}}},
           {"align", kAlign[std::size_t(c.align)]},
           {"transform", transform_json(c.transform)},
           {"part_to_nominal", figures_json(c.part)},
           {"nominal_to_part", figures_json(c.nominal)},
           {"hausdorff",
            {{"part_to_nominal", bound_json(c.part_to_nominal)},
             {"nominal_to_part", bound_json(c.nominal_to_part)},
             {"symmetric", bound_json(c.hausdorff)}}},
           {"volume",
            {{"part", number(c.part_volume)},
             {"nominal", number(c.nominal_volume)},
             {"excess", number(c.excess_volume)},
             {"gouge", number(c.gouge_volume)},
             {"error", number(c.volume_error)}}},
           {"histogram",
            {{"lo", number(c.histogram.lo)},
             {"hi", number(c.histogram.hi)},
             {"share", c.histogram.share}}},
           {"region_count", c.region_count}};
  out["regions"] = Json::array();
  for (const DeviationRegion& r : c.regions) out["regions"].push_back(region_json(r));
  out["lines"] = program_lines_json(c);
  out["hints"] = Json::array();
  for (const ComparisonHint& h : c.hints)
    out["hints"].push_back({{"code", h.code}, {"text", to_utf8(h.text)}});
  return out.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string comparison_json(const FailedComparison& failed) {
  Json out = Json::parse(comparison_json(Comparison{}));
  for (auto& value : out) value = nullptr;
  out.update({{"schema", 1},
              {"unit", "mm"},
              {"part", to_utf8(failed.part_name)},
              {"nominal", to_utf8(failed.nominal_name)},
              {"error", {{"code", failed.error_code}, {"text", to_utf8(failed.error_text)}}},
              {"verdict", "failed"}});
  return out.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace mrsim
