// A hash of content, to tell equal from unequal and to stand for random identifiers in files: the
// same bytes give the same hash on every machine, however they are cut into pieces. Not for
// secrets.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace mrsim {

class ContentHash {
 public:
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

}  // namespace mrsim
