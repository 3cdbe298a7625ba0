#include "interp/language/stray_words.h"

#include "interp/text/characters.h"

#include <algorithm>

namespace mrsim {
namespace {

bool is_any(std::string_view word, std::initializer_list<std::string_view> names) {
  return std::find(names.begin(), names.end(), word) != names.end();
}

}  // namespace

std::size_t stray_macro_word(std::string_view line, std::size_t p, std::size_t end) {
  end = std::min(end, line.size());
  if (p + 1 < end && is_letter(line[p]) && is_letter(line[p + 1])) return line.npos;  // a statement
  for (std::size_t from = p; p < end; ++p) {
    if (line[p] == '(') p = std::min(line.find(')', p), end);
    if (p >= end || !is_letter(line[p])) continue;
    const std::size_t at = p;
    while (p < end && is_letter(line[p])) ++p;
    const std::string word = upper_case(line.substr(at, p - at));
    const bool numbered = p < end && is_digit(line[p]) && is_any(word, {"DO", "END"});
    if (at > from && (numbered || is_any(word, {"ELSE", "ELSEIF", "ENDIF"}))) return at;
    --p;
  }
  return line.npos;
}

std::size_t stray_sinumerik_word(std::string_view line, std::size_t p) {
  bool quoted = false;
  for (; p < line.size() && (quoted || line[p] != ';'); ++p) {
    if (line[p] == '"') quoted = !quoted;
    if (quoted || !is_name(line[p])) continue;
    const std::size_t at = p;
    while (p < line.size() && is_name(line[p])) ++p;
    const std::string word = upper_case(line.substr(at, p - at));
    if (is_any(word, {"ELSE", "ENDIF", "ENDWHILE", "ENDFOR", "ENDLOOP", "UNTIL"})) return at;
    --p;
  }
  return line.npos;
}

}  // namespace mrsim
