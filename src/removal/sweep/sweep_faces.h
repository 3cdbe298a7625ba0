// The faces of one sweep: which face (patch) is nearest to a point, its distance and its normal.
// Dispatched by the kind of the sweep; each function means what its namesake in SweepTable says.
#pragma once

#include "removal/columns/sweep_columns.h"
#include "removal/sweep/sweep_table.h"

namespace mrsim {

/// Where a point, in the tool's frame, lies in plan beside the path of a sweep that `grooves`.
struct GrooveSide {
  double off = 0;   ///< mm from the path, continued: to the left of a line, out of an arc
  Vec3 across;      ///< unit: the way in which `off` grows
  double most = 0;  ///< mm: how far `off` may go below 0 (to the centre of an arc)
};
/// Requires: ref.grooves. p in the tool's frame, mm.
GrooveSide groove_side(const SweepColumns& c, const SweepRef& ref, const Vec3& p);

/// Distance of p from sweep i, mm, and the face that is nearest.
SweepSample sweep_sample(const SweepColumns& c, std::size_t i, const Vec3& p);
/// The patch of a sweep along a straight path in the stock's frame, where t is the place of the
/// path that is nearest to p.
std::int32_t sweep_patch(const SweepColumns& c, std::size_t i, const Vec3& p, double t);
/// SweepTable::gradient(), patch_distance(), face_plane() and flat_floor().
Vec3 sweep_gradient(const SweepColumns& c, std::size_t i, const Vec3& p, std::int32_t patch);
double sweep_patch_distance(const SweepColumns& c, std::size_t i, const Vec3& p,
                            std::int32_t patch);
FacePlane sweep_face_plane(const SweepColumns& c, std::size_t i, const Vec3& p, std::int32_t patch);
std::optional<SweepTable::FlatFloor> flat_floor(const SweepColumns& c, std::size_t i,
                                                const Vec3& p);

/// Whether the face is the upright wall of a flat mill on a line that moves in plan: its distance
/// is that from the line in plan, a convex function of space.
bool is_moved_wall(const SweepColumns& c, std::size_t i, std::int32_t patch);

}  // namespace mrsim
