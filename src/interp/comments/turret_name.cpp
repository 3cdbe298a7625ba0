#include "interp/comments/turret_name.h"

#include "core/text/text_io.h"
#include "interp/text/characters.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr std::string_view kTurning[] = {
    "ROUGHING",   "FINISHING",    "ROUGHER",       "FINISHER",    "SCHRUPPER",
    "SCHLICHTER", "SCHRUPPSTAHL", "SCHLICHTSTAHL", "DREHMEISSEL", "DREHSTAHL"};

// The corner of the insert in "80" or "T80"; empty: the word has none.
std::string_view corner_of(std::string_view word) {
  if (word.starts_with('T')) word.remove_prefix(1);
  const bool usual = word == "35" || word == "55" || word == "80";
  return usual ? word : std::string_view();
}

// The nose radius in "R08" or "R0.8", as " R0.8"; empty: the word has none.
std::string nose_of(std::string_view word) {
  if (!word.starts_with('R')) return {};
  word.remove_prefix(1);
  const auto digit = [&](std::size_t i) { return i < word.size() && is_digit(word[i]); };
  if (word.size() == 2 && word[0] <= '1' && digit(0) && digit(1))
    return fmt::format(" R{}.{}", word[0], word[1]);
  const bool decimal = word.size() == 3 && digit(0) && word[1] == '.' && digit(2);
  return decimal ? fmt::format(" R{}", word) : std::string();
}

// The length of "I.D.", "O.D", "I/D" at `i`; 0 for other text.
std::size_t length_of_side(std::string_view text, std::size_t i) {
  const auto at = [&](std::size_t k) { return k < text.size() ? text[k] : ' '; };
  if ((at(i) != 'I' && at(i) != 'O') || at(i + 2) != 'D') return 0;
  if (at(i + 1) != '.' && at(i + 1) != '/') return 0;
  if (i > 0 && (is_name(text[i - 1]) || text[i - 1] == '.')) return 0;
  if (at(i + 3) != '.' && is_name(at(i + 3))) return 0;
  const std::size_t end = at(i + 3) == '.' ? i + 4 : i + 3;
  const std::size_t next = text.find_first_not_of(' ', end);
  return at(next) == '=' || at(next) == ':' ? 0 : end - i;  // "O.D.=.5" of a mill
}

// Takes the last word off the text and returns it.
std::string take_last(std::string& text) {
  const std::size_t blank = text.find_last_of(' ');
  if (blank == std::string::npos) return {};
  std::string last = text.substr(blank + 1);
  text.erase(blank);
  return last;
}

}  // namespace

std::string with_points(std::string_view name) {
  std::string out(name);
  const auto is = [&](std::size_t i, auto accepts) { return i < out.size() && accepts(out[i]); };
  for (std::size_t i = 1; i + 1 < out.size(); ++i) {
    const char letter = upper(out[i - 1]);
    const bool begins = i < 2 || !is_name(out[i - 2]) || out[i - 2] == '_' || is_digit(out[i - 2]);
    if ((letter == 'R' || letter == 'D') && begins && out[i] == '0' && out[i + 1] == '_' &&
        is(i + 2, is_digit) && !is(i + 3, is_name))
      out[i + 1] = '.';
  }
  return out;
}

std::string spelled_turret_name(std::string_view name) {
  std::string text = upper_case(name);
  spell_sides(text);
  std::replace(text.begin(), text.end(), '_', ' ');
  std::string side;
  for (const auto& [letter, word] : {std::pair{" A", "OD "}, std::pair{" I", "ID "}}) {
    if (!text.ends_with(letter)) continue;
    side = word;
    take_last(text);
    break;
  }
  std::string head = text;
  std::string last = take_last(head);
  const std::string nose = nose_of(last);
  if (!nose.empty()) last = take_last(head);
  const std::string_view corner = corner_of(last);
  const bool turning =
      std::find(std::begin(kTurning), std::end(kTurning), head) != std::end(kTurning);
  if (turning && !corner.empty()) text = "TURNING TOOL " + std::string(corner) + " DEG" + nose;
  return "TOOL " + side + text;
}

void spell_sides(std::string& folded) {
  for (std::size_t i = 0; i + 2 < folded.size(); ++i)
    if (const std::size_t length = length_of_side(folded, i); length > 0)
      folded.replace(i, length, folded[i] == 'I' ? "ID " : "OD ");
  for (const std::string_view side : {"OD_", "ID_"}) {
    const std::size_t at = folded.find(side);
    if (at == folded.npos || (at > 0 && is_name(folded[at - 1]))) continue;
    const std::string_view corner = corner_of(std::string_view(folded).substr(at + 3, 2));
    std::size_t end = at + 5;
    const std::string_view rest = std::string_view(folded).substr(std::min(end, folded.size()));
    const bool radius = rest.size() > 2 && rest.starts_with("_R") && is_digit(rest[2]);
    if (radius)
      end += 1;  // "OD_35_R0.4"
    else if (rest.starts_with("_L") || rest.starts_with("_R"))
      end += 2;
    if (corner.empty() || (end < folded.size() && is_digit(folded[end]))) continue;
    const std::string words = fmt::format("{}D TURNING {} DEG ", side.front(), corner);
    folded.replace(at, end - at, words);
  }
}

}  // namespace mrsim
