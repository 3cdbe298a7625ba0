// Where a path leads through links.
#pragma once

#include <filesystem>

namespace mrsim {

/// Links that a path may lead through, as the system allows.
inline constexpr int kMostLinks = 40;

/// Absolute, all links followed; parts that do not exist stay as they are. `path` itself where that
/// fails, as in a ring of links.
std::filesystem::path real_path(const std::filesystem::path& path);

/// Whether `file` is in `folder` or below it; both are real paths.
bool lies_in(const std::filesystem::path& file, const std::filesystem::path& folder);

}  // namespace mrsim
