#include "interp/words/turned_part.h"

#include "core/text_io.h"
#include "interp/comments/part_turned.h"
#include "interp/text/characters.h"

#include <algorithm>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr std::size_t kLongestHead = 40;  // characters before the text of MSG

}  // namespace

bool TurnedPart::stops() const {
  if (!find(letter('M'))) return false;
  return std::any_of(block_.words.begin(), block_.words.end(), [](const Word& word) {
    return word.address == letter('M') && (word.value == 0 || word.value == 1);
  });
}

void TurnedPart::read(std::string_view text, bool stops) {
  const PartTurned said = says_part_is_turned(text, lathe());
  if (said == PartTurned::no || (said == PartTurned::perhaps && !stops)) return;
  text_ = to_utf8(text);
  line_ = block_.line_number;
}

// Comments, and MSG("...") of SINUMERIK.
void TurnedPart::read_texts() {
  if (told_) return;
  for (const std::string_view comment : block_.comments) read(comment, stops());
  if (!is(Dialect::sinumerik) || !block_.words.empty()) return;
  const std::size_t first = block_.line.find('"');
  if (first == std::string_view::npos || first > kLongestHead) return;
  const std::string head = upper_case(block_.line.substr(0, first));
  const std::string_view text = block_.line.substr(first + 1);
  if (head.find("MSG") != std::string::npos) read(text.substr(0, text.find('"')), false);
}

void TurnedPart::end_block(std::size_t cuts) {
  if (told_) return;
  stopped_ |= stops();
  if (cuts > cuts_) {
    if (stopped_ && !text_.empty() && cuts_ > 0) {
      told_ = true;
      reporter_.once(
          Severity::warning, "part-turned",
          fmt::format("line {} says that the part is turned (\"{}\"): what follows is cut from the "
                      "side of the first cuts, too; --until {} ends the run before it",
                      line_, text_, line_),
          block_.words.front(), "part-turned");
    }
    stopped_ = false;
    text_.clear();
  }
  cuts_ = cuts;
}

}  // namespace mrsim
