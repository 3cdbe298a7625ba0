#include "interp/turning/corner_cycle.h"

#include "interp/path/clearing.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {

// Its values: SPD SPL EPD EPL ZPD ZPL LAGE MID FALX FALZ VARI RF1 RF2 RF3 SDIS FF1 NR DMODE AMODE.
bool CornerCycle::read(Corner& c) {
  const double unit = scale();
  if (!call_.given({"SPD", "SPL", "EPD", "EPL", "VARI"}))
    return fail("value-missing", "CYCLE951 needs its two corners and VARI, how it cuts");
  if (call_.values.size() > 19) return refuse("a list of more than 19 values");
  if (call_.get("NR") != 0) return refuse("a stock removal with an oblique or rounded corner (NR)");
  if (std::fmod(std::abs(call_.get("AMODE")), 10'000) != 0)
    return refuse("an incremental end point (AMODE)");
  const int way = call_.digit("VARI", 0), work = call_.digit("VARI", 1);
  if (way < 1 || way > 2 || work < 1 || work > 2 || call_.get("VARI") > 22)
    return fail("not-supported",
                "CYCLE951: VARI other than 11, 12 (roughing), 21, 22 (finishing) is not supported");
  c.start = {call_.get("SPD") * unit / 2, 0, call_.get("SPL") * unit};
  c.end = {call_.get("EPD") * unit / 2, 0, call_.get("EPL") * unit};
  c.u = way == 1 ? 0 : 2;
  c.v = 2 - c.u;
  c.clear = std::abs(call_.get("SDIS")) * unit;
  c.depth = std::abs(call_.get("MID")) * unit;
  const Vec3 whole = c.end - c.start;
  if (component(whole, c.u) == 0 || component(whole, c.v) == 0)
    return fail("value-range", "CYCLE951: the two corners have the same X or the same Z");
  c.down = sign_of(component(whole, c.u));
  c.along = sign_of(component(whole, c.v));
  if (work == 1) {
    c.allowance = {-sign_of(whole.x) * std::abs(call_.get("FALX")) * unit, 0,
                   -sign_of(whole.z) * std::abs(call_.get("FALZ")) * unit};
    if (c.depth <= 0) return fail("value-missing", "CYCLE951 needs MID, the depth of a pass");
    if (std::abs(component(whole, c.u)) / c.depth > kMostTurningPasses)
      return fail("value-range", "too many passes");
  }
  return true;
}

bool CornerCycle::run() {
  Corner c;
  if (!read(c)) return false;
  const double before = modal_.feed;
  if (call_.get("FF1") > 0) modal_.feed = call_.get("FF1") * feed_scale();
  if (call_.digit("VARI", 1) == 1)
    rough(c);
  else
    finish(c);
  modal_.feed = before;
  return true;
}

// Cuts each level to the end, goes away at 45 degrees, and back in front of the material.
void CornerCycle::rough(const Corner& c) {
  const Vec3 end = c.end + c.allowance;
  const double from = component(c.start, c.u), stop = component(end, c.v);
  const double begin = component(c.start, c.v) - c.along * c.clear;
  const auto go = [&](double u, double v, MotionKind kind) {
    c.u == 0 ? to(u, v, kind) : to(v, u, kind);
  };
  const double whole = (component(end, c.u) - from) * c.down;
  if (whole <= 0 || (stop - component(c.start, c.v)) * c.along <= 0) return;
  go(from - c.down * c.clear, begin, MotionKind::rapid);
  const int n = steps_of(whole, c.depth);
  for (int i = 1; i <= n; ++i) {
    const double at = from + c.down * whole * i / n;
    go(at, begin, MotionKind::rapid);
    go(at, stop, MotionKind::line);
    const double off = std::min(c.clear, (stop - begin) * c.along);
    go(at - c.down * off, stop - c.along * off, MotionKind::rapid);
    go(at - c.down * off, begin, MotionKind::rapid);
  }
  go(from - c.down * c.clear, begin, MotionKind::rapid);
}

// Cuts along the last level into the corner, and out of it along the other side.
void CornerCycle::finish(const Corner& c) {
  const Vec3 out =
      c.start - c.clear * Vec3{sign_of(c.end.x - c.start.x), 0, sign_of(c.end.z - c.start.z)};
  to(out.x, out.z, MotionKind::rapid);
  Vec3 p = out;
  component(p, c.u) = component(c.end, c.u);
  to(p.x, p.z, MotionKind::rapid);
  to(c.end.x, c.end.z, MotionKind::line);
  p = c.end;
  component(p, c.u) = component(out, c.u);
  to(p.x, p.z, MotionKind::line);
  to(out.x, out.z, MotionKind::rapid);
}

}  // namespace mrsim
