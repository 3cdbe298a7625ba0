// Rows of whole numbers and bytes as the page reads them: {"z": base64 of raw deflate}.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

namespace mrsim {

/// Bytes, deflated, as a string that JSON and HTML leave alone.
nlohmann::ordered_json packed_bytes(std::string_view bytes);

/// Differences as little-endian groups of seven bits, sign in the lowest: small numbers, few bytes.
class Packer {
 public:
  /// The difference of `value` from `last`, which becomes `value`.
  void add(std::int64_t value, std::int64_t& last) {
    put(value - last);
    last = value;
  }
  void put(std::int64_t value) {
    std::uint64_t z = (std::uint64_t(value) << 1) ^ std::uint64_t(value >> 63);
    for (; z >= 128; z >>= 7) bytes_.push_back(char(z | 128));
    bytes_.push_back(char(z));
  }
  nlohmann::ordered_json json() const { return packed_bytes(bytes_); }

 private:
  std::string bytes_;
};

}  // namespace mrsim
