#include "interp/comments/whole_comment.h"

#include "interp/comments/comment_words.h"
#include "interp/comments/tool_id.h"
#include "interp/comments/work_words.h"

namespace mrsim {
namespace {

// Whether the comment is a corner radius and nothing else, one line of several about a tool: "TIP
// RADIUS: 1.0", "CORNER: 1.0", "CR 0.5", "R: 0.5". "R5" and "RADIUS 5" may be the work's.
bool is_corner_line(const CommentView& view) {
  std::size_t i = view.is_one(0, {"TOOL", "CUTTER"}) ? 1 : 0;
  const bool named = view.is_one(i, {"TIP", "CORNER"});
  i += named ? 1 : 0;
  const bool tools_own = view.is_one(i, {"CR", "CRAD", "RC"});
  const bool radius = tools_own || view.is_one(i, {"RADIUS", "RAD", "R"});
  i += radius ? 1 : 0;
  if (i == 0 || !(named || radius)) return false;
  const bool signed_off = view.is_one(i, {":", "="});
  i = view.behind(i - 1);
  if (!view.has(i) || !view[i].is_number() || i + 1 != view.size()) return false;
  return named ? radius || view[i].decimals : tools_own || signed_off;
}

// Whether the comment is a diameter and nothing else: "DIAMETER: 8.0", "TOOL DIAMETER: 8.0".
bool is_diameter_line(const CommentView& view) {
  const std::size_t at = view.is_one(0, {"TOOL", "CUTTER"}) ? 1 : 0;
  if (!view.word(at) || comment_word(view[at].text).role != WordRole::diameter) return false;
  const std::size_t i = view.behind(at);
  return view.has(i) && view[i].is_number() && i + 1 == view.size();
}

// Whether the comment is an angle and nothing else: "TAPER: 2", "TOOL TIP ANGLE = 118", "3 DEG
// TAPER", "60 DEG".
bool is_angle_line(const CommentView& view) {
  std::size_t numbers = 0;
  bool named = false;
  for (std::size_t i = 0; i < view.size(); ++i) {
    if (view[i].is_number()) {
      numbers += view[i].value > 0 ? 1 : 2;
      named |= view[i].angle;
    }
    if (!view.word(i)) continue;
    const WordRole role = comment_word(view[i].text).role;
    const bool angle = role == WordRole::angle || role == WordRole::taper;
    if (view[i].text.size() < 2 ||
        !(angle || role == WordRole::tip || view.is_one(i, {"TOOL", "CUTTER", "INCLUDED", "INCL"})))
      return false;
    named |= angle;
  }
  return named && numbers == 1;
}

bool is_size_word(WordRole role) {
  using enum WordRole;
  return role == diameter || role == radius || role == radius_letter || role == corner ||
         role == nose || role == tip || role == width || role == length;
}

// Whether the comment has sizes or a shape and nothing else: "D10. R1.", "0.5 CORNER RADIUS", "TIP
// DIA 0.2", "BULL R1", "TAPERED". "D1 R1" may be registers.
bool is_size_line(const CommentView& view) {
  bool size = false, number = false, decimals = false, letter = false, diameter = false;
  bool shape = false;
  for (std::size_t i = 0; i < view.size(); ++i) {
    number |= view[i].is_number();
    decimals |= view[i].is_number() && view[i].decimals;
    if (!view.word(i)) continue;
    const WordRole role = comment_word(view[i].text).role;
    const bool one = view[i].text.size() == 1, sized = is_size_word(role);
    if (view.is(i, "D"))
      letter = true;
    else if (view.is_one(i, {"BALL", "BULL", "TAPERED", "CONICAL", "SPHERICAL"}))
      shape = true;
    else if (one ? !view.is(i, "R")
                 : !(sized || role == WordRole::adjective || role == WordRole::flutes ||
                     view.is_one(i, {"TOOL", "CUTTER", "WITH"})))
      return false;
    size |= sized;
    diameter |= role == WordRole::diameter;
  }
  return shape || (number && (size || letter) && (!letter || decimals || diameter));
}

// Whether the radius of such a line may be the tool's, or that of what it cuts, or count something:
// "R5", "FINISH R3", "NR. 2", "CORNER 1.". "CORNER RADIUS 1", "CR 1", "R: 1" and a radius beside a
// diameter are the tool's.
bool is_plain_radius(const CommentView& view) {
  bool radius = false, nose = false, part = false, marked = false;
  bool of_tool = false;
  for (std::size_t i = 0; i < view.size(); ++i) {
    marked |= view.is_one(i, {":", "="});
    if (!view.word(i)) continue;
    const WordRole role = comment_word(view[i].text).role;
    radius |= role == WordRole::radius || role == WordRole::radius_letter;
    nose |= role == WordRole::nose || role == WordRole::corner;
    part |= view.is_one(i, {"CORNER", "ECKE", "TIP", "NOSE"});
    const std::size_t number = view.behind(i);
    const bool decimals = view.has(number) && view[number].is_number() && view[number].decimals;
    of_tool |= role == WordRole::diameter || (view.is(i, "RE") && decimals) ||
               view.is_one(i, {"D", "CR", "CRAD", "TNR", "ECKENRADIUS", "ECKRADIUS", "BULL"});
  }
  of_tool |= (part && radius) || (marked && is_corner_line(view));
  return (radius || nose) && !of_tool;
}

// Whether the radius may be half the diameter or that of the corner: "TOOL RADIUS 5".
bool is_tool_radius(const CommentView& view) {
  return view.is_one(0, {"TOOL", "CUTTER"}) && view.is_one(1, {"RADIUS", "RAD", "R"});
}

// Whether the angle of such a line is the tool's: "TIP ANGLE 140", "ANGLE: 60". "45 DEG" and "3 DEG
// TAPER" may be the work's.
bool is_own_angle(const CommentView& view) {
  for (std::size_t i = 0; i < view.size(); ++i)
    if (view.is_one(i, {"TIP", "SPITZE", "POINT", "PT", ":", "="})) return true;
  return false;
}

// Whether the word stands beside a tool's number: "T", "NO.", "NUMBER".
bool is_word_of_id(const CommentView& view, std::size_t i) {
  return is_word_for_tool(view, i) || view.is_one(i, {"T", "NO", "NR", "NUMBER", "NUMMER", "ID"});
}

bool names_round_insert(const CommentView& view, std::size_t i) {
  const bool button = view.is_one(i + 1, {"TOOL", "INSERT"}) ||
                      (i < 2 && view.has(i + 1) && view[i + 1].is_number()) || view.is(i + 1, "R");
  return (view.is(i, "BUTTON") && button) || (view.is(i, "ROUND") && view.is(i + 1, "INSERT")) ||
         view.is_one(i, {"RUNDPLATTE", "PILZ", "PILZSTAHL", "PILZWERKZEUG"});
}

// Whether the word says that a tool without a kind is no plain end mill. BN is a ball nose or a
// bull nose; BM, KF and TF are a ball mill, a Kugel- and a Torusfraeser; CENTER beside a size and
// no other word names a centre drill, "CENTER D3". A corner radius tells the shape of "TF D12 R2".
bool tells_shape(const CommentView& view, const ToolFacts& facts, std::size_t i) {
  if (view.is_one(i, {"BM", "KF", "TF"})) return !facts.corner;
  if (view.is_one(i, {"CENTER", "CENTRE"}) && (!view.word(i + 1) || view.is(i + 1, "D")))
    return true;
  if (view.is(i, "BN") && view.is_one(i + 1, {"R", "CR", "RAD"})) return false;
  return view.is_one(i, {"TAPER", "TAPERED", "CONE",      "CONICAL",   "CONIC",   "VEE",
                         "ENGR",  "DEBURR",  "DEBURRING", "FORM",      "DISC",    "DISK",
                         "WHEEL", "COVE",    "OVOLO",     "LOLLI",     "DTAIL",   "UNDERCUT",
                         "BN",    "BNM",     "RADIUSED",  "ROUNDNOSE", "BACKSPOT"}) ||
         (view.is(i, "ROUND") && view.is(i + 1, "NOSE"));
}

// Whether the word at i gives the tool another size than the one that is named: "WAS 10MM, NOW
// 12MM", "10MM REGROUND 9.8", "10MM, 0.2 UNDERSIZE".
bool tells_other_size(const CommentView& view, std::size_t i) {
  std::size_t sizes = 0;
  for (std::size_t k = 0; k < view.size(); ++k)
    sizes += view[k].is_number() && !view.taken(k) && !view.is(k + 1, "X");
  if (sizes < 2) return false;
  const auto number = [&](std::size_t at) { return view.has(at) && view[at].is_number(); };
  const std::size_t behind = view.is(i + 1, "TO") ? i + 2 : view.behind(i);
  return view.is_one(i, {"WAS", "NOW", "REGROUND", "RESHARPENED", "UNDERSIZE", "UNDERSIZED",
                         "OVERSIZE", "NACHGESCHLIFFEN"}) &&
         (number(behind) || (i > 0 && number(i - 1)));
}

// Whether a word that no table has stands beside a noun for all mills, which it may give another
// shape: "FREZA XYZOVA D20".
bool has_unknown_shape(const CommentView& view, const ToolKind& kind) {
  if (kind.type != ToolType::endmill || kind.trade != ToolTrade::mill ||
      !view.is_one(kind.first, {"FREZALO", "REZKALO", "GLODALO", "FREZA", "FREZE", "FRESA",
                                "FRAISE", "FREZ", "FREES", "FRAESER", "FR~SER"}))
    return false;
  return is_unknown_word(view, kind.end) ||
         (kind.first > 0 && is_unknown_word(view, kind.first - 1));
}

}  // namespace

void read_whole_comment(const CommentView& view, ToolFacts& facts) {
  facts.corner_line = is_corner_line(view);
  facts.diameter_line = is_diameter_line(view);
  facts.angle_line = is_angle_line(view);
  facts.size_line = is_size_line(view);
  facts.plain_radius = facts.size_line && is_plain_radius(view);
  facts.tool_radius = facts.size_line && is_tool_radius(view);
  facts.own_angle = facts.angle_line && is_own_angle(view);
  facts.bare_id = !facts.id.empty();
  facts.bare_kind = facts.kind() != nullptr;
  facts.next_tool = names_next_tool(view);
  facts.last_tool = names_last_tool(view);
  facts.upkeep = tells_upkeep(view);
  facts.size_of_work = names_hollow(view);
  facts.unknown_shape = facts.kind() && has_unknown_shape(view, *facts.kind());
  facts.round_work = facts.kind() && mills_round_work(view, *facts.kind());
  for (std::size_t i = 0; i < view.size(); ++i) {
    const bool word = view.word(i);
    if (view[i].is_number()) facts.bare_id &= view.taken(i);
    if (word) facts.bare_id &= is_word_of_id(view, i);
    if (word && !view.taken(i) && !view.is_one(i, {"TOOL", "N"}))
      facts.bare_kind &= comment_word(view[i].text).role != WordRole::none;
    facts.alternatives |= view.is_one(i, {"OR", "ODER", "OU"}) && i > 0 &&
                          view[i - 1].is_number() && view.has(i + 1) && view[i + 1].is_number();
    facts.alternatives |= tells_other_size(view, i);
    facts.round_insert |= names_round_insert(view, i);
    facts.shaped |= tells_shape(view, facts, i);
    facts.other_work |= is_other_work(view, i);
    facts.unknown_word |= is_unknown_word(view, i);
    if (view.number(i) && (view[i].decimals || view[i].fraction) && !view[i].angle)
      facts.bare.push_back(view.length(i));
  }
}

}  // namespace mrsim
