// Finds parts of branches and loops behind the words of a block ("G1 X1 ELSE"), where no control
// looks for them. A branch that passes over one would run other blocks than its author meant.
#pragma once

#include <cstddef>
#include <string_view>

namespace mrsim {

/// FANUC: where ELSE, ELSEIF, ENDIF, DO1 or END1 stands behind the words that begin at `p`, in the
/// block that ends before `end`; npos if none does.
std::size_t stray_macro_word(std::string_view line, std::size_t p, std::size_t end);

/// SINUMERIK: the same for ELSE, ENDIF, UNTIL and the ends of loops, from `p` to the comment.
std::size_t stray_sinumerik_word(std::string_view line, std::size_t p);

}  // namespace mrsim
