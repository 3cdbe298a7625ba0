#include "interp/moves/motion_emitter.h"

#include "core/numbers/rounding.h"
#include "core/numbers/units.h"
#include "core/text/text_io.h"
#include "interp/tools/tool_changer.h"
#include "interp/tools/tool_text.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr std::size_t kAllMoves = static_cast<std::size_t>(-1);
constexpr double kBeyondAxis = 2;  // mm: faces are cut no farther beyond the axis
constexpr double kOnAxis = 0.05;   // mm: a drill that runs out by less still drills on the axis

}  // namespace

MotionEmitter::MotionEmitter(Control& control, CompensationWords& compensation, MotionSink& sink)
    : ControlPart(control),
      words_(compensation),
      sink_(sink),
      travel_(control),
      corners_(control.reporter, [this](const PathMove& m) { compensation_.push(m); }),
      compensation_(control.reporter, [this](const PathMove& m) { give(m); }),
      captured_corners_(control.reporter,
                        [this](const PathMove& m) { captured_->push_back(m.motion); }) {}

void MotionEmitter::capture(std::vector<Motion>* contour) {
  if (!contour) captured_corners_.flush();
  captured_ = contour;
}

void MotionEmitter::flush() {
  corners_.flush();
  compensation_.flush();
  give_events(kAllMoves);
  travel_.finish();
}

void MotionEmitter::dwell(double seconds) {
  if (!(seconds > 0) || !std::isfinite(seconds)) return;
  Event stays;
  stays.seconds = seconds;
  event(std::move(stays));
}

void MotionEmitter::event(Event event) {
  if (captured_) return;
  event.tool = control_.tool.index;
  event.file = block_.file;
  event.line = block_.line_number;
  event.call = block_.call;
  if (idle_) return sink_.event(event);
  if (!events_.empty() && events_.back().moves == held_moves_ && events_.back().mark == 0 &&
      joins(event, events_.back().event))
    return;
  events_.push_back({held_moves_, std::move(event)});
}

void MotionEmitter::mark() {
  const int number =
      captured_ ? 0 : sink_.mark_before(block_.file, block_.line_number, block_.call);
  if (number == 0) return;
  if (idle_) return sink_.mark(number);
  events_.push_back({held_moves_, {}, number});
}

void MotionEmitter::change_tool() {
  const ToolState& tool = control_.tool;
  if (captured_ || !tool.chosen || (tool_told_ && told_tool_ == tool.shown)) return;
  tool_told_ = true;
  told_tool_ = tool.shown;
  Event change;
  change.kind = EventKind::tool_change;
  change.name = tool.shown;
  event(std::move(change));
}

// Emits a move. Events that were programmed before it go out first.
void MotionEmitter::give(const PathMove& move) {
  if (!events_.empty()) give_events(move.order);
  send(move.motion, move.checked_axes);
}

void MotionEmitter::send(const Motion& motion, AxisSet checked_axes) {
  if (!checked_axes.empty()) travel_.check(motion, checked_axes);
  sink_.motion(motion);
}

void MotionEmitter::give_events(std::size_t order) {
  std::size_t given = 0;
  for (; given < events_.size() && events_[given].moves < order; ++given)
    if (const HeldEvent& held = events_[given]; held.mark != 0)
      sink_.mark(held.mark);
    else
      sink_.event(held.event);
  events_.erase(events_.begin(), events_.begin() + static_cast<std::ptrdiff_t>(given));
}

void MotionEmitter::emit(const Motion& motion) {
  const bool hole = modal_.drill.number != 0;  // ,R1 beside G84 is a rigid tap
  emit(motion, hole || motion.kind == MotionKind::rapid ? CornerSpec{} : corner_spec());
}

void MotionEmitter::emit(Motion motion, const CornerSpec& corner) {
  position_.new_tool = false;
  position_.told_axes = {};
  ++made_;
  if (captured_) {
    if (captured_->size() < kMostCaptured) captured_corners_.push(path_move(motion, corner));
    return;
  }
  cut_end_.see(motion, lathe());
  change_tool();
  if (lathe()) turn_to_plus(motion);
  check_length_mode(motion);
  if (motion.kind != MotionKind::rapid) note_cut(motion);
  if (lathe()) refuse_undescribed_tool(motion);
  motion.start.z += last_length_;
  motion.end.z += modal_.length_offset;
  motion.center.z += modal_.length_offset;
  last_length_ = modal_.length_offset;
  if (motion.kind != MotionKind::arc && distance(motion.start, motion.end) <= kRounding)
    return warn_void_corner(corner);
  const AxisSet checked_axes = travel_.axes(motion);
  const bool plain = corner.kind == CornerSpec::Kind::none && modal_.comp == Code::comp_off;
  if (plain && idle_) return send(motion, checked_axes);
  PathMove path = path_move(motion, corner);
  path.comp = words_.for_move();
  path.checked_axes = checked_axes;
  path.order = ++held_moves_;
  corners_.push(path);
  idle_ = corners_.idle() && compensation_.idle();
  if (idle_) give_events(kAllMoves);
}

PathMove MotionEmitter::path_move(const Motion& motion, const CornerSpec& corner) const {
  PathMove path;
  path.motion = motion;
  path.basis = stock_basis();
  path.corner = corner;
  path.block = block_.number;
  return path;
}

// Notes what a cut shows of its program and its tool, and sets the tool of the motion.
void MotionEmitter::note_cut(Motion& motion) {
  note_zero();
  check_length();
  farthest_cut_ = std::max(
      {farthest_cut_, std::abs(motion.end.x), std::abs(motion.end.y), std::abs(motion.end.z)});
  motion.tool = control_.tool.index;
  if (lathe() && modal_.surface_speed)
    slowest_turn_ = std::min(
        slowest_turn_, modal_.cutting_speed * 1000 /
                           (2 * kPi * std::max(std::abs(motion.start.x), std::abs(motion.end.x))));
  if (lathe()) refuse_live_tool(motion);
  if (position_.known == kAllAxes)
    unknown_starts_ = 0;
  else
    warn_unknown_start(motion);
}

void MotionEmitter::warn_void_corner(const CornerSpec& corner) {
  if (corner.kind == CornerSpec::Kind::none) return;
  for (const Address a : {Address::rnd, Address::chr, Address::chf})
    if (const Word* word = find(a))
      warning("corner-void", "the block moves nothing: no rounding or chamfer is inserted", *word);
}

// An insert that works at X below 0, on the other side of the axis, points to +X. Turned about the
// axis by half a turn it cuts the same as a tool at X above 0, so that inserts are needed for one
// side only.
void MotionEmitter::turn_to_plus(Motion& motion) {
  ToolState& tool = control_.tool;
  const bool before = tool.below;
  if (motion.end.x > kBeyondAxis)
    tool.below = false;
  else if (motion.kind == MotionKind::rapid && motion.end.x < -kBeyondAxis && may_stand_below())
    tool.below = true;
  const bool whole = motion.kind == MotionKind::arc;
  const bool turned =
      before || (tool.below && motion.start.x < 0);  // at the place where another tool has ended
  if (whole ? tool.below : turned) motion.start.x = -motion.start.x;
  if (!tool.below) return;
  motion.end.x = -motion.end.x;
  motion.center.x = -motion.center.x;
  motion.sweep = -motion.sweep;
  if (!before)
    note_once("x-below-zero",
              fmt::format("tool {} works at X below 0: its moves are read as those at X above 0, "
                          "which cut the same",
                          tool.current.empty() ? "(none named)" : tool.current),
              block_.words.front(), tool.current);
}

// The orientation of a tip in the tool table is that on the side where the tool works.
bool MotionEmitter::may_stand_below() const {
  const ToolState& state = control_.tool;
  if (state.index >= 0 && !is_turning(program_.tools[static_cast<std::size_t>(state.index)].type))
    return false;
  const std::vector<Tool>& given = options_.table.tools;
  return std::none_of(given.begin(), given.end(), [&](const Tool& tool) {
    return (tool.id == state.current || tool.id.empty()) && tool.tip > 0;
  });
}

// On a lathe TRANS and G52 shift the zero from the chuck to the face of the part; on a mill they
// shift it to a place on the part.
void MotionEmitter::note_zero() {
  double height = frames_.work.z + frames_.position_shift.z;
  if (lathe() && frames_.program.plain) height += frames_.program.shift.z + frames_.local.z;
  program_.zero_height = control_.cuts == 0 ? height : std::max(program_.zero_height, height);
  ++control_.cuts;
}

// The number (H or D) of the length in force, 0: none. On a lathe it is the offset of T0101.
double MotionEmitter::length_number() const {
  if (is(Dialect::sinumerik)) return modal_.edge;
  if (lathe()) return std::fmod(std::max(0.0, control_.tool.written), 100);
  if (modal_.length == Code::length_dynamic || modal_.length == Code::length_add)
    return SetLengths::kDynamic;
  return modal_.length == Code::length_off ? 0 : modal_.length_number;
}

// A loop that makes a tool longer cuts deeper each time on the machine, but always at one depth
// here.
void MotionEmitter::check_length() {
  const bool siemens = is(Dialect::sinumerik);
  const double number = length_number();
  const int tool = control_.tool.index;
  if (number == 0 || !control_.lengths.unmet(tool, number)) return;
  SetLengths::Register which{0, number};
  const std::string& id = control_.tool.current;
  if (siemens) which.first = parse_number(id).value_or(-1);
  for (const SetLengths::Setting& set : control_.lengths.cut(tool, number, id, which))
    reporter_.once_at(
        Severity::error, "not-supported",
        fmt::format("{0} gives a tool that has cut another length, with which it cuts again in "
                    "line {1}, and positions are read as those of the tool's tip: write the "
                    "difference into {3}, or shift the zero by {2} {3}",
                    set.name, block_.line_number, siemens ? "TRANS" : "G52", set.axis),
        set.at, fmt::format("length {} {}", set.at.file, set.at.line));
}

// Reports cuts of a tool with other lengths: G49 between cuts, or G44 or G43.2 behind G43.
void MotionEmitter::check_length_mode(const Motion& motion) {
  if (lathe() || is(Dialect::sinumerik) || is(Dialect::codesys) || block_.suppress_frames ||
      modal_.length_told)
    return;
  const bool counts = modal_.length != Code::length_off && length_number() != 0;
  if (!length_switch_.contradicts(control_.tool.index, counts ? static_cast<int>(modal_.length) : 0,
                                  motion, modal_.incremental))
    return;
  reporter_.once_at(
      Severity::error, "not-supported",
      "the tool cuts here by another length than before (G43, G44 or G49): how far "
      "apart the two lie is not known; write G43 before each of its cuts, or give its "
      "length by [offsets.H1] of --tools tools.toml",
      motion, "length mode " + control_.tool.current);
}

// A cut from an unknown place is not swept. If there is only one, it is the way to the first point.
void MotionEmitter::warn_unknown_start(const Motion& motion) {
  if (++unknown_starts_ != 2 || reporter_.errors() > 0) return;
  std::string axes;
  for (int i = 0; i < 3; ++i)
    if (!position_.known.has(i)) axes += fmt::format("{}{}", axes.empty() ? "" : " and ", "XYZ"[i]);
  reporter_.once_at(Severity::warning, "start-unknown",
                    fmt::format("cuts are left out here, because where {} {} was never given: say "
                                "--start X,Y,Z",
                                axes, axes.size() > 1 ? "are" : "is"),
                    motion, "start");
}

// A tool without data is taken to have a usual insert. Where its motions show that it is another
// tool, that insert would cut another part; so would one for the outside, "T6 CCMT 32.5", in a
// bore.
void MotionEmitter::refuse_undescribed_tool(const Motion& motion) {
  const UndescribedTool::Kind kind =
      undescribed_.told_by(motion, program_.zero_height, block_.turn_cycle == 72);
  if (kind.does.empty() || motion.tool < 0) return;
  const Tool& tool = program_.tools[static_cast<std::size_t>(motion.tool)];
  const bool bare = is_turning(tool.type) && tool.origin.starts_with(kNoToolData);
  constexpr double kFace = 1;  // mm: faces are cut above this depth
  const bool outside = kind.bores && motion.start.z < program_.zero_height - kFace &&
                       tool.type == ToolType::turning && tool.origin.starts_with("comment");
  if (!bare && !outside) return;
  reporter_.once_at(Severity::error, "tool-unknown",
                    fmt::format("tool {0} {1}, but {4}: give --tool {0}={2}, or say in a comment "
                                "what it is (T{0} {3})",
                                tool.id, kind.does, kind.option, kind.comment,
                                bare ? "there are no data for it" : "its comment names no such"),
                    control_.tool.place, "drill:" + tool.id);
}

// A cutter that rotates leaves a body of revolution only on the axis.
void MotionEmitter::refuse_live_tool(const Motion& motion) {
  if (motion.tool < 0) return;
  const Tool& tool = program_.tools[static_cast<std::size_t>(motion.tool)];
  if (is_turning(tool.type) || tool.diameter == 0)
    return;  // a tool without data was reported at its T word
  const double beside =
      std::max(motion.assumed_start ? 0.0 : std::abs(motion.start.x), std::abs(motion.end.x));
  if (beside <= kOnAxis) return;
  reporter_.once_at(
      Severity::error, "live-tool",
      fmt::format("{}{} cuts {:.4g} mm beside the axis of a lathe: a live tool is not supported "
                  "yet; for a bar that bores give --tool {}boring:..., for a mill --machine mill",
                  tool.id.empty() ? "" : fmt::format("tool {}: ", tool.id), tool_summary(tool),
                  beside, tool.id.empty() ? "" : tool.id + "="),
      motion, "live-tool:" + tool.id);
}

// FANUC lathes write corners without a comma: R beside an axis or an angle; C, or I and K in the
// direction of the next block, beside one axis alone. In cycles these words mean other things.
void MotionEmitter::turned_corner(const Word*& round, const Word*& leg) {
  if (modal_.turn.number != 0 || modal_.drill.number != 0 || block_.turn_cycle != 0) return;
  const bool x = peek('X') || peek('U'), z = peek('Z') || peek('W');
  if (x || z || find(angle_address())) round = take('R');
  if (x == z) return;
  leg = take('C');
  if (!leg) leg = take(z ? 'I' : 'K');
}

// A scale makes the shape larger as a whole, its corners, too. ("all X, Y, Z, I, J, K, or R values
// addressing machine motion are multiplied", Haas says of G51.)
void MotionEmitter::scale_corner(CornerSpec& spec) {
  const double factor = plane_factor();
  spec.size *= factor;
  if (factor > 0) return;
  spec.kind = CornerSpec::Kind::none;
  error("arc-scaled-unequally",
        "the frame scales the plane unequally: the rounding or chamfer would lose its form",
        block_.words.front());
}

CornerSpec MotionEmitter::corner_spec() {
  CornerSpec spec;
  const Word* round = take(Address::rnd);
  const Word* leg = take(Address::chr);
  const Word* cut = take(Address::chf);
  const Word* feed = take(Address::frc);
  if (lathe() && is(Dialect::fanuc) && current_motion() == Code::line && !round && !leg)
    turned_corner(round, leg);
  using Kind = CornerSpec::Kind;
  const auto size = [&](const Word& word) {  // I and K have the sign of the direction
    const bool directed = word.address < Address::function;
    return (directed ? std::abs(word.value) : word.value) * length_unit(word);
  };
  if (round) {
    spec = {Kind::round, size(*round), 0};
  } else if (leg) {
    spec = {Kind::leg, size(*leg), 0};
  } else if (cut) {
    spec = {Kind::cut, cut->value * scale(), 0};
  } else if (modal_.rndm > 0) {
    spec = {Kind::round, modal_.rndm, 0, true};
  }
  for (const Word* word : {round, leg, cut})
    if (word && word->value < 0 && word->address >= Address::function)
      warning("corner-void", "the size is negative: no rounding or chamfer is inserted", *word);
  if (spec.size <= 0) spec.kind = Kind::none;
  if (spec.kind != Kind::none) scale_corner(spec);
  spec.feed = feed ? feed->value * feed_scale() : modal_.frcm;
  spec.next = is(Dialect::fanuc);
  return spec;
}

}  // namespace mrsim
