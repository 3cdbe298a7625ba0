// The distance from a tool that stands still, revolved about Z: its profile, for end mills by the
// closed form of a slab with a rounded edge.
#pragma once

#include "removal/tool/profile.h"

#include <cstdint>

namespace mrsim {

/// Distance of a revolved tool at rest from (rho, z), z above its tip.
ProfileSample tool_sample(const Profile& tool, double rho, double z);
double tool_distance(const Profile& tool, double rho, double z);
/// Gradient of one face of an end mill, that face continued beyond its edges.
Vec2 slab_face_gradient(const Profile& tool, double rho, double z, std::int32_t patch);
/// Signed distance to that face: what slab_face_gradient is the gradient of.
double slab_face_distance(const Profile& tool, double rho, double z, std::int32_t patch);

}  // namespace mrsim
