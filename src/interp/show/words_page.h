// docs/words.md: every function word of every control, from the tables that the interpreter reads.
#pragma once

#include <string>

namespace mrsim {

/// The whole page. tests/interp/words_page_test.cpp compares it with the file.
std::string words_page();

}  // namespace mrsim
