// Files that are no programs at all, told by how they begin: one sentence instead of a hundred
// errors about their characters. Private to src/interp.
#pragma once

#include <cstdint>
#include <string_view>

namespace mrsim {

inline constexpr std::size_t kFileHead = 512;  ///< bytes that tell the kind of a file

/// What a file is that begins so ("a mesh (STL)"); empty where it may be a program. `size`: bytes
/// of the whole file, 0 where that is not known.
std::string_view kind_of_file(std::string_view head, std::uint64_t size);

}  // namespace mrsim
