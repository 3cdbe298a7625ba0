// Numbers of things in sentences.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace mrsim {

/// "1 triangle turned", "3 triangles turned".
inline std::string counted(std::size_t n, std::string_view one, std::string_view many) {
  return std::to_string(n).append(" ").append(n == 1 ? one : many);
}
/// "1 error", "3 errors".
inline std::string counted(std::size_t n, std::string_view one) {
  return counted(n, one, std::string(one) + "s");
}

}  // namespace mrsim
