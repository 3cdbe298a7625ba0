// What the words beside G65 and G66 mean: local variables of letters, macros of probes, and the H
// of old controls. Private to src/interp.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace mrsim {

struct Word;

/// The local variable of a letter in argument list I; 0: the letter is no argument.
int local_of_letter(char c);

/// Whether the macro is a probe's by the number of its maker: Renishaw 98xx, Haas 9023 and 999x.
bool is_probing_macro(long number);

/// Whether H stands right behind G65 and has no point, as in macro A of old controls: "G65 H02
/// P#101 Q#102 R5" adds, and calls no program. In macro B P stands there.
bool is_macro_a(const std::vector<Word>& words, const Word& code);

/// Whether a word or an assignment begins at `p`: "M99", "G1", "#3=1".
bool begins_word(std::string_view line, std::size_t p);

/// The place of the words behind the target of a GOTO, "10", "#3" or "[#3+1]", which is at `p`. The
/// end of the line: there are none.
std::size_t words_behind_jump(std::string_view line, std::size_t p);

inline constexpr const char* kBehindJump =
    "what stands behind a jump is not read: write it into a block of its own";

}  // namespace mrsim
