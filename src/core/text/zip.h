// ZIP archives, as far as 3MF needs them: a few deflated files, no encryption, no spanning.
#pragma once

#include "core/text/text_io.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mrsim::detail {

struct ZipEntry {
  std::string name;
  std::size_t method = 0, offset = 0, packed_size = 0, size = 0, crc = 0;
};

/// The directory of an archive. Throws Error "3mf-zip" naming `name`.
std::vector<ZipEntry> zip_directory(std::string_view bytes, const std::string& name);

/// One file of the archive. Never gives more than the directory says, nor more than `limit` bytes
/// (a bomb is an Error "3mf-too-large" before it is unpacked). Throws Error "3mf-zip" and "memory".
std::string unzip(std::string_view bytes, const ZipEntry& entry, std::size_t limit,
                  const std::string& name);

/// Writes an archive of named files, in order, as their content comes, with a fixed date: equal
/// content, equal bytes. Sizes and check sums follow the content. Throws Error "3mf-too-large" for
/// what ZIP without its extension of 64 bits can not hold.
class ZipWriter {
 public:
  explicit ZipWriter(const ByteSink& out) : out_(out) {}
  /// Adds a file, whose bytes `writer` gives to the sink or `content` has.
  void add(const std::string& name, const std::function<void(const ByteSink&)>& writer);
  void add(const std::string& name, const std::string& content) {
    add(name, [&](const ByteSink& out) { out(content.data(), content.size()); });
  }
  /// Writes the directory. Requires: called once, last.
  void finish();

 private:
  void put(const std::string& bytes);
  const ByteSink& out_;
  std::string directory_;
  std::size_t position_ = 0, files_ = 0;
};

/// Bytes deflated without a header (RFC 1951); equal bytes, equal result.
std::string deflated(std::string_view bytes);

/// An archive in memory.
std::string zip(const std::vector<std::pair<std::string, std::string>>& files);

}  // namespace mrsim::detail
