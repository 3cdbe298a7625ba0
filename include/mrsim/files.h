/// mrsim: files that a run reads and writes, as the other headers speak of them.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace mrsim {

/// Takes the bytes of a file, in order.
using ByteSink = std::function<void(const void* data, std::size_t size)>;

/// A file and what it is to a run, as messages call it: {"part.stl", "-o"}.
struct NamedPath {
  std::string path, role;
};

}  // namespace mrsim
