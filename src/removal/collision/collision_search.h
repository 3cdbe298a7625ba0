// Where movers (parts of tools on their motions) meet the material that is there at the moment of
// their motion: a branch and bound over boxes with the bounds that 1-Lipschitz distances give
// (docs/collisions.md).
#pragma once

#include "core/numbers/rounding.h"
#include "removal/collision/collision_movers.h"
#include "removal/collision/collision_view.h"
#include "removal/part/block_index.h"
#include "removal/part/part_field.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace mrsim {

class PlanSearch;

struct CollisionScene {
  const PartField& part;     ///< stock and cuts
  const BlockIndex& blocks;  ///< of the cuts
  const Movers& movers;
  double threshold = 0;  ///< mm: what lies deeper collides
  double finest = 0;     ///< mm: half diagonal of the boxes that are not halved again
  double beside = 0;     ///< mm: so far beside a block its cuts are known, too
  bool turned = false;   ///< stock, cuts and movers are the same at every angle: y = 0 says it all

  double rounding() const {
    return 2 * (part.sweeps().max_error() + movers.sweeps.max_error()) + kRounding;
  }
};

/// A mover and a point of it that lies deeper than the threshold.
struct CollisionHit {
  std::uint32_t mover = 0;
  Vec3 place;
};

/// Finds the movers that collide within a box: all that do by more than threshold + 2 * finest, and
/// none that do by less than the threshold. One for each thread at a time.
class CollisionDetector {
 public:
  explicit CollisionDetector(const CollisionScene& scene);

  /// `cuts` and `movers`: those that reach the box, ascending. What is clear in plan is searched
  /// there alone: a wall that is touched is a line there, and a seam between cuts a point. One hit
  /// for each mover that collides, in an order that depends on the arguments alone.
  std::vector<CollisionHit> detect(const Box3& box, std::span<const std::uint32_t> cuts,
                                   std::span<const std::uint32_t> movers);

 private:
  struct Ball {
    Vec3 center;
    double radius;
  };
  // A box's own lists, and what was measured at its centre.
  struct Tier {
    Candidates cuts, movers;
    std::vector<double> cut_distance, mover_distance;
  };
  // A ball in which nothing collides, seen from a box's centre.
  struct ClearBall {
    Vec3 offset;        // to its centre
    double excess = 0;  // |offset|^2 - radius^2
  };
  // All between them is clear.
  struct Heights {
    double low = 0, high = 0;
  };
  // A cut near a box's centre, with its clear ball once that is asked for.
  struct NearCut {
    double distance = 0;
    std::uint32_t cut = 0;
    bool is_known = false;
    ClearBall clear;
  };

  Candidates left_in_plan(const Box3& box, std::span<const std::uint32_t> cuts,
                          std::span<const std::uint32_t> movers, std::vector<CollisionHit>& hits);
  template <class Doubt>
  Candidates search_in_plan(const PlanSearch& plan, const Box3& flat,
                            std::span<const std::uint32_t> movers, std::size_t most, Doubt&& doubt);
  std::optional<CollisionHit> hit_in_space(const CollisionHit& hit, const Box3& box,
                                           std::span<const std::uint32_t> cuts) const;
  void search(const CollisionView& view, const Box3& box, std::span<const std::uint32_t> cuts,
              std::span<const std::uint32_t> movers);
  void visit(const Box3& box, std::size_t tier, std::span<const std::uint32_t> cuts,
             std::span<const std::uint32_t> movers);
  void keep_movers(const Ball& ball, std::span<const std::uint32_t> movers, Tier& tier) const;
  void settle(const Ball& ball, double stock, std::span<const std::uint32_t> cuts, Tier& tier);
  void add_hit(std::uint32_t mover, const Vec3& place);
  void look_beside(const Ball& ball, const Tier& tier);
  double depth_at(const CollisionView& view, const Vec3& p, std::int32_t time,
                  std::span<const std::uint32_t> cuts) const;
  void add_cleared(Heights heights);
  void drop_over_floors(const Box3& box, Tier& tier);
  void drop_touching(const Ball& ball, double stock, Tier& tier);
  void add_clear_stock(const Ball& ball, double stock);
  void add_near(const NearCut& cut);
  void find_clear(const Ball& ball, double depth, NearCut& near) const;
  ClearBall clear_ball(const Vec3& offset, double radius) const;
  bool only_touches(const Ball& ball, std::uint32_t mover, double depth);

  const CollisionScene& scene_;
  double slack_;  // mm: rounding of a difference of two distances
  SpaceView space_;
  const CollisionView* view_ = &space_;
  double finest_ = 0;  // mm: half diagonal of the boxes that are not halved again
  std::array<Tier, 64> tiers_;
  std::vector<ClearBall> clear_;    // of all movers at their time
  std::vector<NearCut> near_cuts_;  // the nearest first
  std::vector<Heights> cleared_;    // over a box, by the cuts until now
  std::vector<CollisionHit> hits_;
  std::vector<char> done_;  // by place in the list of the whole box
  std::span<const std::uint32_t> all_cuts_, all_movers_;
};

/// The two halves of a box, across its longest side.
std::array<Box3, 2> halves(const Box3& box);

}  // namespace mrsim
