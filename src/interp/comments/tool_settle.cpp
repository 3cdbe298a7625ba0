#include "interp/comments/tool_settle.h"

#include "core/numbers/units.h"
#include "interp/comments/insert_code.h"
#include "interp/comments/tool_sizes.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

class Settler {
 public:
  Settler(const ToolFacts& facts, ToolHint& hint) : facts_(facts), hint_(hint) {}

  void settle() {
    static_cast<PlainFacts&>(hint_) = facts_;
    hint_.upkeep = facts_.upkeep && facts_.id.empty();
    hint_.size_of_work = facts_.size_of_work && !facts_.kind() && facts_.named.empty();
    if (hint_.angle_line) return;
    if (facts_.several_ids) doubt("names several tools");
    if (!facts_.split_size.empty()) doubt(fmt::format("can be read as size {}", facts_.split_size));
    if (facts_.alternatives && facts_.kind()) doubt("names two sizes");
    angles_ = settle_sizes(facts_, hint_);
    settle_padded_radius();
    settle_type();
    settle_thread();
    if (hint_.type && !is_turning(*hint_.type)) {
      settle_mill();
      settle_angle();
    }
    drop_unclaimed();
  }

 private:
  const ToolKind* kind() const { return facts_.kind(); }
  bool trade_is(ToolTrade trade) const { return facts_.trade_is(trade); }
  bool pointed() const;
  void doubt(std::string why) {
    if (hint_.doubt.empty()) hint_.doubt = std::move(why);
  }

  void settle_type();
  void take_kind(const ToolKind& kind);
  void settle_work(const ToolKind& kind);
  void settle_width_of_work();
  void settle_blade_corner();
  void settle_rivals();
  void settle_turning();
  bool may_be_blade() const;
  void take_lead_angle();
  void settle_nose();
  void settle_thread();
  void settle_mill();
  bool has_usual_corner() const;
  void take_nose_of_work();
  ToolLength bare_nose() const;
  void settle_padded_radius();
  void settle_round_insert();
  void settle_angle();
  void set_angle(double degrees);
  void drop_unclaimed();

  const ToolFacts& facts_;
  ToolHint& hint_;
  std::vector<double> angles_;  ///< degrees
};

bool Settler::pointed() const {
  using enum ToolTrade;
  return trade_is(twist_drill) || trade_is(spot_drill) || trade_is(center_drill) ||
         trade_is(chamfer_mill) || trade_is(countersink) || trade_is(vee);
}

// Whether the first angle is a usual corner of an insert: "OD ROUGH R0.8 80 DEG".
bool Settler::has_usual_corner() const {
  constexpr double kUsual[] = {35, 55, 80};
  return !angles_.empty() &&
         std::find(std::begin(kUsual), std::end(kUsual), angles_.front()) != std::end(kUsual);
}

// The kind of tool that the comment names, and what makes it doubtful.
void Settler::take_kind(const ToolKind& kind) {
  hint_.type = facts_.fusion_slot ? ToolType::tslot : kind.type;
  hint_.trade = kind.trade;
  hint_.firm = kind.firm;
  if (kind.trade == ToolTrade::rounding || kind.trade == ToolTrade::shaped)
    doubt("names a kind of tool that needs more data");
  if (kind.trade == ToolTrade::no_cutter) doubt("names no cutter");
  const bool threaded = trade_is(ToolTrade::tap) && facts_.thread;
  if (threaded && !*facts_.thread) doubt("names a pipe thread, whose size is not its diameter");
  if (threaded && facts_.enlarged_thread)
    doubt("names a thread for wire inserts, whose tap is larger");
  settle_rivals();
  if (facts_.round_work && !facts_.named.empty())
    doubt("can be read as the diameter of the tool or of what it mills");
}

void Settler::settle_type() {
  const bool threaded = trade_is(ToolTrade::tap) && facts_.thread;
  const bool point = trade_is(ToolTrade::twist_drill) && !angles_.empty();  // "DRILL 118"
  const bool data =
      !hint_.diameters.empty() || hint_.width || hint_.nose || hint_.corner || threaded || point;
  const ToolKind* k = kind();
  const bool disc_data = hint_.width && !hint_.diameters.empty();
  const bool by_data =
      data && k && !is_turning(k->type) && (k->trade != ToolTrade::disc || disc_data);
  if (k && (k->firm || hint_.names_tool || by_data)) {
    take_kind(*k);
  } else if (!k && facts_.pair && !hint_.diameters.empty() && !facts_.insert) {
    hint_.type = ToolType::endmill;  // "D12R2"
  }
  if (facts_.slot_mill && disc_data && hint_.width.mm(1) < hint_.diameters.front().mm(1) &&
      hint_.type.value_or(ToolType::endmill) == ToolType::endmill) {
    hint_.type = ToolType::tslot;
    hint_.trade = ToolTrade::disc;
  }
  // The blade is what cuts, whatever the words call the work. A mill may hold such an insert, too.
  if (facts_.blade && !facts_.insert && (!hint_.type || is_turning(*hint_.type)) &&
      !(k && k->firm && !is_turning(k->type)))
    hint_.type = facts_.blade->type;
  const bool has_nose = facts_.nose && hint_.diameters.empty();  // "80 DEG .031 TNR"
  if (!k && !hint_.type && (facts_.turned_side || has_nose) && has_usual_corner())
    hint_.type = ToolType::turning;
  else if (!k && !facts_.insert && !facts_.blade && (!facts_.angles.empty() || facts_.bare_angle))
    doubt("names an angle, and no kind of tool");
  else if (!k && !hint_.type && facts_.shaped && !hint_.diameters.empty() && !facts_.turned_side)
    doubt("names a shape, and no kind of tool");
  if (k && !hint_.type && is_turning(k->type)) settle_work(*k);
  if (facts_.round_insert) settle_round_insert();
  const bool radius_of_tool = hint_.names_tool && hint_.diameters.empty();  // "T0101 R0.8"
  if (!hint_.type && (facts_.turned_side || facts_.bores || radius_of_tool)) take_nose_of_work();
  if (facts_.insert || (hint_.type && is_turning(*hint_.type))) settle_turning();
}

// A radius beside words for the work is the nose of the insert if inserts have a nose of that value
// in mm or inches: "OD ROUGH R0.8", "ROUGH TURN .031R", "FINISH BORE R0.4".
void Settler::take_nose_of_work() {
  ToolLength nose = hint_.nose ? hint_.nose : hint_.corner ? hint_.corner : bare_nose();
  if (!nose || (kind() && (!is_turning(kind()->type) || kind()->type == ToolType::threading)))
    return;
  const double unit = usual_nose_unit(nose.value);
  if (unit == 0) return;
  if (nose.unit == 0) nose.unit = unit;
  hint_.nose = nose;
  if (!hint_.operation) hint_.operation = ToolType::turning;
}

// A number without a name that has the value of a nose radius: "80 DEG ROUGH .031", "CNMG .8".
ToolLength Settler::bare_nose() const {
  const bool one = facts_.bare.size() == 1 && usual_nose_unit(facts_.bare.front().value) > 0;
  return one && !facts_.bores ? facts_.bare.front() : ToolLength{};
}

// "R05" may be 5, or 0.5 that has lost its point: a doubt. Of an insert "R08" is 0.8.
void Settler::settle_padded_radius() {
  if (!facts_.padded_radius) return;
  hint_.padded_radius = true;
  ToolLength tenth = hint_.corner;
  tenth.value /= 10;
  const bool turns = facts_.insert || facts_.turned_side || (kind() && is_turning(kind()->type));
  if (turns && usual_nose_unit(tenth.value) > 0)
    hint_.corner = tenth;
  else
    doubt(fmt::format("can be read as radius {:g} or {:g}", hint_.corner.value, tenth.value));
}

// Settles a lathe's round insert: "BUTTON TOOL R4", "ROUND INSERT DIA 8".
void Settler::settle_round_insert() {
  ToolLength nose = hint_.nose ? hint_.nose : hint_.corner;
  if (!facts_.named.empty() && !nose) (nose = facts_.named.front()).value /= 2;
  if (kind() || facts_.insert || facts_.pair) return;
  if (!nose) doubt("gives no radius of its round insert");
  hint_.type = ToolType::turning;
  hint_.insert = "R";
  hint_.nose = nose;
  hint_.corner = {};
  hint_.diameters.clear();
}

// Settles words of turning: "80 DEG DIAMOND" is an insert. "GROOVE 3MM", ".093 GROOVE" name the
// work, and their size may be that of the blade.
void Settler::settle_work(const ToolKind& k) {
  if (k.type == ToolType::turning && has_usual_corner()) {
    hint_.type = k.type;
    hint_.trade = k.trade;
    return;
  }
  if (k.type == ToolType::threading && facts_.turns_before) return;
  hint_.operation = k.type;
  settle_width_of_work();
  if (k.type == ToolType::grooving && hint_.width) settle_blade_corner();
}

void Settler::settle_width_of_work() {
  if (hint_.width || hint_.diameters.empty()) return;
  const bool before = !facts_.before_kind.empty() && facts_.before_kind.front().sizes[0].decimals;
  const ToolLength& size = hint_.diameters.front();
  if (size.unit > 0 || size.fraction || before) hint_.width = size;
}

// The corners of a blade: "GROOVE 4MM R2", "FULL RADIUS GROOVE 4MM".
void Settler::settle_blade_corner() {
  if (!hint_.nose) hint_.nose = hint_.corner;
  hint_.corner = {};
  if (facts_.full_radius) (hint_.nose = hint_.width).value /= 2;
}

// Two kinds in one comment, "6MM DRILL - CHAMFER EDGES": one is the tool, the other may be the
// work. Words that name nothing but a tool are certain, but "ENDMILL, CHAMFER 45 DEG" may be a
// chamfer mill.
void Settler::settle_rivals() {
  const ToolKind& k = facts_.kinds.front();
  for (const ToolKind& rival : facts_.kinds) {
    if (same_trade(k, rival) || (is_turning(rival.type) && !rival.firm)) continue;
    const bool angular = same_trade(rival, {ToolType::chamfer, ToolTrade::chamfer_mill}) &&
                         !facts_.angles.empty() && !pointed();
    if (!rival.firm && k.firm && !angular) continue;
    hint_.rivals = true;
    return doubt("names more than one kind of tool");
  }
}

void Settler::settle_turning() {
  if (facts_.insert) {
    const InsertCode& code = *facts_.insert;
    hint_.insert = code.shape;
    hint_.insert_angle = radians(code.angle);
    hint_.lead_angle = radians(code.lead_angle);
    hint_.edge_length = code.has_size ? code.edge_length : 0;
    if (!hint_.type) hint_.type = ToolType::turning;
    if (!code.other.empty())
      doubt(code.shape == code.other
                ? fmt::format("names two inserts {} of different noses", code.shape)
                : fmt::format("names two inserts, {} and {}", code.shape, code.other));
    std::erase(angles_, code.angle);
    take_lead_angle();
    if (code.angle > 0 && !angles_.empty())
      doubt(fmt::format("says {:g} degrees, but {} has {:g}", angles_.front(), code.shape,
                        code.angle));
  } else {
    take_lead_angle();
    if (facts_.blade && facts_.blade->angle > 0)
      hint_.insert_angle = radians(facts_.blade->angle);
    else if (!angles_.empty() && angles_.front() < 180)
      hint_.insert_angle = radians(angles_.front());
  }
  if (hint_.type == ToolType::grooving && !hint_.width && !hint_.diameters.empty())
    hint_.width = hint_.diameters.front();
  settle_nose();
  if (hint_.type == ToolType::turning && may_be_blade())
    doubt("tells a width as blades have, and no insert");
  if (hint_.type == ToolType::turning && facts_.inside) hint_.type = ToolType::boring;
  hint_.left_hand = facts_.left_hand || (facts_.blade && facts_.blade->left_hand);
  if (hint_.type != ToolType::boring) hint_.diameters.clear();  // on a mill it is the bore's
}

// Whether the only size is one of a few mm, as blades are wide, "CUCHILLA 3MM", and nothing tells
// of an insert.
bool Settler::may_be_blade() const {
  constexpr double kThinnest = 1, kWidest = 6;  // mm
  if (!kind() || !kind()->firm || facts_.insert || hint_.insert_angle > 0 || hint_.nose ||
      hint_.diameters.size() != 1)
    return false;
  const ToolLength& size = hint_.diameters.front();
  return size.unit == 1 && size.value >= kThinnest && size.value <= kWidest;
}

// Settles the profile of a thread: a point of 60 degrees, unless the comment says otherwise.
void Settler::settle_thread() {
  const bool turns = hint_.type == ToolType::turning || hint_.type == ToolType::boring;
  if (turns && facts_.back_turn)
    doubt("names a tool that turns backwards, and does not say its hand, hand=left or right");
  if (hint_.type != ToolType::threading && hint_.operation != ToolType::threading) return;
  if (facts_.flat_thread) doubt("names a thread whose teeth end in no point");
  if (facts_.whitworth && hint_.insert_angle == 0) hint_.insert_angle = radians(55);
}

// Takes an angle that no insert has as its corner, but holders have as their lead: "DNMG 150608 93
// DEG", "SNMG 120412 45 DEG".
void Settler::take_lead_angle() {
  constexpr double kLeads[] = {45, 62.5, 72.5, 75, 91, 93, 95, 107.5, 117.5};
  const auto at = std::find_if(angles_.begin(), angles_.end(), [&](double angle) {
    return std::find(std::begin(kLeads), std::end(kLeads), angle) != std::end(kLeads);
  });
  if (at == angles_.end()) return;
  hint_.lead_angle = radians(*at);
  angles_.erase(at);
}

void Settler::settle_nose() {
  if (!hint_.nose) hint_.nose = hint_.corner;
  if (!hint_.nose && hint_.type == ToolType::turning) hint_.nose = bare_nose();
  if (hint_.nose.unit == 0 && hint_.insert != "R")
    hint_.nose.unit = usual_nose_unit(hint_.nose.value);
  hint_.corner = {};
  if (facts_.blade && facts_.blade->nose > 0) hint_.nose = {facts_.blade->nose, 1, false};
  if (facts_.full_radius && hint_.type == ToolType::grooving) (hint_.nose = hint_.width).value /= 2;
  if (!facts_.insert || !facts_.insert->has_size) return;
  const ToolLength coded{facts_.insert->nose_radius, 1, false};
  const double said = hint_.nose.value * (hint_.nose.unit > 0 ? hint_.nose.unit : 1);
  const bool same =
      std::abs(said - coded.value) < 0.05 || std::abs(said * kMmPerInch - coded.value) < 0.05;
  if (hint_.nose && !same)
    doubt(fmt::format("says nose radius {:g}, but the code of the insert {:.3g} mm", said,
                      coded.value));
  hint_.nose = coded;
}

// Settles what only mills have. "R3 BALL" has the diameter 6.
void Settler::settle_mill() {
  if (trade_is(ToolTrade::face_mill) && facts_.fusion && facts_.taper > 0) {  // D: of the tip
    hint_.type = ToolType::taper;
    hint_.trade = ToolTrade::cone_mill;
    hint_.taper_angle = radians(facts_.taper);
    return;
  }
  if (facts_.tapered && (trade_is(ToolTrade::mill) || trade_is(ToolTrade::face_mill)))
    doubt("names a tapered mill, whose shape it does not tell");
  constexpr double kUpright = 85;  // degrees
  const bool upright = trade_is(ToolTrade::face_mill) ||
                       (trade_is(ToolTrade::mill) && hint_.type == ToolType::endmill);
  if (upright && !facts_.helix && !angles_.empty() && angles_.front() < kUpright)
    doubt(
        fmt::format("names a {} of {:g} degrees: an endmill cuts upright walls, a taper has its "
                    "angle to the axis",
                    trade_is(ToolTrade::face_mill) ? "face mill" : "mill", angles_.front()));
  if (hint_.type == ToolType::ballmill && !angles_.empty() && angles_.front() > 180)
    hint_.type = ToolType::lollipop;  // "270 DEG BALL"
  const bool ball = hint_.type == ToolType::ballmill || hint_.type == ToolType::lollipop ||
                    trade_is(ToolTrade::cone_ball);
  if (ball && hint_.corner && hint_.diameters.empty()) {
    hint_.diameters.push_back(hint_.corner);
    hint_.diameters.front().value *= 2;
  }
  if (hint_.type == ToolType::endmill && hint_.corner && !trade_is(ToolTrade::tap))
    hint_.type = ToolType::bullmill;
}

void Settler::settle_angle() {
  using enum ToolTrade;
  if (facts_.second_d && !facts_.tip)
    doubt(
        fmt::format("can be read as a tip of {0:g} or as register D{0:g}", facts_.second_d.value));
  if (facts_.bare_point > 0 && angles_.empty() && !hint_.diameters.empty() &&
      hint_.diameters.front().value != facts_.bare_point)
    doubt(fmt::format("can be read as having {0:g} degrees: say {0:g} DEG", facts_.bare_point));
  const double angle = angles_.empty() ? 0 : angles_.front();
  if (trade_is(cone_mill) || trade_is(cone_ball)) {
    const double side = facts_.included && !facts_.per_side ? 0.5 : 1;
    hint_.taper_angle = radians(facts_.taper > 0 ? facts_.taper : side * angle);
    return;
  }
  if (trade_is(dovetail) && angle < 90) hint_.taper_angle = radians(angle);
  if (!pointed()) return;
  if (facts_.taper > 0) {  // of a side, as in Fusion's lists, unless that leaves no cone
    constexpr double kLargestSide = 80;  // degrees
    const bool included =
        hint_.type == ToolType::drill || trade_is(countersink) || facts_.taper > kLargestSide;
    (included ? hint_.tip_angle : hint_.taper_angle) = radians(facts_.taper);
  } else if (angle > 0 && angle < 180) {
    set_angle(angle);
  } else if (kind()->tip_angle > 0) {
    hint_.tip_angle = radians(kind()->tip_angle);
    hint_.assumed_angle = true;
  }
  if (trade_is(vee) && hint_.tip_angle == 0 && hint_.taper_angle == 0) doubt("gives no angle");
  for (const double other : angles_)
    if (other != angle)
      doubt(fmt::format("can be read as an angle of {:g} or {:g} degrees", angle, other));
  if (!angles_.empty() && facts_.angles.empty() && hint_.diameters.empty() &&
      !trade_is(twist_drill))
    doubt(fmt::format("can be read as diameter {0:g} or as {0:g} degrees", angle));
}

// Sets the angle of a point: "45 DEG CHAMFER MILL" gives that of its side, "90 DEG" the whole one.
void Settler::set_angle(double degrees) {
  const bool chamfer = trade_is(ToolTrade::chamfer_mill);
  const bool side = facts_.per_side || (chamfer && degrees <= 60 && !facts_.included);
  (side ? hint_.taper_angle : hint_.tip_angle) = radians(degrees);
  if (side && degrees == 60 && !facts_.per_side)
    doubt("gives 60 degrees, of its side or of the whole");
}

// Clears sizes that belong to no kind of tool.
void Settler::drop_unclaimed() {
  if (!hint_.type && !hint_.names_tool && !facts_.diameter_line) hint_.diameters.clear();
  const bool tool = hint_.type || (hint_.names_tool && !hint_.diameters.empty());
  if (!tool && !facts_.corner_line) hint_.corner = {};
  if (!hint_.type) hint_.gauge.clear();
}

}  // namespace

void settle_tool(const ToolFacts& facts, ToolHint& hint) { Settler(facts, hint).settle(); }

}  // namespace mrsim
