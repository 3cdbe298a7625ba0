// The surface that the circle of a tool's corner draws on a slanted line or a helix about Z. Its
// section at each height is that circle: it is a sheared cylinder, whose tangent planes need no
// search.
#pragma once

#include "core/numbers/vec.h"
#include "removal/columns/path_column.h"
#include "removal/field/field.h"

#include <optional>

namespace mrsim {

/// A corner of a tool's profile.
struct CornerCircle {
  Vec2 at;       ///< radius and height above the tip, mm
  int side = 0;  ///< Profile::corner_side()
};

/// The plane that touches the surface near p, the path's row being given: normal out of the tool,
/// distance of p, to first order. Newton's method on it leads to the surface. Beside the path a
/// floor goes on as a plane. None where the path is nearly horizontal or an arc in another plane.
std::optional<FacePlane> sheared_cylinder(const PathColumn& paths, std::size_t row,
                                          const CornerCircle& corner, const Vec3& p);

}  // namespace mrsim
