// Text in JSON that is written line by line.
#pragma once

#include <string>
#include <string_view>

namespace mrsim {

/// `text` as a JSON string, with its quotes: in UTF-8 (to_utf8()), quotes and control characters
/// escaped.
std::string json_string(std::string_view text);

}  // namespace mrsim
