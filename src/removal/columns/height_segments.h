// Straight segments of the paths of milling tools, and the tools as a disc with a fillet, a cone
// and a wall: what the heights of sweeps are bounded with (docs/removal.md, Heights).
//
// Guarantee: a path is never farther than a segment's `eps` from the segment, at equal parameters.
// The bounds made of segments only drop sweeps; they never enter a distance.
#pragma once

#include "removal/simd/candidate_kernels.h"
#include "removal/simd/sweep_kernels.h"
#include <mrsim/types.h>

#include <cstddef>
#include <vector>

namespace mrsim {

class Profile;
struct ProfileRow;
struct ToolPath;

/// Whether the tool's underside is known from its tip: segments may be made of its moves.
bool has_heights(const Profile& tool);
/// The tool for the bounds. Tools that are no disc, fillet, cone and wall count as a cylinder, with
/// `lift` for what it is below them. Requires: has_heights().
HeightTool height_tool(const Profile& tool);

/// Record of a segment from a to b, which the path leaves by up to `eps`: start of the tip (x, y,
/// z; the lower end), unit direction (x, y) and length in plan, slope >= 0, eps; all mm.
LineRecord segment_record(const Vec3& a, const Vec3& b, double eps);
/// Appends the segments of a path. Appends none and returns false where it would need too many.
bool append_segments(const ToolPath& path, std::vector<LineRecord>& out);
bool append_segments(const ProfileRow& row, std::vector<LineRecord>& out);

}  // namespace mrsim
