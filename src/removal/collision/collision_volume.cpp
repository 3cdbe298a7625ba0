#include "removal/collision/collision_volume.h"

#include "core/numbers/vec.h"
#include "removal/collision/collision_depth.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace mrsim {
namespace {

constexpr std::size_t kMostVolumeBoxes = 1 << 12;  // of one size
constexpr double kVolumeShare = 0.04;              // of the volume: what the last boxes may hold

class VolumeSearch {
 public:
  VolumeSearch(const CollisionScene& scene, std::span<const std::uint32_t> movers, const Box3& box)
      : scene_(scene), movers_(movers), root_(box), flat_(box.lo.y == box.hi.y) {}

  double run();

 private:
  struct Node {
    Box3 box;
    Candidates cuts;
    // At the centre: mm outside of the nearest mover and of the stock, and within the deepest cut.
    double mover = 0, stock = 0, cut = 0;
    std::uint32_t nearest_mover = 0, deepest_cut = 0;
  };

  double size_of(const Box3& box) const;
  double share_within(const Node& node) const;
  bool crosses(Node& node);

  const CollisionScene& scene_;
  std::span<const std::uint32_t> movers_;
  Box3 root_;
  bool flat_;
  std::vector<double> distance_;
  double within_ = 0;  // mm^3 of the boxes that are met as a whole
};

double VolumeSearch::size_of(const Box3& box) const {
  const Vec3 size = box.hi - box.lo;
  if (!flat_) return size.x * size.y * size.z;
  return std::numbers::pi * (box.lo.x + box.hi.x) * size.x * size.z;
}

// The share of a box on the inner side of a plane, exact where the plane is square to an axis.
double inner_share(const Box3& box, double outside, const Vec3& normal) {
  const Vec3 size = box.hi - box.lo;
  const double across =
      std::abs(normal.x) * size.x + std::abs(normal.y) * size.y + std::abs(normal.z) * size.z;
  return std::clamp(0.5 - outside / across, 0.0, 1.0);
}

// The share of a node that collides, taking the surfaces in it as parallel planes: exact in a thin
// layer between two of them.
double VolumeSearch::share_within(const Node& node) const {
  const Vec3 p = 0.5 * (node.box.lo + node.box.hi);
  const StockSolid& solid = scene_.part.solid();
  double share = inner_share(node.box, node.stock, solid.gradient(p, solid.sample(p).patch)) - 1;
  share += inner_share(node.box, node.mover, out_of(scene_.movers.sweeps, node.nearest_mover, p));
  if (!node.cuts.empty())
    share += inner_share(node.box, node.cut, out_of(scene_.part.sweeps(), node.deepest_cut, p)) - 1;
  return std::max(share, 0.0);
}

// Whether a box has to be halved; adds those that lie within. Only cuts that reach into the box
// stay in its list: the sign in it depends on no other.
bool VolumeSearch::crosses(Node& node) {
  const Vec3 center = 0.5 * (node.box.lo + node.box.hi);
  const double radius = 0.5 * distance(node.box.lo, node.box.hi);
  node.mover = std::numeric_limits<double>::infinity();
  for (const std::uint32_t mover : movers_) {
    const double d = scene_.movers.sweeps.distance(mover, center);
    if (d < node.mover) node.mover = d, node.nearest_mover = mover;
  }
  node.stock = scene_.part.solid().distance(center);
  if (std::max(node.mover, node.stock) >= radius) return false;
  distance_.resize(node.cuts.size());
  scene_.part.sweeps().distances(node.cuts, center, distance_.data());
  node.cut = -std::numeric_limits<double>::infinity();
  std::size_t kept = 0;
  for (std::size_t k = 0; k < node.cuts.size(); ++k) {
    if (-distance_[k] > node.cut) node.cut = -distance_[k], node.deepest_cut = node.cuts[k];
    if (distance_[k] < radius) node.cuts[kept++] = node.cuts[k];
  }
  node.cuts.resize(kept);
  const double outside = std::max({node.mover, node.stock, node.cut});
  if (outside <= -radius) within_ += size_of(node.box);
  return std::abs(outside) < radius;
}

double VolumeSearch::run() {
  std::vector<Node> nodes;
  Node root{root_, cuts_before(scene_, scene_.movers.motions[movers_.front()], root_)};
  if (crosses(root)) nodes.push_back(std::move(root));
  for (;;) {
    double open = 0;
    for (const Node& node : nodes) open += size_of(node.box);
    if (open <= kVolumeShare * (within_ + open) || 2 * nodes.size() > kMostVolumeBoxes) break;
    std::vector<Node> next;
    for (const Node& node : nodes)
      for (const Box3& half : halves(node.box)) {
        Node one{half, node.cuts};
        if (crosses(one)) next.push_back(std::move(one));
      }
    nodes = std::move(next);
  }
  double volume = within_;
  for (const Node& node : nodes) volume += share_within(node) * size_of(node.box);
  return volume;
}

}  // namespace

double met_volume(const CollisionScene& scene, std::span<const std::uint32_t> movers,
                  const Box3& box) {
  return is_empty(box) ? 0 : VolumeSearch(scene, movers, box).run();
}

}  // namespace mrsim
