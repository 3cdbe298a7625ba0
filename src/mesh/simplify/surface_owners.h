// Which owner has a place on the surface, and where it changes between two places.
#pragma once

#include "mesh/cells/octree.h"

#include <cstdint>
#include <optional>

namespace mrsim::detail {

class SurfaceOwners {
 public:
  SurfaceOwners(const ExactField& field, const CellOctree& tree) : field_(field), tree_(tree) {}

  /// The sample that names the face at p; nothing if the surface does not pass p. `cell`: one near
  /// p, then the one of p.
  std::optional<FieldSample> face_at(const Vec3& p, std::int32_t& cell) const;

  /// Whether this owner's face passes p, too. If the faces of two owners pass both of two places,
  /// two passes have cut one wall and rounding picks the owner: there is no border between the
  /// places.
  bool reaches(std::int32_t owner, const Vec3& p) const;

  struct Place {
    Vec3 p;
    std::int32_t owner = 0;
  };
  /// The point between two places at which the owner changes from the first one's, moved by
  /// `shift`; nothing where that is off the surface. Costs 24 samples of two sweeps, and up to as
  /// many of all where a third owner lies between.
  std::optional<Vec3> change(const Place& from, const Place& to, std::int32_t cell,
                             const Vec3& shift) const;

 private:
  bool halve_between(Place& from, Place& to) const;
  bool has_owner(const Place& place, std::int32_t cell) const;

  const ExactField& field_;
  const CellOctree& tree_;
};

}  // namespace mrsim::detail
