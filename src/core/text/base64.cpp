#include "core/text/base64.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace mrsim {
namespace {

constexpr std::string_view kDigits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::uint32_t kNone = 64;

constexpr std::array<std::uint8_t, 256> kValues = [] {
  std::array<std::uint8_t, 256> values{};
  values.fill(kNone);
  for (std::size_t k = 0; k < kDigits.size(); ++k)
    values[static_cast<unsigned char>(kDigits[k])] = static_cast<std::uint8_t>(k);
  return values;
}();

}  // namespace

std::string base64(std::string_view bytes) {
  std::string out;
  out.reserve(bytes.size() * 4 / 3 + 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto at = [&](std::size_t k) {
      return i + k < bytes.size() ? std::uint32_t(static_cast<unsigned char>(bytes[i + k])) : 0;
    };
    const std::uint32_t bits = at(0) << 16 | at(1) << 8 | at(2);
    for (int k = 0; k < 4; ++k)
      out += i + std::size_t(k) > bytes.size() ? '=' : kDigits[bits >> (18 - 6 * k) & 63];
  }
  return out;
}

std::optional<std::string> from_base64(std::string_view text) {
  if (text.size() % 4 != 0) return std::nullopt;
  std::string out;
  out.reserve(text.size() / 4 * 3);
  for (std::size_t i = 0; i < text.size(); i += 4) {
    const bool is_last = i + 4 == text.size();
    const std::size_t padding = !is_last                     ? 0
                                : text.substr(i + 2) == "==" ? 2
                                : text[i + 3] == '='         ? 1
                                                             : 0;
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const std::uint32_t value =
          k + padding >= 4 ? 0 : kValues[static_cast<unsigned char>(text[i + k])];
      if (value == kNone) return std::nullopt;
      bits = bits << 6 | value;
    }
    for (std::size_t k = 0; k + padding < 3; ++k) out += static_cast<char>(bits >> (16 - 8 * k));
    if (padding > 0 && (bits & ((1u << (8 * padding)) - 1)) != 0) return std::nullopt;
  }
  return out;
}

}  // namespace mrsim
