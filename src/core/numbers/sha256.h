// SHA-256 (FIPS 180-4), as `sha256sum` prints it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace mrsim {

class Sha256 {
 public:
  void update(const void* data, std::size_t size);
  /// 64 digits, of everything so far. Ends the hash: nothing may follow.
  std::string hex();

 private:
  void take_block(const unsigned char* block);

  std::array<std::uint32_t, 8> state_{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                      0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
  std::array<unsigned char, 64> pending_{};
  std::size_t held_ = 0;     ///< bytes of `pending_` in use
  std::uint64_t total_ = 0;  ///< bytes
};

}  // namespace mrsim
