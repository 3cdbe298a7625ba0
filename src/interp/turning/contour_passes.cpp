#include "interp/turning/contour_passes.h"

#include "core/numbers/rounding.h"
#include "interp/cycles/hole_maker.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr double kMostMotions = 1e7;  // of a G73

}  // namespace

void ContourPasses::go(const Vec3& to, MotionKind kind) {
  if (distance(to, position_.physical) <= kRounding) return;
  Target target;
  target.programmed = apply_inverse(frames_.total, to);
  target.named = kAxisX | kAxisZ;
  moves_.compensated_step(target, cut_.where, 0, kind);
}

// Gives the allowances the sign of the side from which the passes come.
void ContourPasses::orient_allowance() {
  const int u = cut_.number == 72 ? 2 : 0, v = 2 - u;
  const Vec3 from = position_.physical;
  double deepest = 0;
  for (const Motion& m : contour_) {
    const double travel = component(m.end - from, u);
    if (std::abs(travel) > std::abs(deepest)) deepest = travel;
  }
  const double travel = contour_.empty() ? 0 : component(contour_.back().end - from, v);
  component(cut_.allowance, u) = std::copysign(component(cut_.allowance, u), -deepest);
  component(cut_.allowance, v) = std::copysign(component(cut_.allowance, v), -travel);
}

// G73 runs the whole contour, each time nearer.
bool ContourPasses::repeat() {
  const TurnSettings& set = modal_.turn_settings;
  if (static_cast<double>(set.repeats) * static_cast<double>(contour_.size()) > kMostMotions)
    return error("value-range", fmt::format("more than {:g} motions", kMostMotions), cut_.where);
  const Vec3 from = position_.physical;
  for (int i = 0; i < set.repeats; ++i) {
    const double share = set.repeats > 1 ? 1 - static_cast<double>(i) / (set.repeats - 1) : 0;
    const Vec3 shift = cut_.allowance + share * Vec3{set.shift_x, 0, set.shift_z};
    go(from + shift, kRapid);
    for (const Motion& m : contour_) moves_.follow(m, shift, cut_.where);
  }
  go(from, kRapid);
  return true;
}

// Removes a rapid back to where the cycle began, "N20 G0 G40 Z0.1", if no point of the contour lies
// farther out.
void ContourPasses::leave_out_return() {
  if (contour_.size() < 3) return;
  const Motion& last = contour_.back();
  const int u = cut_.number == 72 ? 2 : 0, v = 2 - u;
  const Vec3 from = position_.physical, begin = contour_.front().end;
  const double out = component(from, u) - component(begin, u);  // away from the contour
  const bool back = component(last.end - last.start, v) * component(last.start - from, v) < 0;
  const double low = std::min(component(last.start, u) * out, component(last.end, u) * out);
  for (std::size_t i = 0; i + 1 < contour_.size(); ++i)
    if (component(contour_[i].end, u) * out > low + kRounding) return;
  if (last.kind != kRapid || !back) return;
  reporter_.add_at(Severity::warning, "cycle-contour",
                   "the last block of the contour goes back with a rapid: FANUC stops there (alarm "
                   "064), Haas goes on; roughing leaves it out",
                   last);
  contour_.pop_back();
}

// Where the passes begin, at `top`, and in which directions they go.
ContourPasses::Rough ContourPasses::directions(const Vec3& top, const Vec3& shift) const {
  Rough r;
  r.u = cut_.number == 72 ? 2 : 0;
  r.v = 2 - r.u;
  r.top = component(top, r.u);
  r.start = component(top, r.v);
  r.down = -1;
  double farthest = 0;
  for (const Motion& m : contour_) {
    const double travel = component(m.end + shift, r.u) - r.top;
    if (std::abs(travel) <= farthest) continue;
    farthest = std::abs(travel);
    r.down = travel > 0 ? 1 : -1;
  }
  r.along = component(contour_.back().end + shift, r.v) > r.start ? 1 : -1;
  return r;
}

// Reports that the contour runs back in this motion.
void ContourPasses::refuse_way_back(std::size_t motion) {
  const Motion& m = contour_[motion];
  const bool home = m.kind == MotionKind::rapid && motion + 1 == contour_.size();
  reporter_.add_at(Severity::error, "not-supported",
                   home ? "the last block of the contour goes back with a rapid, where controls "
                          "stop (alarm 064): let Q name the block before it"
                        : "the contour of the cycle runs back here (an undercut), which is not "
                          "supported yet",
                   m);
}

// G71 whose first block has no Z is of type I.
void ContourPasses::tell_of_pocket(const Rough& r, const RoughContour& shape) {
  const int bad = shape.falls();
  if (cut_.lap || cut_.pockets || bad < 0) return;
  const char axis = "XYZ"[r.v];
  reporter_.add_at(
      Severity::warning, "cycle-contour",
      fmt::format("the contour falls here, a pocket: G{0} whose first block has no {1} (type I) "
                  "stops there (alarm 064) or leaves the pocket to the last pass; it is cut as "
                  "type II, which {1} or {2}0 in that block asks for",
                  cut_.number, axis, r.v == 0 ? 'U' : 'W'),
      contour_[static_cast<std::size_t>(bad) + 1]);
}

// G71 cuts along Z, G72 along X: passes at levels down to the contour, then in its pockets, then
// once along it.
bool ContourPasses::rough() {
  leave_out_return();
  if (contour_.size() < 2)
    return error("value-missing", "the contour of the cycle has no motions", cut_.where);
  if (contour_.front().kind == MotionKind::arc) {
    reporter_.add_at(
        Severity::error, "cycle-contour",
        "the contour begins with an arc: G0 or G1 must lead to it, as the passes do to "
        "their levels (alarm 065)",
        contour_.front());
    return false;
  }
  if (cut_.lap) orient_allowance();
  const Vec3 from = position_.physical, shift = cut_.allowance;
  const Vec3 top = cut_.lap ? from : from + shift;
  const Rough r = directions(top, shift);
  if (component(shift, r.u) * r.down > kRounding)
    warning("cycle-allowance",
            fmt::format("{} of G{} leads into the finished shape, which is cut too deep: of a bore "
                        "it is below 0",
                        r.u == 0 ? 'U' : 'W', cut_.number),
            cut_.where);
  std::vector<PlanePiece> pieces;
  for (std::size_t i = 1; i < contour_.size(); ++i)
    pieces.push_back(turned_piece(contour_[i], r.u, r.v, shift + cut_.semi_finish));
  const RoughContour shape(std::move(pieces), -r.down, r.along);
  if (const int bad = shape.runs_back(); bad >= 0) {
    refuse_way_back(static_cast<std::size_t>(bad) + 1);
    return false;
  }
  tell_of_pocket(r, shape);
  go(top, kRapid);
  if (!levels(r, shape)) return false;
  for (const Motion& m : contour_) moves_.follow(m, shift, cut_.where);
  go(from, kRapid);
  return true;
}

// Cuts the stretches that are open to the start, from the top down; then the pockets, from the top
// down.
bool ContourPasses::levels(const Rough& r, const RoughContour& shape) {
  const double depth = modal_.turn_settings.depth;
  const double whole = r.down * (shape.deepest() - r.top);
  if (whole / depth > static_cast<double>(kMostStrokes))
    return error("value-range", fmt::format("more than {} passes", kMostStrokes), cut_.where);
  std::vector<std::pair<double, FreeStretch>> pockets;
  for (int i = 1; i * depth < whole - kRounding; ++i) {
    const double at = r.top + r.down * i * depth;
    for (const FreeStretch& stretch : shape.free_at(at)) {
      if (stretch.first)
        pass(r, at, stretch.to);
      else
        pockets.emplace_back(at, stretch);
    }
    if (pockets.size() > kMostStrokes)
      return error("value-range", fmt::format("more than {} passes", kMostStrokes), cut_.where);
  }
  for (const auto& [at, stretch] : pockets) pocket_pass(r, at, stretch);
  if (pockets.empty()) return true;
  Vec3 p = position_.physical;
  component(p, r.u) = r.top;
  go(p, kRapid);
  component(p, r.v) = r.start;
  go(p, kRapid);
  return true;
}

// Goes to the level, along it to the contour, away at 45 degrees, and back.
void ContourPasses::pass(const Rough& r, double at, double end) {
  if ((end - r.start) * r.along <= kRounding) return;
  Vec3 p = position_.physical;
  component(p, r.u) = at;
  go(p, contour_.front().kind);
  stroke(r, at, r.start, end);
  p = position_.physical;
  component(p, r.v) = r.start;
  go(p, kRapid);
}

// Goes over the pocket at the height of the start, down to the pass before, and into the material.
void ContourPasses::pocket_pass(const Rough& r, double at, const FreeStretch& stretch) {
  const TurnSettings& set = modal_.turn_settings;
  if ((stretch.to - stretch.from) * r.along <= kRounding) return;
  Vec3 p = position_.physical;
  component(p, r.u) = r.top;
  go(p, kRapid);
  component(p, r.v) = stretch.from;
  go(p, kRapid);
  const double above = std::min(set.depth + set.escape, r.down * (at - r.top));
  component(p, r.u) = at - r.down * above;
  go(p, kRapid);
  component(p, r.u) = at;
  go(p, kLine);
  stroke(r, at, stretch.from, stretch.to);
}

void ContourPasses::stroke(const Rough& r, double at, double begin, double end) {
  Vec3 p = position_.physical;
  component(p, r.v) = end;
  go(p, kLine);
  const double escape = std::min(modal_.turn_settings.escape, (end - begin) * r.along);
  component(p, r.u) = at - r.down * escape;
  component(p, r.v) = end - r.along * escape;
  go(p, kRapid);
}

}  // namespace mrsim
