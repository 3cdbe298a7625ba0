// The part of a tool that a concave arc of its outline bounds, beside the tool's convex pieces
// (corner-rounding mills).
#pragma once

#include "removal/forms/tool_path.h"
#include "removal/tool/profile.h"

namespace mrsim {

struct ProfileEdge;

/// Looks for something nearer than `best` over [begin, end] of the path, where the nearest place of
/// the tool lies on `arc`, a concave one. Error bound: kPathError outside; inside the depth is no
/// larger than the true one.
PathSample search_fillet(const Profile& tool, const ProfileEdge& arc, const ToolPath& path,
                         const Vec3& p, double begin, double end, PathSample best);

}  // namespace mrsim
