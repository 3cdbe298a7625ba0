// Cuts and movers as seen from above. Where a mill has cleared all from some height up, whether the
// way of a mover above that height is clear can be seen in plan (docs/collisions.md, In plan).
#pragma once

#include "removal/collision/collision_view.h"
#include "removal/sweep/plan_path.h"

#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

namespace mrsim {

struct CollisionScene;

/// Sweeps by their indices, which ascend.
struct PlanPaths {
  std::vector<std::uint32_t> sweeps;
  std::vector<PlanPath> paths;

  const PlanPath& of(std::uint32_t sweep) const;
};

/// Distances in plan, whatever the height. The stock is the rectangle about it.
class PlanView final : public CollisionView {
 public:
  PlanView(const Box3& stock, PlanPaths cuts, PlanPaths movers)
      : stock_(stock), cuts_(std::move(cuts)), movers_(std::move(movers)) {}
  const std::vector<std::uint32_t>& cuts() const { return cuts_.sweeps; }

  double stock_distance(const Vec3& p) const override;
  Vec3 out_of_stock(const Vec3& p) const override;
  void cut_distances(std::span<const std::uint32_t> cuts, const Vec3& p,
                     double* out) const override;
  void mover_distances(std::span<const std::uint32_t> movers, const Vec3& p,
                       double* out) const override;
  Vec3 out_of_cut(std::uint32_t cut, const Vec3& p) const override { return cuts_.of(cut).out(p); }
  Vec3 out_of_mover(std::uint32_t mover, const Vec3& p) const override {
    return movers_.of(mover).out(p);
  }
  double cut_radius(std::uint32_t cut) const override { return cuts_.of(cut).radius; }
  Vec3 drawn_onto(std::uint32_t mover, const Vec3& p) const override;

 private:
  Box3 stock_;
  PlanPaths cuts_, movers_;
};

/// From one height to another, mm.
struct PlanLayer {
  double bottom = 0, top = 0;
};

/// Movers of one lowest height, or nearly so, and layers from there up to the stock's top: a mover
/// that is clear in each layer is clear.
struct PlanGroup {
  double lowest = 0;  ///< mm
  Box3 bounds;        ///< of the movers
  PlanPaths movers;
  std::vector<PlanLayer> layers;
};

/// Groups of movers, and the movers that no layers show clear.
struct PlanGroups {
  std::vector<PlanGroup> groups;
  std::vector<std::uint32_t> others;
};

/// The movers that can be searched in plan.
class PlanSearch {
 public:
  /// `cuts` and `movers` ascend.
  PlanSearch(const CollisionScene& scene, std::span<const std::uint32_t> cuts,
             std::span<const std::uint32_t> movers);

  /// The movers that can be seen in plan, ascending; how many lowest heights they have.
  std::vector<std::uint32_t> movers() const;
  std::size_t heights() const;
  /// The movers that cannot be seen in plan, without those that only touch the stock's top;
  /// ascending.
  const std::vector<std::uint32_t>& others() const { return others_; }

  /// Groups of some of movers() by their heights, one for each height or about `most` of them. A
  /// group of several heights counts from its lowest: fewer groups are faster and show fewer movers
  /// clear. Cost: cuts x groups.
  PlanGroups groups(std::span<const std::uint32_t> movers, std::size_t most) const;
  /// Cuts near the group, as wide as at the bottom of a layer, and its movers as wide as at the
  /// top.
  PlanView view(const PlanGroup& group, const PlanLayer& layer) const;

 private:
  struct Lifted {
    double lowest = 0;  // mm
    Box3 bounds;
    std::uint32_t mover = 0;
    PlanPath path;
  };
  void take_cuts(std::span<const std::uint32_t> cuts);
  void lift_nose(Lifted& mover) const;
  PlanGroup group_of(std::span<Lifted> movers) const;
  bool add_layers(PlanGroup& group) const;
  double lift_of(const PlanGroup& group, double round) const;
  double reach(const PlanGroup& group, double bottom, double least, double end) const;
  bool is_near(const PlanGroup& group, std::size_t cut) const;

  const CollisionScene& scene_;
  double touch_, top_;  // mm; the stock's
  PlanPaths cuts_;
  std::vector<Box3> bounds_;                                               // of the cuts
  std::map<std::pair<double, double>, std::vector<std::size_t>> plunges_;  // by place, into cuts_
  std::vector<Lifted> lifted_;                                             // by mover
  std::vector<std::uint32_t> others_;
};

}  // namespace mrsim
