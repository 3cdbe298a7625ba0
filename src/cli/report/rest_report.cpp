#include "cli/report/rest_report.h"

#include "cli/console/figures.h"
#include "core/text/text_io.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace mrsim::cli {
namespace {

using Json = nlohmann::ordered_json;

Json xyz(const Vec3& p) { return Json::array({p.x, p.y, p.z}); }

Json reach_json(const ReachingTool& t) {
  return {{"diameter", t.diameter},
          {"error", t.error},
          {"or_more", t.is_least},
          {"leaves_edge", t.is_most}};
}

std::string reach_text(const ReachingTool& t) {
  if (!(t.diameter > t.error)) return "none";
  if (t.is_most) return fmt::format("none above Ø{:.2g}, for an inner edge", t.diameter + t.error);
  const double unit = std::pow(10, std::floor(std::log10(t.error)));
  return fmt::format("Ø{:g}{} ± {:.1g}", std::round(t.diameter / unit) * unit,
                     t.is_least ? " or more" : "", t.error);
}

}  // namespace

std::string rest_text(const Rest& rest) {
  std::string out = fmt::format(
      "{} mm³ are left in {} {}, by voxels of {:.3g} mm; what is no thicker than {:.3g} mm is left "
      "out\n",
      grouped(rest.volume, 3), rest.pieces.size(), rest.pieces.size() == 1 ? "piece" : "pieces",
      rest.voxel, rest.above);
  std::size_t number = 0;
  for (const RestPiece& p : rest.pieces) {
    const Vec3 &lo = p.bounds.lo, &hi = p.bounds.hi;
    out += fmt::format(
        "{:>3}  {} mm³{}, {:.3f} mm thick at ({:.3f}, {:.3f}, {:.3f}); {:.2f} x {:.2f} x {:.2f} mm "
        "about ({:.2f}, {:.2f}, {:.2f})\n",
        ++number, grouped(p.volume, 3), p.is_exact ? "" : " by its voxels alone", p.thickness,
        p.place.x, p.place.y, p.place.z, hi.x - lo.x, hi.y - lo.y, hi.z - lo.z, p.center.x,
        p.center.y, p.center.z);
    if (p.searched)
      out += fmt::format(
          "     reached to within {:.2g} mm by a flat end mill from above: {}; by a ball: {}\n",
          rest.leaves, reach_text(p.flat), reach_text(p.ball));
  }
  return out;
}

std::string rest_json(const Rest& rest, const std::string& part, const std::string& nominal) {
  Json pieces = Json::array();
  for (const RestPiece& p : rest.pieces) {
    Json one{
        {"volume", p.volume},       {"exact", p.is_exact},
        {"thickness", p.thickness}, {"place", xyz(p.place)},
        {"center", xyz(p.center)},  {"bounds", Json::array({xyz(p.bounds.lo), xyz(p.bounds.hi)})}};
    one["ball"] = p.searched ? reach_json(p.ball) : Json(nullptr);
    one["flat"] = p.searched ? reach_json(p.flat) : Json(nullptr);
    pieces.push_back(std::move(one));
  }
  const Json out{{"schema", 1},
                 {"kind", "rest"},
                 {"unit", "mm"},
                 {"part", to_utf8(part)},
                 {"nominal", to_utf8(nominal)},
                 {"error", nullptr},
                 {"voxel", rest.voxel},
                 {"above", rest.above},
                 {"leaves", rest.leaves},
                 {"volume", rest.volume},
                 {"pieces", std::move(pieces)}};
  return out.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string failed_rest_json(const std::string& part, const std::string& nominal,
                             const std::string& error_code, const std::string& error_text) {
  Json out = Json::parse(rest_json({}, part, nominal));
  for (const char* unknown : {"voxel", "above", "leaves", "volume"}) out[unknown] = nullptr;
  out["error"] = {{"code", error_code}, {"text", to_utf8(error_text)}};
  return out.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace mrsim::cli
