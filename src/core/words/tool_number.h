// Tools by number: what programs write T01 is tool 1.
#pragma once

#include <algorithm>
#include <string_view>

namespace mrsim {

/// `id` without the zeros in front where it is a number, "1" of "01". Of a table
/// with both, one would never be used.
inline std::string_view tool_number(std::string_view id) {
  if (id.empty() || id.find_first_not_of("0123456789") != id.npos) return id;
  return id.substr(std::min(id.find_first_not_of('0'), id.size() - 1));
}

}  // namespace mrsim
