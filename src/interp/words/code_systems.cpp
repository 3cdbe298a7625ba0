#include "interp/words/code_systems.h"

#include <algorithm>

#include <fmt/format.h>

namespace mrsim {

bool CodeSystems::has(std::string_view letters) const {
  return std::any_of(block_.words.begin(), block_.words.end(), [&](const Word& word) {
    return word.address < Address::function &&
           letters.find(static_cast<char>(word.address)) != letters.npos;
  });
}

void CodeSystems::rewrite() {
  if (!lathe() || !is(Dialect::fanuc) || modal_.okuma) return;
  for (Word& code : block_.words) {
    if (code.address != letter('G')) continue;
    if (code.value == 70 || code.value == 71) see_units();
    if (modal_.system_c) rewrite_c(code);
    if (code.value >= 77 && code.value <= 79 && has("XZUW")) modal_.has_increments = true;
    // System A has no G91: its G92 is the thread, theirs the zero.
    if (code.value == 92 && modal_.has_increments && modal_.turn.number != 92 && has("XZUW") &&
        !has("FEI"))
      code.value = 50;
  }
}

// G70 and G71 alone are units in system C, and cycles in A and B.
void CodeSystems::see_units() {
  modal_.system_c = !has("PQRUWDIKA");
  modal_.has_increments |= modal_.system_c;
}

void CodeSystems::rewrite_c(Word& code) {
  const auto n = static_cast<int>(code.value);
  if (code.value != n) return;
  if (n >= 72 && n <= 78)
    rename(code, n - 2, n - 2);
  else if ((n == 20 || n == 21) && has("XZUW"))
    rename(code, n + 57, n == 20 ? 90 : 92);  // by system B: G90 is absolute
  else if (n == 24 && has("XZUW"))
    rename(code, 79, 94);
  else if (n == 92)
    code.value = 50;
  else if (n == 98 || n == 99)  // where the tool goes between holes
    code.address = Address::data;
}

void CodeSystems::rename(Word& code, int number, int in_system_a) {
  reporter_.once(Severity::warning, "code-system",
                 fmt::format("{} is read as in code system C, where it is G{} of system A, because "
                             "the program has its units by G70 or G71 alone",
                             text_of(code), in_system_a),
                 code, "code-system-c");
  code.value = number;
}

}  // namespace mrsim
