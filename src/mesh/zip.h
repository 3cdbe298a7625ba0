// ZIP archives, as far as 3MF needs them: a few deflated files, no encryption, no spanning.
#pragma once

#include <cstddef>
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

/// One file of it. Never gives more than the directory says, nor more than `limit` bytes (a bomb is
/// an Error "3mf-too-large" before it is unpacked). Throws Error "3mf-zip".
std::string unzip(std::string_view bytes, const ZipEntry& entry, std::size_t limit,
                  const std::string& name);

/// An archive of named files, in order, with a fixed date: equal content, equal bytes.
std::string zip(const std::vector<std::pair<std::string, std::string>>& files);

}  // namespace mrsim::detail
