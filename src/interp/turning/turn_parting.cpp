// CYCLE92 parts off.
#include "interp/turning/turn_cycles.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {

// SPD SPL DIAG1 DIAG2 RC SDIS SV1 SV2 SDAC FF1 FF2 SS2 DIAGM VARI DN DMODE AMODE
bool TurnCycles::parting_values(Groove& g) {
  const double unit = scale();
  for (const std::size_t i : {0, 1, 3})
    if (!call_.given(i))
      return fail("value-missing", "CYCLE92 needs X0, Z0 and X2: where it cuts, and how deep");
  if (call_.values.size() > 17) return refuse("a list of more than 17 values");
  if (call_.get(4) != 0) return refuse("a rounding or a chamfer of the edge (RC)");
  if (call_.digit(16, 0) > 1 || call_.digit(16, 1) > 1) return refuse("this AMODE");
  g.top = std::abs(call_.get(0)) * unit / 2;
  const auto depth = [&](std::size_t value, int digit) {
    const double size = call_.get(value) * unit;
    return call_.digit(16, digit) == 1 ? g.top - std::abs(size) : size / 2;
  };
  g.bottom = depth(3, 1);
  g.infeed = call_.given(2) ? depth(2, 0) : g.bottom;  // where the feed changes
  g.clear = g.top + std::abs(call_.get(5)) * unit;
  if (g.bottom >= g.top) return fail("value-range", "CYCLE92: X2 does not lie below X0");
  return true;
}

// The blade's right side cuts the part's face at Z0: straight in, slower from X1 on, and back.
bool TurnCycles::parting() {
  Groove g;
  tools_.require(where_, true);
  const Tool* tool = tools_.current();
  if (!parting_values(g)) return false;
  const double z = call_.get(1) * scale(), width = tool ? tool->width : 0;
  if (!blade(g, z - width, z)) return false;
  const double before = modal_.feed;
  to(g.clear, position_.programmed.z, MotionKind::rapid);
  to(g.clear, g.flanks[0].place, MotionKind::rapid);
  if (call_.get(9) > 0) modal_.feed = call_.get(9) * feed_scale();
  to(std::clamp(g.infeed, g.bottom, g.top), g.flanks[0].place, MotionKind::line);
  if (call_.get(10) > 0) modal_.feed = call_.get(10) * feed_scale();
  to(g.bottom, g.flanks[0].place, MotionKind::line);
  modal_.feed = before;
  to(g.clear, g.flanks[0].place, MotionKind::rapid);
  return true;
}

}  // namespace mrsim
