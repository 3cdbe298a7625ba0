#include "removal/collision/collision_view.h"

#include "core/numbers/vec.h"

namespace mrsim {

Vec3 out_of(const SweepTable& sweeps, std::uint32_t i, const Vec3& p) {
  return sweeps.gradient(i, p, sweeps.sample(i, p).patch);
}

double CollisionView::cut_distance(std::uint32_t cut, const Vec3& p) const {
  double d = 0;
  cut_distances(std::span(&cut, 1), p, &d);
  return d;
}

double CollisionView::mover_distance(std::uint32_t mover, const Vec3& p) const {
  double d = 0;
  mover_distances(std::span(&mover, 1), p, &d);
  return d;
}

// Moves p onto sweep i, along the normal of one face after another: beside a crease, two or three
// steps lead into it.
Vec3 drawn_onto(const SweepTable& sweeps, std::uint32_t i, const Vec3& p) {
  Vec3 q = p;
  for (int step = 0; step < 8; ++step) {
    const SweepSample at = sweeps.sample(i, q);
    if (at.distance <= 0) break;
    q = q - at.distance * sweeps.gradient(i, q, at.patch);
  }
  return q;
}

Vec3 SpaceView::out_of_stock(const Vec3& p) const {
  return part_.solid().gradient(p, part_.solid().sample(p).patch);
}

Vec3 SpaceView::out_of_cut(std::uint32_t cut, const Vec3& p) const {
  return out_of(part_.sweeps(), cut, p);
}

Vec3 SpaceView::out_of_mover(std::uint32_t mover, const Vec3& p) const {
  return out_of(movers_, mover, p);
}

}  // namespace mrsim
