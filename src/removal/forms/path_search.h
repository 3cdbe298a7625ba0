// The least distance of a tool over its positions on a path, by a minimisation with a proven
// bracket, where there is no closed form.
#pragma once

#include "removal/forms/tool_path.h"
#include "removal/tool/profile.h"

namespace mrsim {

/// Over [begin, end] of the path. Error bound: kPathError; 1e-12 of the size for lines of convex
/// tools.
PathSample search_path(const Profile& tool, const ToolPath& path, const Vec3& p, double begin,
                       double end);

/// search_path() over the whole of a path with `lowest_turn`.
PathSample search_lowest_turn(const Profile& tool, const ToolPath& path, const Vec3& p);

}  // namespace mrsim
