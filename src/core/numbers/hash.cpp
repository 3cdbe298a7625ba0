#include "core/numbers/hash.h"

#include <bit>

#include <fmt/format.h>

namespace mrsim {
namespace {

// The finaliser of SplitMix64: every bit of the input reaches every bit of the output.
std::uint64_t scramble(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
  return x ^ (x >> 31);
}

}  // namespace

void ContentHash::mix(std::uint64_t word) {
  low_ = (std::rotl(low_, 27) ^ word) * 0x9E3779B97F4A7C15u;
  high_ = (std::rotl(high_, 31) + word) * 0xD6E8FEB86659FD93u + low_;
}

void ContentHash::update(const void* data, std::size_t size) {
  const auto* bytes = static_cast<const unsigned char*>(data);
  for (std::size_t i = 0; i < size; ++i) {
    pending_ |= static_cast<std::uint64_t>(bytes[i]) << (8 * (size_ % 8));
    if (++size_ % 8 == 0) {
      mix(pending_);
      pending_ = 0;
    }
  }
}

std::uint64_t ContentHash::digest() const {
  ContentHash last = *this;
  last.mix(pending_);
  last.mix(size_);
  return scramble(last.low_ ^ scramble(last.high_));
}

std::string ContentHash::uuid() const {
  ContentHash other = *this;
  other.mix(1);
  std::uint64_t a = digest(), b = other.digest();
  a = (a & ~std::uint64_t(0xF000)) | 0x8000u;
  b = (b & ~(std::uint64_t(3) << 62)) | (std::uint64_t(2) << 62);
  return fmt::format("{:08x}-{:04x}-{:04x}-{:04x}-{:012x}", a >> 32, (a >> 16) & 0xFFFF, a & 0xFFFF,
                     b >> 48, b & 0xFFFFFFFFFFFFu);
}

}  // namespace mrsim
