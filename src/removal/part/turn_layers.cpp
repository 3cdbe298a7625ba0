#include "removal/part/turn_layers.h"

#include "core/numbers/units.h"
#include "core/numbers/vec.h"
#include "core/process/parallel.h"
#include "removal/field/lattice.h"

#include <algorithm>
#include <cmath>

namespace mrsim {
namespace {

// What one more interval costs, in sweeps evaluated at a voxel.
constexpr double kSplit = 5000;

// A few registers of voxels are as cheap as one.
constexpr double kFewVoxels = 32;

constexpr double kThinnestRing = 1e-6;  // mm

}  // namespace

class TurnLayers::Builder {
 public:
  Builder(const PartField& field, double voxel, double band, double z, Layer& out)
      : field_(field),
        tree_(field.sweeps().turn_tree()),
        voxel_(voxel),
        band_(band),
        z_(z),
        out_(out) {}

  // The interval [from, to], given the packs that can matter in it.
  void build(double from, double to, const TurnTree::Packs& packs) {
    const double half = 0.5 * (to - from), rho = from + half;
    const double slack = field_.slack(), reach = half + band_ + slack;
    const double stock = field_.solid().distance({rho, 0, z_});
    TurnTree::Nearest best;
    for (const std::uint32_t pack : packs) tree_.nearest(pack, rho, z_, best);
    if (stock > reach || best.distance < -reach) return add(to, ExactField::Region::air);
    const bool in_stock = stock < -reach;
    if (in_stock && best.distance > reach) return add(to, ExactField::Region::material);
    const TurnRegion region{{rho, z_}, {half, 0}};
    TurnTree::Packs left;
    tree_.narrow(region, best, reach, slack, packs, left);
    if (2 * half <= voxel_) {
      members_.clear();
      tree_.members(region, best, reach, slack, left, members_);
      const auto count = static_cast<double>(members_.size());
      const double voxels = std::max(kFewVoxels, 2 * kTwoPi * rho * half / (voxel_ * voxel_));
      if (count <= 1 || count * voxels <= kSplit || half < kThinnestRing) {
        return add_mixed(from, to, in_stock);
      }
    }
    build(from, rho, left);
    build(rho, to, left);
  }

 private:
  void add_mixed(double from, double to, bool in_stock) {
    out_.intervals.push_back({to, static_cast<std::uint32_t>(out_.members.size()),
                              static_cast<std::uint32_t>(members_.size()),
                              ExactField::Region::mixed, in_stock});
    for (const TurnMember& m : members_)
      out_.members.push_back(facing(tree_.turns(), m, from, to, z_, out_.sides));
  }
  void add(double to, ExactField::Region region) {
    std::vector<Interval>& list = out_.intervals;
    if (!list.empty() && list.back().region == region)
      list.back().end = to;
    else
      list.push_back({to, 0, 0, region, false});
  }

  const PartField& field_;
  const TurnTree& tree_;
  double voxel_, band_, z_;
  Layer& out_;
  std::vector<TurnMember> members_;
};

TurnLayers::TurnLayers(const PartField& field, double voxel, double band, int threads) {
  const Box3 whole = inflated(field.bounds(), band + voxel);
  first_ = static_cast<std::int32_t>(lattice_floor(voxel, whole.lo.z, kLatticeShift.z));
  const auto end = static_cast<std::int32_t>(lattice_floor(voxel, whole.hi.z, kLatticeShift.z) + 1);
  layers_.resize(static_cast<std::size_t>(end - first_));
  parallel_for(
      layers_.size(), threads,
      [&](std::size_t k) {
        const double z =
            lattice_position(voxel, first_ + static_cast<std::int32_t>(k), kLatticeShift.z);
        Builder(field, voxel, band, z, layers_[k])
            .build(0, whole.hi.x, field.sweeps().turn_tree().roots());
      },
      8);
}

const TurnLayers::Layer& TurnLayers::at(std::int32_t k) const {
  const bool known = k >= first_ && k - first_ < static_cast<std::int32_t>(layers_.size());
  return known ? layers_[static_cast<std::size_t>(k - first_)] : none_;
}

}  // namespace mrsim
