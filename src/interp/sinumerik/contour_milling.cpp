#include "interp/sinumerik/contour_milling.h"

#include "core/numbers/rounding.h"
#include "core/numbers/units.h"
#include "interp/path/arc.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr double kNoDirection = 1e-12;  // mm: a move along the tool's axis has no direction in plan

Vec2 direction(const Motion& m, const Frame& frame, const Basis& b, double at) {
  const Vec3 t = m.kind == MotionKind::arc ? arc_tangent(m, at) : m.end - m.start;
  const Vec2 flat = in_plane(b, turn_inverse(frame, t));
  return (1 / std::max(length(flat), kNoDirection)) * flat;
}

bool is_backward(const CycleCall& call) { return call.digit("VARI", 4) == 1; }

// From the last motion to the first, which leads to the start only.
std::vector<Motion> backwards(const std::vector<Motion>& contour) {
  std::vector<Motion> out = {contour.front()};
  out.front().end = contour.back().end;
  for (std::size_t i = contour.size() - 1; i > 0; --i) {
    Motion m = contour[i];
    std::swap(m.start, m.end);
    m.center = m.center + m.rise * m.axis;
    m.sweep = -m.sweep;
    m.rise = -m.rise;
    out.push_back(m);
  }
  return out;
}

}  // namespace

std::vector<Motion> ContourMilling::in_direction(const ContourCall& call) {
  const std::vector<Motion>& contour = call.contours.back();
  return is_backward(call.values) ? backwards(contour) : contour;
}

// KNAME RTP RFP SDIS DP MID FAL FALD FFP1 FFD VARI RL AS1 LP1 FF3 AS2 LP2
bool ContourMilling::read(Along& l) {
  const double unit = scale();
  if (!call_.given("RTP") || !call_.given("RFP") || !call_.given("DP"))
    return error("value-missing", "CYCLE72 needs RTP, RFP and DP, its planes and its depth",
                 where_);
  l.top = call_.get("RTP") * unit;
  l.reference = call_.get("RFP") * unit;
  const double down = l.top < l.reference ? 1 : -1;
  l.safe = l.reference - down * std::abs(call_.get("SDIS")) * unit;
  const bool relative = call_.digit("AMODE", 0) == 1;
  l.bottom =
      relative ? l.reference + down * std::abs(call_.get("DP")) * unit : call_.get("DP") * unit;
  if ((l.bottom - l.reference) * down <= 0)
    return error("value-range",
                 "CYCLE72: the depth does not lie below the reference plane (alarm 61101)", where_);
  const int kind = call_.digit("VARI", 0);
  if (kind == 1) {
    l.allowance = std::abs(call_.get("FAL")) * unit;
    l.bottom -= down * std::abs(call_.get("FALD")) * unit;
  }
  l.infeed = std::abs(call_.get("MID")) * unit;
  l.feed = call_.get("FFP1") * feed_scale();
  l.plunge = call_.get("FFD") > 0 ? call_.get("FFD") * feed_scale() : l.feed;
  if (!read_side(l)) return false;
  const double radius =
      l.side == 0 ? tools_.radius(modal_.edge) : tools_.radius_for("CYCLE72", modal_.edge, where_);
  if (l.side != 0 && radius <= 0) return false;
  if (kind == 5) {  // FS ZFS: one cut, its axis nearer to the contour than the tool's radius
    const auto cut = chamfering_.cut(call_, l.reference, down, where_);
    if (!cut) return false;
    if (l.side == 0) return error("value-range", "CYCLE72 chamfers with RL 41 or 42", where_);
    l.bottom = cut->bottom;
    l.infeed = 0;
    l.allowance = cut->aside - radius;
  }
  l.aside = l.side * (radius + l.allowance);
  return true;
}

bool ContourMilling::read_side(Along& l) {
  const double rl = call_.get("RL", 40);
  if (rl != 40 && rl != 41 && rl != 42)
    return error("value-range", "CYCLE72: RL is 40, 41 or 42", where_);
  l.side = rl == 41 ? 1 : rl == 42 ? -1 : 0;
  if (is_backward(call_) && l.side != 0)
    return error(
        "not-supported",
        "CYCLE72: the contour backwards (VARI) is not supported beside RL 41 and 42: write "
        "it in that direction",
        where_);
  return true;
}

bool ContourMilling::run() {
  Along l;
  if (!read(l)) return false;
  const int n = steps_of(std::abs(l.bottom - l.reference), l.infeed);
  mover_.rapid_height(l.top);
  double from = l.safe;
  for (int i = 1; i <= n; ++i) {
    const double to = i == n ? l.bottom : l.reference + (l.bottom - l.reference) * i / n;
    pass_along(l, from, to);
    from = call_.digit("VARI", 2) == 0 ? l.top : l.safe;
    mover_.rapid_height(i == n ? l.top : from);
    if (i < n) from = l.safe;
  }
  return true;
}

// Down beside the contour, along it with the radius, and away from it.
void ContourMilling::pass_along(const Along& l, double from, double level) {
  const Basis b = basis();
  const Vec3 start = apply_inverse(frames_.total, contour_.front().end);
  approach(l, level, from, false);
  const auto step = [&](Vec2 to) {
    Target target;
    target.programmed = from_plane(b, to, level);
    target.named = kAllAxes;
    moves_.compensated_step(target, where_, l.feed);
  };
  modal_.comp = l.side > 0 ? Code::comp_left : l.side < 0 ? Code::comp_right : Code::comp_off;
  modal_.offn = l.allowance;
  step(in_plane(b, start));
  const Vec3 shift = turn(frames_.total, (level - dot(start, b.w)) * b.w);
  modal_.feed = l.feed > 0 ? l.feed : modal_.feed;
  for (std::size_t i = 1; i < contour_.size(); ++i) moves_.follow(contour_[i], shift, where_);
  modal_.comp = Code::comp_off;
  modal_.offn = modal_before_.offn;
  const Motion& last = contour_.back();
  const Vec2 t = direction(last, frames_.total, b, 1);
  step(in_plane(b, apply_inverse(frames_.total, last.end)) + l.aside * left_of(t));
  approach(l, level, from, true);
  modal_.feed = modal_before_.feed;
}

// AS1 LP1 and AS2 LP2: a straight tangent, a quarter or half of a circle beside the contour.
void ContourMilling::approach(const Along& l, double level, double from, bool leaving) {
  const Basis b = basis();
  const Motion& m = leaving ? contour_.back() : contour_[1];
  const Vec3 corner = leaving ? m.end : contour_.front().end;
  Vec2 t = direction(m, frames_.total, b, leaving ? 1 : 0);
  const Vec2 aside = (l.side == 0 ? 0 : l.side) * left_of(t);
  const Vec2 at = in_plane(b, apply_inverse(frames_.total, corner)) + std::abs(l.aside) * aside;
  if (!leaving) t = -1 * t;  // outwards
  const int kind = l.side == 0 ? 1 : call_.digit(leaving ? ValueName("AS2") : ValueName("AS1"), 0);
  const double reach = std::abs(call_.get(leaving ? ValueName("LP2") : ValueName("LP1"))) * scale();
  PlanePiece arc;
  arc.arc = true;
  arc.center = at + reach * aside;
  arc.radius = reach;
  const Vec2 far = kind == 3   ? at + 2 * reach * aside
                   : kind == 2 ? arc.center + reach * t
                               : at + reach * t;
  arc.sweep = l.side * (kind == 3 ? kPi : kPi / 2);
  arc.start = leaving ? at : far;
  arc.end = leaving ? far : at;
  if (!leaving) {
    mover_.rapid(far);
    mover_.rapid_height(from);
    mover_.line_height(level, l.plunge);
  }
  if ((kind == 2 || kind == 3) && reach > kRounding)
    mover_.piece(arc, 0, l.feed);
  else
    mover_.line(leaving ? far : at, l.feed);
}

}  // namespace mrsim
