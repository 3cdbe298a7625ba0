// Where a contour stands, how it is kept, and milling along it.
#include "interp/sinumerik/sinumerik_contours.h"

#include "core/rounding.h"
#include "core/text_io.h"
#include "core/units.h"
#include "interp/path/arc.h"
#include "interp/text/characters.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

Vec2 direction(const Motion& m, const Frame& frame, const Basis& b, double at) {
  const Vec3 t = m.kind == MotionKind::arc ? arc_tangent(m, at) : m.end - m.start;
  const Vec2 flat = in_plane(b, turn_inverse(frame, t));
  return (1 / std::max(length(flat), 1e-12)) * flat;
}

}  // namespace

bool SinumerikContours::knows(std::string_view name) {
  return name == "CYCLE62" || name == "CYCLE63" || name == "CYCLE72" || name == "CYCLE95" ||
         name == "CYCLE952";
}

bool SinumerikContours::run(const CycleCall& call, const Word& where) {
  call_ = call;
  where_ = where;
  mover_.begin(where);
  if (call.name == "CYCLE62") return name_contour();
  if (modal_.comp != Code::comp_off)
    return error("cycle-compensation", "a cycle under radius compensation: G40 before it", where);
  if (!goes_on(where)) return false;
  waits_ = find_contours();
  return waits_;
}

// NAME, its kind, two labels. Calls behind one another add up; a cycle that runs ends the list.
bool SinumerikContours::name_contour() {
  if (named_used_) named_.clear();
  named_used_ = false;
  const std::string labels = call_.text(2) + ":" + call_.text(3);
  const std::string name = call_.text(2).empty() ? call_.text(0) : labels;
  if (name.empty()) return error("value-missing", "CYCLE62 needs the name of a contour", where_);
  named_.push_back(name);
  return true;
}

bool SinumerikContours::find_contours() {
  const bool own_name = call_.name == "CYCLE72" || call_.name == "CYCLE95";
  std::vector<std::string> names = named_;
  if (own_name && !call_.text(0).empty()) names = {call_.text(0)};
  if (own_name && names.size() > 1) names = {names.back()};
  if (names.empty()) names = {""};
  named_used_ = true;
  requests_.clear();
  contours_.clear();
  for (const std::string& name : names)
    if (!find_contour(name, requests_.emplace_back())) return false;
  return true;
}

// A subprogram, "FIRST:LAST" labels of this program, or the labels of the contour editor.
bool SinumerikContours::find_contour(const std::string& name, CallRequest& request) {
  const std::size_t colon = name.find(':');
  const bool labels = colon != std::string::npos;
  std::string first = upper_case(name.substr(0, colon)), last;
  if (labels) last = upper_case(name.substr(colon + 1));
  SubprogramName program;
  program.text = first;
  Place end;
  request.file = reader_.file();
  if (!labels && !name.empty() && reader_.has_subprogram(program)) {
    const auto place = reader_.locate(program, where_);
    request.file = place->file;
    request.begin = {place->offset, place->line, 0};
    return true;
  }
  if (!labels) {
    last = "E_LAB_E_" + first;
    first.insert(0, "E_LAB_A_");
  }
  if (name.empty() || !statements_ ||
      !statements_->places().find_labels(first, last, request.begin, end))
    return error(
        "subprogram-missing",
        fmt::format("the contour \"{}\" is neither a subprogram nor between labels of this "
                    "program",
                    to_utf8(name.substr(0, 60))),
        where_);
  request.end = end.offset;
  return true;
}

void SinumerikContours::end_block() {
  if (!waits_) return;
  waits_ = false;
  position_before_ = position_;
  modal_before_ = modal_;
  enter_contour();
}

void SinumerikContours::enter_contour() {
  CallRequest request = requests_[contours_.size()];
  request.on_start = [this] { begin_contour(); };
  request.on_end = [this] { end_contour(); };
  request.on_left = [this] {
    if (contours_.size() < requests_.size() && !contours_.empty()) enter_contour();
  };
  const Word where = where_;
  reader_.enter(std::move(request), where);
}

void SinumerikContours::end_program() {
  if (!out_.captures()) return;
  out_.capture(nullptr);
  reporter_.set_place(call_.place.file, call_.place.line, call_.place.call, {});
  error("program-end-missing", "the program ends inside the contour of this cycle", where_);
}

void SinumerikContours::begin_contour() {
  contour_.clear();
  errors_before_ = reporter_.errors();
  out_.capture(&contour_);
  if (modal_.feed == 0) modal_.feed = 1;  // the cycle has feeds of its own
}

void SinumerikContours::end_contour() {
  out_.capture(nullptr);
  modal_ = modal_before_;
  position_ = position_before_;
  modal_.comp = Code::comp_off;
  put_back_block(call_.place);
  if (reporter_.errors() != errors_before_) {
    contours_.clear();
    requests_.clear();
    return;
  }
  if (contour_.size() < 2 || contour_.size() >= MotionEmitter::kMostCaptured) {
    error("value-range", fmt::format("the contour has {} motions", contour_.size()), where_);
    requests_.clear();
  } else {
    contours_.push_back(contour_);
    if (contours_.size() == requests_.size()) finish_contours();
  }
  modal_.comp = modal_before_.comp;
}

void SinumerikContours::finish_contours() {
  if (call_.name == "CYCLE63")
    pocket();
  else
    call_.name == "CYCLE72" ? mill_along() : turn_down();
}

void SinumerikContours::go(const Vec3& to, MotionKind kind, double feed) {
  if (distance(to, position_.physical) <= kRounding) return;
  Target target;
  target.programmed = apply_inverse(frames_.total, to);
  target.named = lathe() ? 5 : 7;
  moves_.step(target, where_, kind, 0, feed);
}

// KNAME RTP RFP SDIS DP MID FAL FALD FFP1 FFD VARI RL AS1 LP1 FF3 AS2 LP2
bool SinumerikContours::mill_levels(Along& l) {
  const double unit = scale();
  if (!call_.given(1) || !call_.given(2) || !call_.given(4))
    return error("value-missing", "CYCLE72 needs RTP, RFP and DP, its planes and its depth",
                 where_);
  l.top = call_.get(1) * unit;
  l.reference = call_.get(2) * unit;
  const double down = l.top < l.reference ? 1 : -1;
  l.safe = l.reference - down * std::abs(call_.get(3)) * unit;
  const bool relative = call_.digit(22, 0) == 1;
  l.bottom = relative ? l.reference + down * std::abs(call_.get(4)) * unit : call_.get(4) * unit;
  if ((l.bottom - l.reference) * down <= 0)
    return error("value-range",
                 "CYCLE72: the depth does not lie below the reference plane (alarm 61101)", where_);
  const int kind = call_.digit(10, 0);
  if (call_.digit(10, 4) != 0)
    return error("not-supported", "CYCLE72: the contour backwards (VARI) is not supported yet",
                 where_);
  if (kind == 1) {
    l.allowance = std::abs(call_.get(6)) * unit;
    l.bottom -= down * std::abs(call_.get(7)) * unit;
  }
  l.infeed = std::abs(call_.get(5)) * unit;
  l.feed = call_.get(8) * feed_scale();
  l.plunge = call_.get(9) > 0 ? call_.get(9) * feed_scale() : l.feed;
  const double rl = call_.get(11, 40);
  if (rl != 40 && rl != 41 && rl != 42)
    return error("value-range", "CYCLE72: RL is 40, 41 or 42", where_);
  l.side = rl == 41 ? 1 : rl == 42 ? -1 : 0;
  const double radius =
      l.side == 0 ? tools_.radius(modal_.edge) : tools_.radius_for("CYCLE72", modal_.edge, where_);
  if (l.side != 0 && radius <= 0) return false;
  if (kind == 5) {  // FS ZFS: one cut, its axis nearer to the contour than the tool's radius
    const auto cut = chamfering_.cut(call_, 18, 22, l.reference, down, where_);
    if (!cut) return false;
    if (l.side == 0) return error("value-range", "CYCLE72 chamfers with RL 41 or 42", where_);
    l.bottom = cut->bottom;
    l.infeed = 0;
    l.allowance = cut->aside - radius;
  }
  l.aside = l.side * (radius + l.allowance);
  return true;
}

bool SinumerikContours::mill_along() {
  Along l;
  if (!mill_levels(l)) return false;
  const int n = steps_of(std::abs(l.bottom - l.reference), l.infeed);
  mover_.rapid_height(l.top);
  double from = l.safe;
  for (int i = 1; i <= n; ++i) {
    const double to = i == n ? l.bottom : l.reference + (l.bottom - l.reference) * i / n;
    pass_along(l, from, to);
    from = call_.digit(10, 2) == 0 ? l.top : l.safe;
    mover_.rapid_height(i == n ? l.top : from);
    if (i < n) from = l.safe;
  }
  return true;
}

// Down beside the contour, along it with the radius, and away from it.
void SinumerikContours::pass_along(const Along& l, double from, double level) {
  const Basis b = basis();
  const Vec3 start = apply_inverse(frames_.total, contour_.front().end);
  approach(l, level, from, false);
  const auto step = [&](Vec2 to) {
    Target target;
    target.programmed = from_plane(b, to, level);
    target.named = 7;
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
void SinumerikContours::approach(const Along& l, double level, double from, bool leaving) {
  const Basis b = basis();
  const Motion& m = leaving ? contour_.back() : contour_[1];
  const Vec3 corner = leaving ? m.end : contour_.front().end;
  Vec2 t = direction(m, frames_.total, b, leaving ? 1 : 0);
  const Vec2 aside = (l.side == 0 ? 0 : l.side) * left_of(t);
  const Vec2 at = in_plane(b, apply_inverse(frames_.total, corner)) + std::abs(l.aside) * aside;
  if (!leaving) t = -1 * t;  // outwards
  const int kind = l.side == 0 ? 1 : call_.digit(leaving ? 15 : 12, 0);
  const double reach = std::abs(call_.get(leaving ? 16 : 13)) * scale();
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
