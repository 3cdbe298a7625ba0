// Enclosures of the faces of a tool at rest: chains of lines and arcs that join smoothly.
#pragma once

#include "removal/field/face_range.h"
#include "removal/tool/profile.h"

#include <cstdint>

namespace mrsim {

/// Encloses Profile::face_distance() of all (r, z) in a section; infinite where the nearest edge of
/// the patch may change with a jump.
FaceRange profile_face_range(const Profile& profile, const Section& s, std::int32_t patch);

}  // namespace mrsim
