#include "interp/sinumerik/contour_pocket.h"

#include "core/numbers/rounding.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr int kRoughing = 1, kFloor = 3, kWall = 4, kChamfer = 5;

}  // namespace

// Its values: PRG VARI RP Z0 SC Z1 F FZ DXY DZ UXY UZ CDIR XS YS ER EP EW FS ZFS TR DR UMODE GMODE
// DMODE AMODE.
bool ContourPocket::read(RegionCutter::Levels& l) {
  const double unit = scale();
  const int kind = call_.digit("VARI", 0), plane = call_.digit("DMODE", 0),
            direction = call_.digit("CDIR", 0);
  if (!call_.given({"VARI", "RP", "Z0", "Z1"}))
    return error("value-missing", "CYCLE63 needs VARI, RP, Z0 and Z1: how, its planes, its depth",
                 where_);
  if (call_.values.size() > 26)
    return error("not-supported", "CYCLE63: a list of more than 26 values", where_);
  if (kind != kRoughing && (kind < kFloor || kind > kChamfer))
    return error("not-supported",
                 fmt::format("CYCLE63: VARI {:g} is not supported; its unit is 1 (roughing), 3 "
                             "(finishing the floor), 4 (the wall) or 5 (chamfering)",
                             call_.get("VARI")),
                 where_);
  if (plane != 0 && plane != modal_.plane + 1)
    return error("cycle-plane", "CYCLE63: DMODE names another plane than the one in force", where_);
  if (direction > 1)
    return error("value-range", "CYCLE63: CDIR is 0 (climbing) or 1 (conventional)", where_);
  l.top = call_.get("RP") * unit;
  l.reference = call_.get("Z0") * unit;
  const double down = l.top < l.reference ? 1 : -1;
  l.safe = l.reference - down * std::abs(call_.get("SC")) * unit;
  l.bottom = call_.get("Z1") * unit;
  if (call_.digit("AMODE", 0) == 1) l.bottom = l.reference + down * std::abs(l.bottom);
  if ((l.bottom - l.reference) * down <= 0)
    return error("value-range",
                 "CYCLE63: the depth does not lie below the reference plane (alarm 61101)", where_);
  if (kind != kFloor) l.bottom -= down * std::abs(call_.get("UZ")) * unit;
  if ((l.bottom - l.reference) * down <= 0)
    return error("value-range", "CYCLE63: UZ is larger than the depth", where_);
  l.infeed = kind == kFloor ? 0 : std::abs(call_.get("DZ")) * unit;
  l.feed = call_.get("F") * feed_scale();
  l.plunge = call_.get("FZ") > 0 ? call_.get("FZ") * feed_scale() : l.feed;
  l.clockwise = direction == 1;
  return true;
}

// Finds the area in which the cutter may move about the blank of a spigot: a diameter over its
// edge.
bool ContourPocket::surroundings(double radius, const Loop& blank, Loop& out) {
  std::vector<Loop> around;
  if (!Region(std::nullopt, {blank}).inset(2 * radius, around) || around.empty())
    return error("pocket-contour", "CYCLE63: there is no way about the blank's contour", where_);
  out = *std::min_element(around.begin(), around.end(), [](const Loop& a, const Loop& b) {
    return signed_area(a) < signed_area(b);
  });
  return true;
}

bool ContourPocket::run() {
  RegionCutter::Levels l;
  if (!read(l)) return false;
  if (std::abs(plane_factor() - 1) > kTurnRounding)
    return error("not-supported",
                 "CYCLE63 under a scale: whether the control scales the cutter's radius, too, is "
                 "not known; write the contour that is to be cut",
                 where_);
  double radius = tools_.radius_for("CYCLE63", modal_.edge, where_);
  if (radius <= 0) return false;
  std::vector<Loop> loops(contours_.size());
  for (std::size_t i = 0; i < loops.size(); ++i)
    if (!cutter_.closed_loop(contours_[i], 1, loops[i])) return false;
  const int technology = call_.digit("DMODE", 2), kind = call_.digit("VARI", 0);
  const bool along = kind == kWall || kind == kChamfer;
  if (kind == kChamfer) {
    const auto cut = chamfering_.cut(call_, l.reference, l.top < l.reference ? 1 : -1, where_);
    if (!cut) return false;
    radius = cut->aside;
    l.bottom = cut->bottom;
    l.infeed = 0;
  }
  const std::vector<Loop> islands(loops.begin() + 1, loops.end());
  if (technology > 2 || (technology == 2 && islands.empty()))
    return error("not-supported",
                 "CYCLE63: a spigot needs two contours before it, the blank's and its own", where_);
  if (technology == 2)
    note_once("cycle-spigot",
              "CYCLE63 is read as a spigot (DMODE): its first contour is the blank's, over whose "
              "edge the cutter runs",
              where_, "CYCLE63");
  if (technology == 2 && !along && !surroundings(radius, loops[0], loops[0])) return false;
  double step = std::abs(call_.get("DXY")) * scale();
  if (call_.digit("AMODE", 1) == 1) step = std::abs(call_.get("DXY")) * radius / 50;  // per cent
  const bool border = technology != 2 || !along;
  const Region region(border ? std::optional<Loop>(loops[0]) : std::nullopt, islands);
  if (along) return cutter_.follow(region, radius, 0, l, where_);
  return cutter_.clear(region, radius, std::abs(call_.get("UXY")) * scale(), step, l, where_);
}

}  // namespace mrsim
