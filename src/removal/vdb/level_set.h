// The distance grid of a .vdb file that another program has made, or written again.
#pragma once

#include "removal/part/level_set_surface.h"

#include <string>

namespace mrsim {

/// The level set of a file, or its only grid of floats, with the surface where it is zero. One
/// thread. Throws Error "vdb-unreadable", without the file's name, where there is none.
LevelSetSurface read_level_set(const std::string& path);

}  // namespace mrsim
