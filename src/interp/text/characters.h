// Character classes of NC text: ASCII only, whatever the locale.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace mrsim {

constexpr char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c; }
constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
constexpr bool is_letter(char c) { return upper(c) >= 'A' && upper(c) <= 'Z'; }
constexpr bool is_name(char c) { return is_letter(c) || is_digit(c) || c == '_'; }
constexpr bool starts_number(char c) { return is_digit(c) || c == '+' || c == '-' || c == '.'; }

/// Exact: a mantissa below 2^53 divided by a power of ten up to 10^22 is correctly rounded.
inline constexpr std::array<double, 16> kPowersOfTen = {
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};

/// The first place from `p` on that holds no blank and no tab.
constexpr std::size_t behind_blanks(std::string_view line, std::size_t p) {
  while (p < line.size() && (line[p] == ' ' || line[p] == '\t')) ++p;
  return p;
}

/// The base of a number in quotes, 'HFF' or 'B101', by its letter: 16, 2, else 0.
constexpr int radix_base(char letter) {
  return upper(letter) == 'H' ? 16 : upper(letter) == 'B' ? 2 : 0;
}
/// `digits` as a number to that base; nothing if one of them is no digit of it.
constexpr std::optional<double> radix_number(std::string_view digits, int base) {
  double value = 0;
  for (const char digit : digits) {
    const char c = upper(digit);
    const int worth = is_digit(c) ? c - '0' : c >= 'A' && c <= 'F' ? c - 'A' + 10 : 99;
    if (worth >= base) return std::nullopt;
    value = value * base + worth;
  }
  return value;
}

inline std::string upper_case(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = upper(c);
  return out;
}

}  // namespace mrsim
