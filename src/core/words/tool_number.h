// Tools by number: what programs write T01 is tool 1.
#pragma once

#include <algorithm>
#include <string_view>

namespace mrsim {

/// `text` without the zeros in front; its last character stays.
inline std::string_view without_leading_zeros(std::string_view text) {
  return text.empty() ? text : text.substr(std::min(text.find_first_not_of('0'), text.size() - 1));
}

/// `id` without the zeros in front where it is a number, "1" of "01". Of a table
/// with both, one would never be used.
inline std::string_view tool_number(std::string_view id) {
  return id.find_first_not_of("0123456789") != id.npos ? id : without_leading_zeros(id);
}

}  // namespace mrsim
