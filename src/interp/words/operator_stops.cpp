#include "interp/words/operator_stops.h"

#include "core/text/text_io.h"
#include "interp/comments/operator_comments.h"
#include "interp/comments/tool_hint.h"
#include "interp/text/characters.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr std::size_t kLongestHead = 40;  // characters before the text of MSG
constexpr std::size_t kLongestText = 200;
constexpr std::size_t kMostTexts = 64;

}  // namespace

bool OperatorStops::stops() const {
  if (!find(letter('M'))) return false;
  return std::any_of(block_.words.begin(), block_.words.end(), [](const Word& word) {
    return word.address == letter('M') && (word.value == 0 || word.value == 1);
  });
}

void OperatorStops::keep(std::string_view text, bool stops) {
  if (texts_.size() < kMostTexts)
    texts_.push_back({std::string(text.substr(0, kLongestText)), block_.line_number, stops});
}

// Texts for the operator are comments, and MSG("...") of SINUMERIK.
void OperatorStops::read_texts() {
  for (const std::string_view comment : block_.comments) keep(comment, stops());
  if (!is(Dialect::sinumerik) || !block_.words.empty()) return;
  const std::size_t first = block_.line.find('"');
  if (first == std::string_view::npos || first > kLongestHead) return;
  const std::string head = upper_case(block_.line.substr(0, first));
  const std::string_view text = block_.line.substr(first + 1);
  if (head.find("MSG") != std::string::npos) keep(text.substr(0, text.find('"')), false);
}

void OperatorStops::end_block(std::size_t cuts) {
  stopped_ |= stops();
  called_ |= find(letter('T')) || control_.tool.current != tool_;
  if (cuts <= cuts_) return;
  if (stopped_ && cuts_ > 0) tell();
  tell_changes_in_comments();
  stopped_ = called_ = false;
  texts_.clear();
  tool_ = control_.tool.current;
  cuts_ = cuts;
}

void OperatorStops::tell() const {
  for (const Text& text : texts_) {
    const PartTurned said = says_part_is_turned(text.bytes, lathe());
    if (said == PartTurned::yes || (said == PartTurned::perhaps && text.stops)) tell_turn(text);
    if (!called_ && (says_tool_is_changed(text.bytes) || names_another_tool(text.bytes)))
      tell_change(text);
  }
}

// Whether the text, such as "1/8 BALL ENDMILL", is about a tool of another diameter than the one in
// the spindle.
bool OperatorStops::names_another_tool(std::string_view text) const {
  const int index = control_.tool.index;
  if (lathe() || index < 0 || std::size_t(index) >= program_.tools.size()) return false;
  const ToolHint hint = read_tool_comment(text);
  Tool said;
  std::string why;
  constexpr double kSameSize = 0.1;  // mm
  const double size = program_.tools[std::size_t(index)].diameter;
  return hint.firm && hint.type && hint.id.empty() && !hint.upkeep &&
         fill_tool(hint, scale(), false, said, why) && size > 0 &&
         std::abs(said.diameter - size) > kSameSize;
}

// A change that stands in a comment is none.
void OperatorStops::tell_changes_in_comments() {
  for (const Text& text : texts_) {
    const std::optional<int> number = tool_change_in_comment(text.bytes);
    if (!number) continue;
    if (cuts_ > 0 && !called_ && commented_ != number &&
        control_.tool.current != std::to_string(*number))
      reporter_.once(Severity::warning, "tool-in-comment",
                     fmt::format("line {} changes the tool in a comment (\"{}\"), which no control "
                                 "reads: what follows is cut with the tool before; if it is "
                                 "changed there, write T{} M6 outside the comment",
                                 text.line, to_utf8(text.bytes), *number),
                     block_.words.front(), "tool-in-comment");
    commented_ = number;
  }
}

void OperatorStops::tell_turn(const Text& text) const {
  reporter_.once(
      Severity::warning, "part-turned",
      fmt::format(
          "line {0} says that the part is turned or moved (\"{1}\"): what follows is cut as "
          "if it lay as before; --until {0} ends the run before it",
          text.line, to_utf8(text.bytes)),
      block_.words.front(), "part-turned");
}

void OperatorStops::tell_change(const Text& text) const {
  reporter_.once(
      Severity::error, "tool-by-hand",
      fmt::format("line {0} says that the tool is changed by hand (\"{1}\"), and no T word says to "
                  "which: write T2 M6 with its comment there; --until {0} ends the run before it",
                  text.line, to_utf8(text.bytes)),
      block_.words.front(), "tool-by-hand");
}

}  // namespace mrsim
