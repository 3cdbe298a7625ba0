// Little-endian numbers in byte buffers, on any machine, and a buffered way into a ByteSink.
#pragma once

#include "core/text/text_io.h"

#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>

namespace mrsim::detail {

template <class T>
using BitsOf = std::conditional_t<
    sizeof(T) == 1, std::uint8_t,
    std::conditional_t<sizeof(T) == 2, std::uint16_t,
                       std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>>>;

/// The value of type T whose bytes begin at `data`, the least one first (with `big` the last one).
template <class T>
T load(const char* data, bool big = false) {
  BitsOf<T> bits = 0;
  for (std::size_t i = 0; i < sizeof(T); ++i) {
    const std::size_t at = big ? sizeof(T) - 1 - i : i;
    bits = BitsOf<T>(bits | BitsOf<T>(BitsOf<T>(static_cast<unsigned char>(data[at])) << (8 * i)));
  }
  return std::bit_cast<T>(bits);
}

template <class T>
void store(std::string& out, T value) {
  const auto bits = std::bit_cast<BitsOf<T>>(value);
  for (std::size_t i = 0; i < sizeof(T); ++i) out.push_back(char((bits >> (8 * i)) & 0xff));
}

/// store() into memory; returns where it ends.
template <class T>
char* store(char* at, T value) {
  const auto bits = std::bit_cast<BitsOf<T>>(value);
  for (std::size_t i = 0; i < sizeof(T); ++i) at[i] = char((bits >> (8 * i)) & 0xff);
  return at + sizeof(T);
}

/// Collects what is written in pieces of a megabyte.
class Buffer {
 public:
  explicit Buffer(const ByteSink& sink) : sink_(sink) { text_.reserve(kSize + 4096); }
  std::string& text() {
    if (text_.size() >= kSize) flush();
    return text_;
  }
  void flush() {
    if (!text_.empty()) sink_(text_.data(), text_.size());
    text_.clear();
  }

 private:
  static constexpr std::size_t kSize = 1 << 20;
  const ByteSink& sink_;
  std::string text_;
};

}  // namespace mrsim::detail
