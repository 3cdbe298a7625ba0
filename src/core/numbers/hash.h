// Hashes of bytes, the same on every machine, however the bytes are cut into pieces.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace mrsim {

/// Compares contents, and stands for random identifiers in files. Not for secrets.
class ContentHash {
 public:
  /// Adds `size` bytes.
  void update(const void* data, std::size_t size);
  /// 64 bits of everything so far.
  std::uint64_t digest() const;
  /// The two halves as a UUID in text, "xxxxxxxx-xxxx-8xxx-8xxx-xxxxxxxxxxxx" (version 8: content,
  /// RFC 9562).
  std::string uuid() const;

 private:
  void mix(std::uint64_t word);

  std::uint64_t low_ = 0x243F6A8885A308D3u, high_ = 0x13198A2E03707344u;  // digits of pi
  std::uint64_t pending_ = 0, size_ = 0;
};

/// SHA-256 (FIPS 180-4), as `sha256sum` prints it.
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
