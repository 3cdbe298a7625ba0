#include "interp/comments/blade_code.h"

#include <algorithm>
#include <initializer_list>
#include <string_view>

namespace mrsim {
namespace {

using Tokens = std::vector<CommentToken>;

bool one_of(std::string_view text, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), text) != words.end();
}

bool is_glued(const Tokens& tokens, std::size_t i) { return i < tokens.size() && tokens[i].glued; }

bool is_whole(const Tokens& tokens, std::size_t i, std::size_t digits) {
  return i < tokens.size() && tokens[i].is_number() && !tokens[i].decimals && !tokens[i].fraction &&
         tokens[i].text.size() == digits;
}

// Reads "MGMN 300", "MGGN-250", "SP300": the width in hundredths of a mm. MRMN has a round end.
std::optional<BladeCode> read_mgmn(const Tokens& tokens, std::size_t i) {
  const bool round = tokens[i].is("MRMN");
  if (!round && !tokens[i].is("MGMN") && !tokens[i].is("MGGN") && !tokens[i].is("SP"))
    return std::nullopt;
  const std::size_t size = i + 1 < tokens.size() && tokens[i + 1].is("-") ? i + 2 : i + 1;
  if (!is_whole(tokens, size, 3) || (tokens[i].is("SP") && !tokens[size].glued))
    return std::nullopt;
  BladeCode code;
  code.width = tokens[size].value / 100;
  if (round) code.nose = code.width / 2;
  code.end = size + 1;
  return code;
}

// Reads "DGN 3102J", width and corner radius in tenths of a mm, and "GIP 3.00-0.40", both in mm.
std::optional<BladeCode> read_iscar(const Tokens& tokens, std::size_t i) {
  BladeCode code;
  if (one_of(tokens[i].text, {"DGN", "DGR", "DGL"}) && is_whole(tokens, i + 1, 4)) {
    const int number = static_cast<int>(tokens[i + 1].value), tenths = number / 100;
    code.width = tenths / 10.0;
    code.nose = number % 100 / 10.0;
    code.end = i + 2;
    return code;
  }
  if (!one_of(tokens[i].text, {"GIP", "GIPI", "GIF"}) || i + 3 >= tokens.size() ||
      !tokens[i + 1].decimals || !tokens[i + 2].is("-") || !tokens[i + 3].decimals)
    return std::nullopt;
  code.width = tokens[i + 1].value;
  code.nose = tokens[i + 3].value;
  code.end = i + 4;
  return code;
}

// Reads "NG3125L", "NG-3125R" of Kennametal: the size of the insert, then the width in thousandths
// of an inch.
std::optional<BladeCode> read_top_notch(const Tokens& tokens, std::size_t i) {
  const bool hyphen = i + 1 < tokens.size() && tokens[i + 1].is("-") && tokens[i + 1].glued;
  const std::size_t size = hyphen ? i + 2 : i + 1;
  if (!tokens[i].is("NG") || !is_whole(tokens, size, 4) || !is_glued(tokens, size))
    return std::nullopt;
  BladeCode code;
  code.width = static_cast<int>(tokens[size].value) % 1000 * 0.0254;
  code.end = size + 1;
  return code;
}

// Reads "N151.2-300-30-4G": the width in hundredths of a mm.
std::optional<BladeCode> read_n151(const Tokens& tokens, std::size_t i) {
  if (!tokens[i].is("N") || i + 3 >= tokens.size() || !tokens[i + 1].text.starts_with("151.") ||
      !tokens[i + 2].is("-") || !is_whole(tokens, i + 3, 3))
    return std::nullopt;
  BladeCode code;
  code.width = tokens[i + 3].value / 100;
  code.end = i + 4;
  return code;
}

// Reads "N123G2-0300": the width in hundredths of a mm.
std::optional<BladeCode> read_n123(const Tokens& tokens, std::size_t i) {
  if (!tokens[i].is("N") || !is_whole(tokens, i + 1, 3) || !is_glued(tokens, i + 3) ||
      tokens[i + 1].text != "123" || tokens[i + 2].text.size() != 1 || i + 5 >= tokens.size() ||
      !tokens[i + 4].is("-") || !is_whole(tokens, i + 5, 4))
    return std::nullopt;
  BladeCode code;
  code.width = tokens[i + 5].value / 100;
  code.end = i + 6;
  return code;
}

// Reads "GTN-3", "TDC3": grooving blades whose size is only about their width, so they get none.
std::optional<BladeCode> read_sized_blade(const Tokens& tokens, std::size_t i) {
  if (!one_of(tokens[i].text, {"GTN", "GTR", "GTL", "TDC", "TDJ", "KGT", "KGM"}))
    return std::nullopt;
  const std::size_t size = i + 1 < tokens.size() && tokens[i + 1].is("-") ? i + 2 : i + 1;
  if (!is_whole(tokens, size, 1)) return std::nullopt;
  BladeCode code;
  code.end = size + 1;
  return code;
}

// Whether "AG60", "A55" or "1.5 ISO" begins at token i, the profile of a thread.
bool names_profile(const Tokens& tokens, std::size_t i) {
  if (i + 1 >= tokens.size()) return false;
  if (one_of(tokens[i].text, {"A", "G", "AG"}))
    return tokens[i + 1].text == "60" || tokens[i + 1].text == "55";
  return tokens[i].is_number() && one_of(tokens[i + 1].text, {"ISO", "UN", "W"});
}

// Reads threading inserts: "16ER AG60", "11IR 1.5 ISO", "16ERAG55", "16NR 14 W"; "16 ER 1.5" has
// the lead of the thread at its end. "ER16 AG60" has its size behind, and "ER16" alone is a collet.
std::optional<BladeCode> read_thread(const Tokens& tokens, std::size_t i) {
  if (i + 1 >= tokens.size()) return std::nullopt;
  const bool turned = tokens[i + 1].is_number() && tokens[i + 1].glued;
  const CommentToken &size = tokens[turned ? i + 1 : i], &letters = tokens[turned ? i : i + 1];
  if (!size.is_number() || !one_of(size.text, {"06", "08", "11", "16", "22", "27"}) ||
      letters.text.size() < 2)
    return std::nullopt;
  const bool has_lead = i + 2 < tokens.size() && tokens[i + 2].decimals;
  if (turned ? !names_profile(tokens, i + 2) : !tokens[i + 1].glued && !has_lead)
    return std::nullopt;
  const std::string_view word = letters.text, hand = word.substr(0, 2);
  const std::string_view profile = word.substr(2);
  if (!one_of(hand, {"ER", "EL", "IR", "IL", "NR", "NL"}) || !one_of(profile, {"", "A", "G", "AG"}))
    return std::nullopt;
  BladeCode code;
  code.type = ToolType::threading;
  code.angle = 60;
  code.inside = hand[0] != 'E';
  code.left_hand = hand[1] == 'L';
  std::size_t at = i + 2;
  if (profile.empty() && at < tokens.size() && one_of(tokens[at].text, {"A", "G", "AG"})) ++at;
  if (at < tokens.size() && tokens[at].is_number()) {
    if (tokens[at].value == 55) code.angle = 55;
    ++at;
    if (at < tokens.size() && tokens[at].is("W")) code.angle = 55;  // Whitworth
    if (at < tokens.size() && one_of(tokens[at].text, {"ISO", "UN", "W"})) ++at;
  }
  code.end = at;
  return code;
}

}  // namespace

std::optional<BladeCode> find_blade_code(const Tokens& tokens) {
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    std::optional<BladeCode> code = read_mgmn(tokens, i);
    if (!code) code = read_n123(tokens, i);
    if (!code) code = read_n151(tokens, i);
    if (!code) code = read_iscar(tokens, i);
    if (!code) code = read_top_notch(tokens, i);
    if (!code) code = read_sized_blade(tokens, i);
    if (!code) code = read_thread(tokens, i);
    if (!code) continue;
    code->first = i;
    return code;
  }
  return std::nullopt;
}

}  // namespace mrsim
