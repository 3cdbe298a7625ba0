// The mesh as a scene for rays (Embree). Coordinates are taken about the middle of the mesh, so
// that a part far from the origin is drawn as sharp as one at it.
#pragma once

#include "core/numbers/vec.h"
#include <mrsim/types.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace mrsim {

struct RayHit {
  std::uint32_t face = 0;
  float u = 0, v = 0;   ///< barycentric weights of the second and third corner
  double distance = 0;  ///< mm
};

class RayScene {
 public:
  /// Requires: a triangle, indices in range.
  explicit RayScene(const TriMesh& mesh, int threads = 0);
  ~RayScene();
  RayScene(const RayScene&) = delete;
  RayScene& operator=(const RayScene&) = delete;

  /// The first triangle that a ray from `origin` along the unit `direction` meets.
  std::optional<RayHit> first_hit(const Vec3& origin, const Vec3& direction) const;
  /// Whether anything lies between `origin` and the point `length` mm along `direction`.
  bool is_blocked(const Vec3& origin, const Vec3& direction, double length) const;

 private:
  struct Embree;
  std::unique_ptr<Embree> embree_;
  std::vector<std::uint32_t> faces_;  ///< of the mesh, by Embree's numbers
  Vec3 center_;
};

}  // namespace mrsim
