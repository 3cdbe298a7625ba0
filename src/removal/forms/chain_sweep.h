// Straight moves of convex tools, almost without a search: the loops of chain_lanes.inl for one
// point.
#pragma once

#include "removal/field/field.h"
#include "removal/forms/tool_path.h"
#include "removal/simd/form_records.h"
#include "removal/tool/profile.h"

#include <cstdint>
#include <limits>
#include <optional>

namespace mrsim {

/// The tool as a chain of edges; count 0 where it is not convex, has too many edges, or has a
/// closed form of its own. Valid as long as `tool`.
ChainTool chain_tool(const Profile& tool);
/// Requires: a straight path, a chain.
ChainLine chain_line(const ChainTool& tool, const ToolPath& path);

/// The least distance and where it lies, up to 1e-13 of the size. Where it is above `limit`, any
/// distance above that, so that a search may end early.
PathSample chain_minimum(const ChainTool& tool, const ChainLine& line, const Vec3& p,
                         double limit = std::numeric_limits<double>::infinity());

/// The plane of the face `patch` at p, in closed form, if one cone, one cylinder or the ball at the
/// tip is all that can be nearest to p. None if it may be the rim of a disc, a torus or another
/// edge.
std::optional<FacePlane> chain_face(const ChainTool& tool, const ChainLine& line, const Vec3& p,
                                    std::int32_t patch);

}  // namespace mrsim
