#include "interp/cycles/hole_maker.h"

#include "core/numbers/rounding.h"

#include <algorithm>
#include <cmath>

namespace mrsim {

double HoleMaker::level() const { return dot(position_.programmed, basis().w); }

void HoleMaker::approach(const Vec3& point, AxisSet named, const Word& where) {
  Target to;
  to.programmed = point;
  to.named = named;
  moves_.step(to, where, MotionKind::rapid);
}

void HoleMaker::to_level(double level, MotionKind kind, double lead, double feed) {
  const Basis b = basis();
  const double now = dot(position_.programmed, b.w);
  Target to;
  to.programmed = position_.programmed + (level - now) * b.w;
  to.named = axes_along(b.w);
  if (modal_.plane != kPlaneOfNormal)
    component(to.programmed, kNormalOfPlane[modal_.plane]) = level;
  moves_.step(to, *where_, kind, lead, feed);
}

void HoleMaker::move_to(double level, const Word& where) {
  where_ = &where;
  to_level(level, MotionKind::rapid, 0, 0);
}

// Makes the strokes before the last one and returns the level of the deepest.
double HoleMaker::strokes(const Hole& hole, double down) {
  double cleared = hole.safe;
  for (const double stroke : hole.strokes) {
    const bool full =
        hole.out_every > 0 && std::abs(stroke - cleared) >= hole.out_every - kRounding;
    if (full) cleared = stroke;
    to_level(stroke, kLine, hole.lead, hole.feed);
    moves_.dwell(hole.dwell_stroke);
    if (hole.lead != 0) {
      to_level(hole.safe, kLine, hole.lead, hole.feed);
    } else if (hole.chips_out || full) {
      to_level(hole.safe, kRapid, 0, 0);
      moves_.dwell(hole.dwell_safe);
      const double back = stroke - down * hole.clearance;
      if ((back - hole.safe) * down > 0) to_level(back, kRapid, 0, 0);
    } else {
      to_level(stroke - down * std::min(hole.clearance, std::abs(stroke - hole.safe)), kRapid, 0,
               0);
    }
  }
  return hole.strokes.empty() ? hole.safe : hole.strokes.back();
}

void HoleMaker::drill(const Hole& hole, const BlockPlace& place, const Word& where) {
  const int line = block_.line_number, file = block_.file, call = block_.call;
  const bool elsewhere = place.line != line || place.file != file;
  where_ = &where;
  if (elsewhere) {  // the point stands in another place than the cycle
    block_.call = reader_.call_site(line);
    block_.file = place.file;
    block_.line_number = place.line;
  }
  to_level(hole.safe, kRapid, 0, 0);
  const double reached = strokes(hole, hole.bottom < hole.safe ? -1 : 1);
  if (hole.bottom != reached) to_level(hole.bottom, kLine, hole.lead, hole.feed);
  moves_.dwell(hole.dwell);
  if (length(hole.lift) > 0) {
    Target to;
    to.programmed = position_.programmed + hole.lift;
    to.named = kAllAxes;
    moves_.step(to, where, kRapid);
  }
  if (hole.feed_out) {
    to_level(hole.feed_to_end ? hole.end : hole.safe, kLine, hole.lead, hole.feed_back);
    moves_.dwell(hole.dwell_out);
  }
  to_level(hole.end, kRapid, 0, 0);
  if (length(hole.lift) > 0) {
    const Basis b = basis();
    Target to;
    to.programmed = position_.programmed - (hole.lift - dot(hole.lift, b.w) * b.w);
    to.named = kAllAxes;
    moves_.step(to, where, kRapid);
  }
  block_.line_number = line;
  block_.file = file;
  block_.call = call;
}

}  // namespace mrsim
