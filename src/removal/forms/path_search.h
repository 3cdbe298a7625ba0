// The least distance of a tool over its positions on a path, by a minimisation with a proven
// bracket, where there is no closed form.
#pragma once

#include "core/numbers/rounding.h"
#include "removal/forms/tool_path.h"
#include "removal/tool/profile.h"

namespace mrsim {

/// Over [begin, end] of the path. Error bound: kPathError; 1e-12 of the size for lines of convex
/// tools. Where nothing is nearer than `limit` mm, the distance may be any above it, which costs
/// less; the others are the same bits with any limit.
PathSample search_path(const Profile& tool, const ToolPath& path, const Vec3& p, double begin,
                       double end, double limit = kInfinity);

/// search_path() over the whole of a path with `lowest_turn`.
PathSample search_lowest_turn(const Profile& tool, const ToolPath& path, const Vec3& p,
                              double limit = kInfinity);

}  // namespace mrsim
