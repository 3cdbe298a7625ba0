// How deep a mover is in material: the deepest point of one mover, by branch and bound.
#pragma once

#include "removal/collision/collision_search.h"

namespace mrsim {

struct DeepPoint {
  double depth = 0;  ///< mm, never more than the mover's real depth
  Vec3 place;
};

/// The deepest point of the mover of a hit, beginning at the hit's own. The search ends when
/// nothing can be deeper by a 32nd, or after a few thousand boxes; then the best point is improved
/// in steps. `box` holds all places where the mover can meet material; flat in y for turned parts.
DeepPoint deepest_point(const CollisionScene& scene, const CollisionHit& hit, const Box3& box);

/// mm: how deep the place of a hit lies in the material of its moment, at most the mover's depth.
double depth_of_hit(const CollisionScene& scene, const CollisionHit& hit);

/// The cuts of motions up to `time` that come nearer to the box than any point in it can be deep,
/// ascending. Cost: that of the blocks about the box, whatever the length of the program.
Candidates cuts_before(const CollisionScene& scene, std::int32_t time, const Box3& box);

}  // namespace mrsim
