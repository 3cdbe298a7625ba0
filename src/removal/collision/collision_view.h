// Distances as the search for collisions sees them: in space, or in plan (collision_plan.h).
#pragma once

#include "removal/collision/collision_movers.h"
#include "removal/part/part_field.h"

#include <cstdint>
#include <span>

namespace mrsim {

/// All distances are signed, in mm, negative inside, and 1-Lipschitz; directions have unit length.
class CollisionView {
 public:
  CollisionView() = default;
  CollisionView(const CollisionView&) = delete;
  CollisionView& operator=(const CollisionView&) = delete;
  virtual ~CollisionView() = default;

  virtual double stock_distance(const Vec3& p) const = 0;
  virtual Vec3 out_of_stock(const Vec3& p) const = 0;

  /// One distance for each of the ascending list, in its order.
  virtual void cut_distances(std::span<const std::uint32_t> cuts, const Vec3& p,
                             double* out) const = 0;
  virtual void mover_distances(std::span<const std::uint32_t> movers, const Vec3& p,
                               double* out) const = 0;
  double cut_distance(std::uint32_t cut, const Vec3& p) const;
  double mover_distance(std::uint32_t mover, const Vec3& p) const;
  virtual Vec3 out_of_cut(std::uint32_t cut, const Vec3& p) const = 0;
  virtual Vec3 out_of_mover(std::uint32_t mover, const Vec3& p) const = 0;
  /// No ball of a larger radius fits into the cut's tool at rest.
  virtual double cut_radius(std::uint32_t cut) const = 0;
  /// A point of the mover near p, on its surface unless p is in it.
  virtual Vec3 drawn_onto(std::uint32_t mover, const Vec3& p) const = 0;
};

/// The direction that leads out of sweep i at p.
Vec3 out_of(const SweepTable& sweeps, std::uint32_t i, const Vec3& p);
/// A point of sweep i near p, on its surface unless p is in it.
Vec3 drawn_onto(const SweepTable& sweeps, std::uint32_t i, const Vec3& p);

class SpaceView final : public CollisionView {
 public:
  SpaceView(const PartField& part, const SweepTable& movers) : part_(part), movers_(movers) {}

  double stock_distance(const Vec3& p) const override { return part_.solid().distance(p); }
  Vec3 out_of_stock(const Vec3& p) const override;
  void cut_distances(std::span<const std::uint32_t> cuts, const Vec3& p,
                     double* out) const override {
    part_.sweeps().distances(cuts, p, out);
  }
  void mover_distances(std::span<const std::uint32_t> movers, const Vec3& p,
                       double* out) const override {
    movers_.distances(movers, p, out);
  }
  Vec3 out_of_cut(std::uint32_t cut, const Vec3& p) const override;
  Vec3 out_of_mover(std::uint32_t mover, const Vec3& p) const override;
  double cut_radius(std::uint32_t cut) const override { return part_.sweeps().ball_radius(cut); }
  Vec3 drawn_onto(std::uint32_t mover, const Vec3& p) const override {
    return mrsim::drawn_onto(movers_, mover, p);
  }

 private:
  const PartField& part_;
  const SweepTable& movers_;
};

}  // namespace mrsim
