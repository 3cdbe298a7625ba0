// Moving the part onto the nominal before they are compared.
#pragma once

#include "compare/distance/nominal.h"
#include <mrsim/compare.h>

namespace mrsim {

/// A place moved by the transform, and a direction turned by it.
Vec3 apply(const RigidTransform& t, const Vec3& p);
Vec3 rotate(const RigidTransform& t, const Vec3& v);
/// First `b`, then `a`.
RigidTransform compose(const RigidTransform& a, const RigidTransform& b);
/// Vertices in double, rounded to float at the end.
TriMesh transformed(const TriMesh& mesh, const RigidTransform& t);
/// Angle of the rotation in radians.
double angle_of(const RigidTransform& t);

/// Moves the centre of the part's bounds onto that of the nominal's.
RigidTransform align_boxes(const Box3& part, const Box3& nominal);

/// The 24 turns by quarters about the axes, each with the boxes' centres on each other; the first
/// is align_boxes(). A shaft lies along Z on the lathe and along any axis in CAD.
std::vector<RigidTransform> quarter_turns(const Box3& part, const Box3& nominal);

/// Root mean square of the points' distances from the planes that are nearest to them, mm.
double rms_at(const std::vector<Vec3>& points, const NominalSurface& nominal,
              const RigidTransform& at, int threads = 0);

struct IcpResult {
  RigidTransform transform;
  double rms_before = 0, rms_after = 0;  ///< mm, of the points that count
  int steps = 0;
};

/// Point-to-plane ICP (Chen and Medioni 1992) of `points` from `start` on, with Tukey weights whose
/// width follows the median residual, so that a gouge does not pull the part. Directions in which
/// the surface slides on itself (a plate in its plane, a shaft about its axis) stay as they are:
/// the solve leaves out eigenvectors below 1e-6 of the largest. Deterministic: fixed order, no
/// random choice.
IcpResult icp(const std::vector<Vec3>& points, const NominalSurface& nominal,
              const RigidTransform& start, int threads = 0);

}  // namespace mrsim
