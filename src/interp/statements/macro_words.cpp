#include "interp/statements/macro_words.h"

#include "interp/language/flow_scan.h"
#include "interp/text/block.h"
#include "interp/text/characters.h"

#include <algorithm>
#include <array>

namespace mrsim {

int local_of_letter(char c) {
  static constexpr std::array<int, 26> kLocals = {1, 2, 3, 7,  8,  9,  0,  11, 4,  5,  6,  0,  13,
                                                  0, 0, 0, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26};
  return c >= 'A' && c <= 'Z' ? kLocals[static_cast<std::size_t>(c - 'A')] : 0;
}

bool is_probing_macro(long number) {
  return (number >= 9800 && number <= 9899) || number == 9023 || (number >= 9994 && number <= 9996);
}

bool is_macro_a(const std::vector<Word>& words, const Word& code) {
  const Word* const next = &code + 1;
  return code.value == 65 && next < words.data() + words.size() && next->address == letter('H') &&
         !next->point;
}

bool begins_word(std::string_view line, std::size_t p) {
  const auto at = [&](std::size_t i) { return i < line.size() ? line[i] : ' '; };
  return at(p) == '#' || (is_letter(at(p)) && !is_letter(at(p + 1)));
}

std::size_t words_behind_jump(std::string_view line, std::size_t p) {
  const auto skip = [&](const char* characters) {
    p = std::min(line.find_first_not_of(characters, p), line.size());
  };
  const auto at = [&](char c) { return p < line.size() && line[p] == c; };
  skip(" \t+-");
  const std::size_t from = p;
  skip("# \t");
  if (at('[')) {
    const std::size_t close = closing_bracket(line, p);
    p = close == std::string_view::npos ? line.size() : close + 1;
  } else {
    skip("0123456789. \t");
  }
  return p == from || ends_block(line, p) ? line.size() : p;
}

}  // namespace mrsim
