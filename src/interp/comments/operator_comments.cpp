#include "interp/comments/operator_comments.h"

#include "core/text/text_io.h"
#include "interp/comments/comment_tokens.h"
#include "interp/comments/comment_view.h"
#include "interp/comments/tool_kind.h"
#include "interp/text/characters.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <system_error>

namespace mrsim {
namespace {

constexpr std::size_t kLongestNote = 200;  // characters that are read of a note to the operator
constexpr double kMostTools = 99'999'999;  // numbers of tools have at most eight digits

// Whether one of the words stands behind the word at i, with at most two others in between: "TURN
// THE PART OVER".
bool is_near(const CommentView& view, std::size_t i,
             std::initializer_list<std::string_view> words) {
  for (std::size_t k = i + 1; k <= i + 3; ++k)
    if (view.is_one(k, words)) return true;
  return false;
}

bool is_part(const CommentView& view, std::size_t i) {
  return view.is_one(i, {"PART", "PARTS", "WORK", "WORKPIECE", "STOCK", "BLOCK", "MATERIAL",
                         "PLATE", "BOARD", "BLANK", "PIECE", "JOB"});
}

// "PART STOP", "WORK LIGHT", "WORK OFFSET": the part says of what the thing is.
bool is_thing_of_part(const CommentView& view, std::size_t i) {
  return view.is_one(i, {"STOP", "STOPS", "STOPPER", "LIGHT",   "LAMP",   "OFFSET",  "OFFSETS",
                         "ZERO", "CLAMP", "CLAMPS",  "CATCHER", "HOLDER", "SUPPORT", "COUNTER",
                         "BIN",  "TRAY",  "NUMBER",  "DOOR",    "PROBE",  "LENGTH"});
}

bool names_part(const CommentView& view, std::size_t i) {
  for (std::size_t k = i + 1; k <= i + 3; ++k)
    if (is_part(view, k)) return !is_thing_of_part(view, k + 1);
  return false;
}

// What is moved stands behind the word, "MOVE THE FINISHED PART"; "MOVE CLAMP OFF PART" moves the
// clamp, and "MOVE OVER PART" the tool.
bool moves_part(const CommentView& view, std::size_t i) {
  for (std::size_t k = i + 1; k <= i + 3; ++k) {
    if (is_part(view, k)) return !is_thing_of_part(view, k + 1);
    if (is_thing_of_part(view, k) ||
        view.is_one(k, {"OFF", "FROM", "OVER", "TO", "ON", "AWAY", "CLEAR", "UNDER", "NEAR"}))
      return false;
  }
  return false;
}

// "DO NOT MOVE", "DON'T TURN", "TEIL NICHT DREHEN".
bool is_forbidden(const CommentView& view, std::size_t i) {
  const auto forbids = [&](std::size_t k) {
    return view.is_one(k, {"NOT", "NEVER", "DONT", "NO", "NICHT", "KEIN", "NIE", "PAS"});
  };
  const bool dont = i > 2 && view.is(i - 1, "T") && view.is(i - 2, "'") && view.is(i - 3, "DON");
  return dont || (i > 0 && forbids(i - 1));
}

// "TEIL DREHEN", "DREHE DAS TEIL"; on a lathe the part is turned by its spindle.
bool turns_german(const CommentView& view, std::size_t i) {
  if (!view.is_one(i, {"DREHEN", "DREHE", "GEDREHT"})) return false;
  for (std::size_t k = i > 5 ? i - 5 : 0; k <= i + 3; ++k)
    if (view.is_one(k, {"TEIL", "BAUTEIL", "WERKSTUECK", "WERKSTUCK", "WERKST~CK", "ROHTEIL",
                        "PLATTE", "BLOCK"}))
      return true;
  return false;
}

bool starts_with_one(std::string_view text, std::initializer_list<std::string_view> stems) {
  for (const std::string_view stem : stems)
    if (text.starts_with(stem)) return true;
  return false;
}

// Whether FLIP at i is said of something else than the part, or denied: "FLIP UP STOP", "FLIP
// JAWS".
bool flips_something_else(const CommentView& view, std::size_t i) {
  return view.is_one(i + 1, {"UP", "DOWN", "STOP", "JAW", "JAWS", "CLAMP", "CLAMPS", "INSERT",
                             "TOOL", "SWITCH", "PARALLELS", "FLOP"}) ||
         (i > 0 && view.is_one(i - 1, {"NO", "BEFORE", "DONT", "NOT"}));
}

bool turns_at(const CommentView& view, std::size_t i, bool lathe) {
  if (is_forbidden(view, i)) return false;
  if (turns_german(view, i)) return !lathe;
  if (view.is_one(i, {"FLIP", "FLIPPED"})) return !flips_something_else(view, i);
  if (view.is_one(i, {"TURN", "ROTATE", "TURNED", "ROTATED"})) {
    if (is_near(view, i, {"OVER", "AROUND", "UPSIDE", "VISE", "VICE", "FIXTURE"})) return true;
    return !(lathe && view.is(i, "TURN")) && names_part(view, i);
  }
  if (view.is_one(i, {"REVERSE", "INVERT", "SWAP"})) return names_part(view, i);
  if (view.is(i, "UPSIDE")) return view.is(i + 1, "DOWN");
  if (view.is(i, "DAR")) return is_near(view, i, {"VUELTA"});
  return view.word(i) &&
         starts_with_one(view[i].text,
                         {"UMSPANN", "WENDEN", "UMDREH", "RETOURN", "VOLTEA", "CAPOVOLG", "GIRARE",
                          "OBRNI", "OBROC", "OTOCIT", "PREPN", "PREVPN", "OKREN", "PREVRN"});
}

// Whether the word at i moves the part: "SHIFT PART IN VISE", "STAND UP PART ON END".
bool moves_at(const CommentView& view, std::size_t i) {
  return view.is_one(i, {"SHIFT", "SLIDE", "MOVE", "REPOSITION", "RELOCATE", "STAND"}) &&
         !is_forbidden(view, i) && moves_part(view, i);
}

// Whether another side of the part is named: "OTHER SIDE", "2ND SIDE", "SIDE 2", "ZWEITE SEITE".
bool names_other_side(const CommentView& view, std::size_t i) {
  if (view.is_one(i, {"BACKSIDE", "RUCKSEITE", "RUECKSEITE", "R~CKSEITE"})) return true;
  if (!view.is_one(i, {"SIDE", "SEITE", "FACE", "CARA", "LATO", "STRAN", "STRONA", "COTE"}))
    return false;
  const bool numbered = view.has(i + 1) && view[i + 1].is_number() && view[i + 1].value == 2;
  const bool counted = i > 0 && view[i - 1].is_number() && view[i - 1].value == 2;
  const bool ordered = i > 1 && view.is_one(i - 1, {"ND", ".", "EME", "A"}) &&
                       view[i - 2].is_number() && view[i - 2].value == 2;
  return numbered || counted || ordered ||
         (i > 0 &&
          view.is_one(i - 1, {"OTHER", "SECOND", "BACK", "BOTTOM", "OPPOSITE", "ZWEITE", "ANDERE",
                              "SEGUNDA", "SECONDO", "DRUGA", "DEUXIEME", "AUTRE", "OTRA"}));
}

bool is_order(const CommentView& view, std::size_t i) {
  return view.is_one(i, {"CHANGE",     "INSERT",    "INSTALL",  "LOAD",       "SWITCH",
                         "FIT",        "MOUNT",     "SWAP",     "PUT",        "WECHSEL",
                         "WECHSELN",   "EINSETZEN", "EINLEGEN", "EINSPANNEN", "WERKZEUGWECHSEL",
                         "TOOLCHANGE", "CHANGER",   "MONTER",   "CAMBIAR",    "COLOCAR",
                         "CAMBIO",     "CAMBIARE",  "ZAMENJAJ", "VSTAVI",     "WYMIEN",
                         "ZMIEN",      "MENJAJ",    "MENJAVA",  "ZAMENI",     "PROMIJENI"});
}

bool is_tool(const CommentView& view, std::size_t i) {
  return view.is_one(
      i, {"TOOL", "TOOLS", "BIT", "CUTTER", "WERKZEUG", "OUTIL", "HERRAMIENTA", "UTENSILE",
          "ORODJE", "ORODJA", "ALAT", "NARZEDZIE", "WERKZEUGWECHSEL", "TOOLCHANGE"});
}

// Whether the word at i says that the tool stays: "CHANGE DRILL IF WORN", "CHANGE TOOL OFFSET"; in
// "WHEN STOPPED CHANGE TO 6MM BALL" it does not.
bool is_reserve(const CommentView& view, std::size_t i) {
  return view.is_one(i, {"IF", "CHECK", "WORN", "BROKEN", "DULL", "OFFSET", "OFFSETS", "NO", "NOT",
                         "EVERY", "NEEDED", "NECESSARY", "REQUIRED", "SETTER", "PROBE", "WEAR"});
}

}  // namespace

PartTurned says_part_is_turned(std::string_view bytes, bool lathe) {
  const std::string folded = fold_comment(to_utf8(bytes.substr(0, kLongestNote)));
  const CommentView view(comment_tokens(folded));
  PartTurned said = PartTurned::no;
  for (std::size_t i = 0; i < view.size(); ++i) {
    if (turns_at(view, i, lathe)) return PartTurned::yes;
    if (names_other_side(view, i) || moves_at(view, i)) said = PartTurned::perhaps;
  }
  return said;
}

bool says_tool_is_changed(std::string_view bytes) {
  const std::string folded = fold_comment(to_utf8(bytes.substr(0, kLongestNote)));
  const std::vector<CommentToken> tokens = comment_tokens(folded);
  const CommentView view(tokens);
  bool order = false, tool = false;
  for (std::size_t i = 0; i < view.size(); ++i) {
    if (is_reserve(view, i)) return false;
    order |= is_order(view, i);
    tool |= is_tool(view, i);
  }
  if (!order) return false;
  const std::vector<ToolKind> kinds = find_tool_kinds(tokens);
  return tool || std::any_of(kinds.begin(), kinds.end(), [](const ToolKind& kind) {
           return kind.trade != ToolTrade::no_cutter;
         });
}

std::optional<int> tool_change_in_comment(std::string_view bytes) {
  std::optional<int> tool;
  bool changes = false;
  int words = 0;
  const std::string text = upper_case(bytes.substr(0, kLongestNote));
  const char *at = text.data(), *end = at + text.size();
  for (;;) {
    at = std::find_if(at, end, [](char c) { return c != ' ' && c != '\t' && c != '\r'; });
    if (at == end) break;
    const char letter = *at++;
    double value = 0;
    const auto [next, failed] = std::from_chars(at, end, value);
    if (failed != std::errc() || value != std::floor(value) || ++words > 2) return {};
    at = next;
    if (letter == 'M' && value == 6)
      changes = true;
    else if (letter == 'T' && value >= 0 && value <= kMostTools)
      tool = static_cast<int>(value);
    else
      return {};
  }
  return changes ? tool : std::nullopt;
}

}  // namespace mrsim
