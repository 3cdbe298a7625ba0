#include "interp/milling/haas_pocket.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace mrsim {

bool HaasPocket::wants_block() const {
  return block_.oneshot && block_.oneshot_code == Code::contour_pocket;
}

// The words are P X Y Z R Q, I or J, K, beside G41 or G42 and D.
bool HaasPocket::read_words() {
  const Word *p = take('P'), *q = take('Q'), *r = take('R'), *i = take('I'), *j = take('J'),
             *k = take('K'), *z = peek('Z');
  if (!p || !q || !r || !z || (!i && !j))
    return error("value-missing",
                 "G150 needs P, the program of its contour, Z, R, Q, the depth of a cut, and I or "
                 "J, how far the cuts lie apart",
                 where_);
  if (modal_.plane != kPlaneXY) return error("value-range", "G150 needs the plane G17", where_);
  if (modal_.incremental) return error("not-supported", "G150 under G91: write G90", where_);
  if (modal_.comp == Code::comp_off)
    return error("not-supported", "G150 needs G41 or G42 in its block, and D", where_);
  const auto size = [&](const Word* word) { return word->value * length_unit(*word); };
  step_ = size(i ? i : j);
  finish_ = k ? std::abs(size(k)) : 0;
  program_ = *p;
  left_ = modal_.comp == Code::comp_left;
  levels_ = {};
  levels_.bottom = size(z);
  levels_.top = levels_.safe = levels_.reference = size(r);
  levels_.infeed = size(q);
  if (!(step_ > 0) || !(levels_.infeed > 0))
    return error("value-range", "I, J and Q of G150 are lengths above 0", where_);
  if (levels_.bottom >= levels_.reference)
    return error("value-range", "Z of G150 must lie below R", *z);
  const double factor = plane_factor();  // G51 scales the contour, not the tool
  if (!(factor > 0))
    return error("arc-scaled-unequally", "G150 in a plane that is scaled unequally", where_);
  radius_ = compensation_.register_radius(where_) / factor;
  return radius_ > 0 ||
         error("tool-unknown", "G150 needs the radius of its tool: give --tool or --tools", where_);
}

bool HaasPocket::run() {
  where_ = *block_.oneshot;
  mover_.begin(where_);
  if (contour_.is_read()) return error("not-supported", "G150 inside a contour", where_);
  Target start;
  if (!read_words() || !axes_.target(start, position_.programmed)) return false;
  if (!find_contour()) return false;
  const Code comp = std::exchange(modal_.comp, Code::comp_off);
  mover_.rapid(in_plane(basis(), start.programmed));
  mover_.rapid_height(levels_.reference);
  modal_.comp = comp;
  waits_ = true;
  return true;
}

// P is a program of that number, else the block N of this program.
bool HaasPocket::find_contour() {
  SubprogramName name;
  name.number = static_cast<long>(program_.value);
  request_ = {};
  request_.file = reader_.file();
  if (reader_.has_subprogram(name)) {
    request_ = call_of(*reader_.locate(name, program_));
    return true;
  }
  Place behind;
  if (statements_ &&
      statements_->places().find_blocks(name.number, name.number, request_.begin, behind))
    return true;
  return error(
      "subprogram-missing",
      fmt::format("neither a program O{0} nor a block N{0} is in reach (alarm 314)", name.number),
      program_);
}

void HaasPocket::end_block() {
  if (!waits_) return;
  waits_ = false;
  contour_.keep_state(block_.place());
  request_.on_start = [this] {
    contour_.begin();
    modal_.comp = Code::comp_off;
  };
  request_.on_end = [this] { end_contour(); };
  const Word where = where_;
  reader_.enter(std::move(request_), where);
}

void HaasPocket::end_program() { contour_.end_program(where_, "G150"); }

void HaasPocket::end_contour() {
  if (!contour_.end() || !contour_.has_usual_size(where_)) return;
  const Code comp = std::exchange(modal_.comp, Code::comp_off);
  pocket();
  modal_.comp = comp;
}

// Cuts in steps of Q, which leave K, then along the wall at the full depth.
bool HaasPocket::pocket() {
  const Vec2 hole = mover_.position();
  Loop loop;
  if (!cutter_.closed_loop(contour_.motions(), 1, loop)) return false;
  if ((signed_area(loop) > 0) != left_)
    return error("pocket-contour",
                 fmt::format("the contour of G150 runs {}clockwise: with {} the cutter would run "
                             "outside of it",
                             signed_area(loop) > 0 ? "counter-" : "", left_ ? "G41" : "G42"),
                 where_);
  const Region region(loop, {});
  levels_.clockwise = !left_;
  if (!cutter_.clear(region, radius_, finish_, step_, levels_, where_)) return false;
  if (finish_ > 0) {
    levels_.infeed = 0;
    if (!cutter_.follow(region, radius_, 0, levels_, where_)) return false;
  }
  mover_.rapid(hole);
  return true;
}

}  // namespace mrsim
