#include "interp/comments/form_outline.h"

#include "core/numbers/trig.h"
#include "core/numbers/units.h"

#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

std::string outline_text(const std::vector<ProfilePoint>& points) {
  std::string text;
  for (const ProfilePoint& p : points)
    text += fmt::format("{}[{:.6g}, {:.6g}{}]", text.empty() ? "" : ", ", p.r, p.z,
                        p.bulge == 0 ? "" : fmt::format(", {:.5f}", p.bulge));
  return fmt::format("profile = [{}]", text);
}

std::string dovetail_example(const ToolHint& hint, double diameter) {
  const double angle = hint.taper_angle > 0 ? hint.taper_angle : radians(60);
  const SinCos lean = sincos(angle);
  const double height = std::round(2.5 * diameter * lean.sin / lean.cos) / 10;
  if (!(height > 0)) return {};
  return fmt::format("{} where its head is {:.6g} mm high{}",
                     outline_text(dovetail_outline(diameter, angle, height)), height,
                     hint.taper_angle > 0 ? "" : " and its angle 60 degrees");
}

// A corner rounding mill: a hollow quarter circle from the tip's cylinder to the full diameter.
std::string rounding_example(double radius, double diameter) {
  constexpr double kQuarter = -0.41421356237;  // bulge: clockwise
  const double tip = diameter > 2 * radius ? diameter / 2 - radius : radius;
  return fmt::format("{} where its tip is {:.6g} mm wide",
                     outline_text({{0, 0, 0}, {tip, 0, kQuarter}, {tip + radius, radius, 0}}),
                     2 * tip);
}

}  // namespace

std::vector<ProfilePoint> dovetail_outline(double diameter, double angle, double height) {
  const SinCos lean = sincos(angle);
  const double top = diameter / 2 - height * lean.cos / lean.sin;
  if (!(top > 0)) return {};
  return {{0, 0, 0}, {diameter / 2, 0, 0}, {top, height, 0}};
}

std::vector<ProfilePoint> centre_drill_outline(double pilot, double body, double length,
                                               double angle) {
  const auto rise = [](double width, double point) {
    const SinCos half = sincos(point / 2);
    return width / 2 * half.cos / half.sin;
  };
  return {{0, 0, 0},
          {pilot / 2, rise(pilot, radians(118)), 0},
          {pilot / 2, length, 0},
          {body / 2, length + rise(body - pilot, angle), 0}};
}

std::string outline_example(const ToolHint& hint, double unit) {
  const double diameter = hint.diameters.empty() ? 0 : hint.diameters.front().mm(unit);
  if (hint.trade == ToolTrade::dovetail)
    return dovetail_example(hint, diameter > 0 ? diameter : 20);
  if (hint.trade != ToolTrade::rounding || !hint.corner) return {};
  return rounding_example(hint.corner.mm(unit), diameter);
}

}  // namespace mrsim
