#include "interp/tools/compensation_words.h"

#include "core/numbers/rounding.h"
#include "core/numbers/units.h"
#include "core/words/tool_types.h"
#include "interp/path/outside_corner.h"

#include <cmath>

#include <fmt/format.h>

namespace mrsim {

bool CompensationWords::select(Code code, const Word& word) {
  Modal& m = modal_;
  if (code == Code::comp_off || code == Code::comp_left || code == Code::comp_right) {
    block_.comp_selected = code != m.comp;
    m.comp = code;
    m.comp_diameter = code != Code::comp_off && word.value != std::floor(word.value);
    if (code == Code::comp_off && is(Dialect::ngc)) {  // the next G41 needs its own D
      m.edge = 0;
      m.edge_given = false;
    }
    block_.comp_word = &word;
  } else if (code == Code::comp_suspend || code == Code::comp_resume) {
    m.comp_suspended = code == Code::comp_suspend;
  } else if (code == Code::corner_arc || code == Code::corner_intersection) {
    m.corner = code;
  } else if (code == Code::approach_normal || code == Code::approach_contour) {
    m.approach = code;
  } else {
    return false;
  }
  return true;
}

bool CompensationWords::allows_block() {
  if (!is(Dialect::ngc) || modal_.comp == Code::comp_off) return true;
  const Word& where = block_.oneshot ? *block_.oneshot : block_.words.front();
  if (modal_.plane == kPlaneYZ)
    return error("comp-plane", "radius compensation works in G17 and G18 only", where);
  if (block_.comp_before == Code::comp_off) return true;
  const auto refused = [&](const char* what) {
    return error(
        "comp-active",
        fmt::format("{} must not stand between G41 or G42 and G40: write G40 before it", what),
        where);
  };
  const Code oneshot = block_.oneshot ? block_.oneshot_code : Code::unknown;
  if (block_.comp_word) {
    if (block_.comp_selected) return refused("another side of the contour");
    warning("comp-active", "radius compensation is on already: LinuxCNC refuses that", where);
  }
  if (block_.tool_change) return refused("a change of the tool");
  if (block_.suppress_frames) return refused("G53");
  if (oneshot == Code::reference || oneshot == Code::reference_second)
    return refused("a way to a reference point");
  // G50 and G69 of a safe start end nothing where nothing is turned or scaled.
  const bool ends = (block_.ends_rotation && frames_.rotation != Frame{}) ||
                    (block_.ends_scaling && frames_.scaling != Frame{});
  const bool shifts = block_.frame_code || ends || oneshot == Code::set_position ||
                      oneshot == Code::position_reset || oneshot == Code::position_suspend ||
                      oneshot == Code::position_resume;
  return !(shifts || work_selected()) || refused("another zero");
}

bool CompensationWords::work_selected() const { return block_.has_group(Group::work); }

bool CompensationWords::begin_move(const Motion& motion, const Word& where) {
  if (modal_.comp == Code::comp_off && !started_) return true;
  const Basis b = stock_basis();
  const Vec2 travel = in_plane(b, motion.end - motion.start);
  const bool straight = motion.kind != MotionKind::arc;
  const bool moves = !straight || length(travel) > kRounding;  // a full circle moves, too
  block_.comp_moved = moves && straight;
  if (modal_.comp != Code::comp_off && !started_) {
    if (!straight && !is(Dialect::ngc))
      return error("comp-start-arc",
                   fmt::format("radius compensation must start with G0 or G1, not with an arc{}",
                               is(Dialect::fanuc) ? " (alarm 034)" : ""),
                   where);
    if (moves) started_ = true;
  }
  if (modal_.comp == Code::comp_off && moves) {
    if (!straight)
      return error("comp-end-arc",
                   fmt::format("radius compensation must end with G0 or G1, not with an arc{}",
                               is(Dialect::fanuc) ? " (alarm 034)" : ""),
                   where);
    started_ = false;
  }
  if (modal_.comp != Code::comp_off) set_radius(where);
  return true;
}

void CompensationWords::end_block(bool move_waits) {
  if (!block_.comp_selected || block_.comp_moved || !is(Dialect::sinumerik) ||
      modal_.comp == Code::comp_off || started_ || move_waits || control_.unread_end != 0)
    return;
  warning("comp-void",
          "G41/G42 counts only in a G0 or G1 block that moves in the plane: the selection is void",
          *block_.comp_word);
  modal_.comp = block_.comp_before;
}

// The D of the block. Without one, or with D0, LinuxCNC takes the number of the tool in the
// spindle.
std::string CompensationWords::edge_name() const {
  const std::string& current = control_.tool.current;
  if (!is(Dialect::ngc) || modal_.edge > 0) return fmt::format("D{}", modal_.edge);
  return "D" + (current.empty() ? "1" : current);
}

// D of LinuxCNC and Mach is the number of a tool, which need not be the one in the spindle.
const Tool* CompensationWords::tool_of_edge() const {
  const Tool* listed =
      is(Dialect::ngc) && modal_.edge > 0 ? tools_.given(fmt::format("{}", modal_.edge)) : nullptr;
  return listed ? listed : tools_.current();
}

// Finds the tool radius in force: that of the register, else that of the tool.
void CompensationWords::set_radius(const Word& where) {
  const bool is_off = options_.comp == CompRadius::off;
  was_on_ = true;
  asked_option_ = asked_option_ || is_off;
  if (is(Dialect::codesys) || modal_.comp_diameter) {  // D is the size, not a number
    radius_ = is_off ? 0 : modal_.edge_radius;
    key_.clear();
    return use_told_tip(where);
  }
  const std::string edge = edge_name();
  const std::string key = fmt::format("T{}.{}", control_.tool.current, edge);
  if (key_ == key && tool_ == control_.tool.index && changes_ == control_.register_changes) return;
  key_ = key;
  changes_ = control_.register_changes;
  tool_ = control_.tool.index;
  tip_ = {};
  const Tool* tool = tool_of_edge();
  if (modal_.edge == 0 && !is(Dialect::ngc)) {
    radius_ = 0;
    return;
  }
  const OffsetRegister* reg = is(Dialect::sinumerik) ? tools_.find_register(key) : nullptr;
  if (!reg) reg = tools_.find_register(edge);
  const bool turning = tool && is_turning(tool->type);
  const double own = !tool ? 0 : turning ? nose_radius(*tool) : tool->diameter / 2;
  const CompRadius comp =
      options_.comp == CompRadius::automatic ? tools_.commented_radius() : options_.comp;
  asked_option_ = asked_option_ || !reg;
  radius_ = reg ? reg->radius + reg->wear
                : (comp == CompRadius::wear ? 0 : own) + control_.bare_wear(edge);
  if (comp == CompRadius::off) radius_ = 0;
  if (!reg && comp == CompRadius::automatic) warn_of_register(where, tool, own);
  if (turning && !tool->tip_is_nose_centre) tip_ = tip_vector(tip_orientation(*tool), radius_);
}

// L of G41.1 and G42.1 says where the tip lies. Without it the path is that of the nose's centre.
void CompensationWords::use_told_tip(const Word& where) {
  tip_ = tip_vector(modal_.comp_tip, std::abs(radius_));
  const Tool* tool = tools_.current();
  if (!modal_.comp_diameter || !tool || !is_turning(tool->type)) return;
  const int own = tool->tip_is_nose_centre ? 0 : tip_orientation(*tool) % 9;
  if (own == modal_.comp_tip % 9) return;
  reporter_.once(
      Severity::warning, "nose-differs",
      fmt::format("L of G41.1 or G42.1 gives the tip of tool {0} LinuxCNC's orientation {1}, its "
                  "data say {2} (0: the nose's centre), which cuts here: they must agree",
                  tool->id, tip_of_linuxcnc(modal_.comp_tip), tip_of_linuxcnc(own)),
      where, tool->id + " tip");
}

// The tool table has no register, so that the radius `own` of the tool itself is used.
void CompensationWords::warn_of_register(const Word& where, const Tool* tool, double own) {
  const bool turning = tool && is_turning(tool->type);
  if ((own > 0 || turning) && modal_.edge_given) {
    const std::string edge = edge_name();
    reporter_.once(
        Severity::warning, "register-missing",
        fmt::format("{} is not in the tool table: {} radius {:g} mm is used; {}", edge,
                    tool == tools_.current() ? "the tool's own" : "tool " + tool->id + "'s", own,
                    tool && tool->type == ToolType::chamfer
                        ? fmt::format("chamfers are cut with less of it as a rule: [offsets.{}] of "
                                      "--tools tools.toml tells how much",
                                      edge)
                        : "if the program holds the path of the tool's centre (wear "
                          "compensation), say --comp wear"),
        control_.edge_word, key_);
  }
  if (own > 0 && !modal_.edge_given && !lathe() && is(Dialect::fanuc))
    reporter_.once(Severity::warning, "register-missing",
                   fmt::format("G41 and G42 stand without D, which FANUC reads as D0: nothing is "
                               "offset; as many programs mean it, the tool's own radius {:g} mm is "
                               "used; say --comp radius if that is right, else --comp off",
                               own),
                   where, key_);
}

// The way from the programmed point to the centre of the nose, in the plane (first axis Z, second
// X).
Vec2 CompensationWords::tip_vector(int tip, double radius) {
  static constexpr int kZ[] = {0, -1, 1, 1, -1, -1, 0, 1, 0, 0};
  static constexpr int kX[] = {0, -1, -1, 1, 1, 0, -1, 0, 1, 0};
  return {radius * kZ[tip], radius * kX[tip]};
}

Compensation CompensationWords::of_tool() {
  Compensation c;
  c.arcs = true;
  asked_option_ = asked_option_ || options_.comp == CompRadius::off;
  if (options_.programmed_contour || options_.comp == CompRadius::off) return c;
  c.radius = tools_.radius(modal_.edge);
  const Tool* tool = tools_.current();
  if (tool && is_turning(tool->type) && !tool->tip_is_nose_centre)
    c.tip = tip_vector(tip_orientation(*tool), c.radius);
  return c;
}

Compensation CompensationWords::for_move() const {
  Compensation c;
  if (options_.programmed_contour) return c;
  c.arcs = modal_.corner == Code::corner_arc && modal_.disc < 100;
  c.disc = modal_.disc / 100;
  c.two_points = is(Dialect::fanuc);
  c.stepwise = is(Dialect::ngc);
  c.sharpest = is(Dialect::fanuc)                  ? kPi / 2
               : modal_.corner == Code::corner_arc ? kSharpestDisc
                                                   : radians(100);
  c.around = modal_.approach == Code::approach_contour;
  if (modal_.comp == Code::comp_off) return c;
  c.side = (modal_.comp == Code::comp_left) != control_.tool.below ? 1 : -1;
  c.suspended = modal_.comp_suspended;
  c.radius = radius_ + modal_.offn;
  if (c.radius < 0) {  // a negative radius means the other side
    c.side = -c.side;
    c.radius = -c.radius;
  }
  c.tip = tip_;
  if (c.radius == 0) c.side = 0;
  return c;
}

}  // namespace mrsim
