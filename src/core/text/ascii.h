// Letters of ASCII, whatever the locale; other bytes stay as they are.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace mrsim {

constexpr char lower_case(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

inline std::string lower_case(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = lower_case(c);
  return out;
}

/// How the name of a file ends, in small letters: ".stl" of "a/Part.STL"; empty without a dot.
inline std::string extension_of(const std::string& path) {
  return lower_case(std::filesystem::path(path).extension().string());
}

}  // namespace mrsim
