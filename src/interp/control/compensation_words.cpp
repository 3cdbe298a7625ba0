// Radius compensation as the program switches it: start, end, radius in force.
#include "core/units.h"
#include "interp/engine.h"

#include <fmt/format.h>

namespace mrsim {

// G40 G41 G42 take effect with a straight move in the plane.
bool Engine::start_compensation(const Motion& motion, const Word& where) {
  if (modal_.comp == Code::comp_off && !comp_started_) return true;
  const Basis b = stock_basis();
  const Vec2 travel = in_plane(b, motion.end - motion.start);
  const bool moves = length(travel) > 1e-9;
  const bool straight = motion.kind != MotionKind::arc;
  comp_moved_ = moves && straight;
  if (modal_.comp != Code::comp_off && !comp_started_) {
    if (!straight)
      return error("comp-start-arc",
                   fmt::format("radius compensation must start with G0 or G1, not with an arc{}",
                               is(Dialect::fanuc) ? " (alarm 034)" : ""),
                   where);
    if (moves) comp_started_ = true;
  }
  if (modal_.comp == Code::comp_off && moves) {
    if (!straight)
      return error("comp-end-arc",
                   fmt::format("radius compensation must end with G0 or G1, not with an arc{}",
                               is(Dialect::fanuc) ? " (alarm 034)" : ""),
                   where);
    comp_started_ = false;
  }
  if (modal_.comp != Code::comp_off) set_comp_radius();
  return true;
}

// SINUMERIK: G41 and G42 count only in a G0 or G1 block with travel in the plane.
void Engine::check_comp_selection(Code before) {
  if (!comp_selected_ || comp_moved_ || !is(Dialect::sinumerik) || modal_.comp == Code::comp_off ||
      comp_started_ || pending_angle_.active)
    return;
  warning("comp-void",
          "G41/G42 counts only in a G0 or G1 block that moves in the plane: the selection is void",
          comp_word_);
  modal_.comp = before;
}

// The tool radius in force, from the register or the tool.
void Engine::set_comp_radius() {
  const std::string edge = fmt::format("D{}", modal_.edge);
  const std::string key = fmt::format("T{}.{}", tool_.current, edge);
  if (comp_key_ == key && comp_tool_ == tool_.index) return;
  comp_key_ = key;
  comp_tool_ = tool_.index;
  comp_tip_ = {};
  const Tool* tool =
      tool_.index >= 0 ? &program_.tools[static_cast<std::size_t>(tool_.index)] : nullptr;
  if (is(Dialect::codesys)) {
    comp_radius_ = modal_.edge_radius;
    comp_key_.clear();
    return;
  }
  if (modal_.edge == 0) {
    comp_radius_ = 0;
    return;
  }
  const OffsetRegister* reg = is(Dialect::sinumerik) ? find_register(key) : nullptr;
  if (!reg) reg = find_register(edge);
  const bool turning = tool && is_turning(tool->type);
  const double own = !tool ? 0 : turning ? tool->nose_radius : tool->diameter / 2;
  comp_radius_ = reg ? reg->radius + reg->wear : own;
  if (!reg && modal_.edge_given)
    note_once("register-missing",
              fmt::format("{} is not in the tool table: the tool's own radius {:g} mm is used",
                          edge, own),
              edge_word_, key);
  if (turning && !tool->tip_is_nose_centre) comp_tip_ = tip_vector(*tool);
}

// From the programmed point to the nose centre, in the plane (first axis Z, second X).
Vec2 Engine::tip_vector(const Tool& tool) const {
  static constexpr int kZ[] = {0, -1, 1, 1, -1, -1, 0, 1, 0, 0};
  static constexpr int kX[] = {0, -1, -1, 1, 1, 0, -1, 0, 1, 0};
  const int tip = tool.tip >= 1 && tool.tip <= 9 ? tool.tip : tool.left_hand ? 4 : 3;
  const double r = comp_radius_;
  return {r * kZ[tip], r * kX[tip]};
}

// What radius compensation needs to know about this move.
Compensation Engine::compensation() const {
  Compensation c;
  if (options_.programmed_contour) return c;
  c.arcs = modal_.corner == Code::corner_arc && modal_.disc < 100;
  c.disc = modal_.disc / 100;
  c.two_points = is(Dialect::fanuc);
  c.sharpest = is(Dialect::fanuc)                  ? kPi / 2
               : modal_.corner == Code::corner_arc ? kSharpestDisc
                                                   : radians(100);
  c.around = modal_.approach == Code::approach_contour;
  if (modal_.comp == Code::comp_off) return c;
  c.side = modal_.comp == Code::comp_left ? 1 : -1;
  c.suspended = modal_.comp_suspended;
  c.radius = comp_radius_;
  if (c.radius < 0) {  // a negative radius is the other side
    c.side = -c.side;
    c.radius = -c.radius;
  }
  c.tip = comp_tip_;
  if (c.radius == 0) c.side = 0;
  return c;
}

}  // namespace mrsim
