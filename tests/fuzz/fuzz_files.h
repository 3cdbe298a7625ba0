// Files that fuzz targets write for what reads files: in one folder per process.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include <unistd.h>

namespace mrsim::fuzz {

inline void require(bool condition) {
  if (!condition) std::abort();
}

inline const std::string& folder() {
  static const std::string path = [] {
    std::string name = "/tmp/mrsim-fuzz-XXXXXX";
    require(::mkdtemp(name.data()) != nullptr);
    return name;
  }();
  return path;
}

/// The path of the file.
inline std::string write(const char* name, std::string_view bytes) {
  const std::string path = folder() + "/" + name;
  std::FILE* file = std::fopen(path.c_str(), "wb");
  require(file != nullptr);
  if (!bytes.empty()) std::fwrite(bytes.data(), 1, bytes.size(), file);
  std::fclose(file);
  return path;
}

}  // namespace mrsim::fuzz
