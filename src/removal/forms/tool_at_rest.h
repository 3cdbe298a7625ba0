// A revolved tool that stands still: the profile's distance, in closed form for mills with a
// straight wall.
#pragma once

#include "core/vec.h"
#include "removal/tool/tool.h"

#include <cstdint>

namespace mrsim {

/// Distance of a revolved tool at rest from (rho, z), z above its tip.
ProfileSample tool_sample(const Profile& tool, double rho, double z);
double tool_distance(const Profile& tool, double rho, double z);
/// Gradient of one face of a tool with is_rounded(), that face continued beyond its edges.
Vec2 slab_face_gradient(const Profile& tool, double rho, double z, std::int32_t patch);
/// Signed distance to that face: what slab_face_gradient is the gradient of.
double slab_face_distance(const Profile& tool, double rho, double z, std::int32_t patch);

}  // namespace mrsim
