// Branch and bound with the best bound first. With d_k the
// material at the mover's moment and c the mover, h(p) = -d_k(p) - max(0, d_c(p)) is at most the
// depth of the mover's nearest point, for any p; its greatest value is the depth searched for.
#include "removal/collision/collision_depth.h"

#include "core/numbers/vec.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mrsim {
namespace {

constexpr std::size_t kMostDepthBoxes = 4000;
constexpr double kDepthShare = 1.0 / 32;  // of the depth: what the boxes may leave undecided
constexpr double kFlat = 1.0 / 4;         // of its longest side: as thin as that a box is flat
constexpr double kFirstStep = 1.0 / 32;   // of the size of all: of the steps from the first hit
constexpr double kLongestStep = 0.25;     // mm: of these, so that few cuts matter about a point
constexpr double kLastStep = 1e-4;        // mm
constexpr double kNearest = 1e-3;         // of the distance: by which a nearest point may be missed

class DepthSearch {
 public:
  DepthSearch(const CollisionScene& scene, std::uint32_t mover, const Box3& box)
      : scene_(scene),
        mover_(mover),
        time_(scene.movers.motions[mover]),
        slack_(scene.rounding()),
        root_(box) {}

  DeepPoint run(const Vec3& seed);

 private:
  struct Node {
    double bound;  // of the depth in the box, mm
    std::size_t number;
    Box3 box;
    Candidates cuts;
    bool operator<(const Node& o) const {
      return bound != o.bound ? bound < o.bound : number > o.number;
    }
  };

  double material(const Vec3& p, std::span<const std::uint32_t> cuts);
  Vec3 nearest_of_mover(const Vec3& p, double away) const;
  double provable(const Vec3& p, std::span<const std::uint32_t> cuts);
  void try_faces(const Box3& box, std::span<const std::uint32_t> cuts);
  bool make_node(const Box3& box, std::span<const std::uint32_t> cuts, Node& node);
  void push(Node node);
  void branch();
  Candidates near(const Vec3& p, double reach);
  void improve(double step);

  const CollisionScene& scene_;
  std::uint32_t mover_;
  std::int32_t time_;
  double slack_;
  Box3 root_;
  std::vector<Node> heap_;
  std::size_t numbers_ = 0;
  std::vector<double> distance_;
  double best_ = -std::numeric_limits<double>::infinity();
  Vec3 place_;
};

// Depth of p in the material, -d_k, mm. Leaves the distances of the cuts in distance_.
double DepthSearch::material(const Vec3& p, std::span<const std::uint32_t> cuts) {
  distance_.resize(cuts.size());
  scene_.part.sweeps().distances(cuts, p, distance_.data());
  double least = -scene_.part.solid().distance(p);
  for (const double d : distance_) least = std::min(least, d);
  return least;
}

// The point of the mover that is nearest to p, which is `away` from it. Beside a sharp tip the
// normal of a flank does not lead there, but the slope of the distance does.
Vec3 DepthSearch::nearest_of_mover(const Vec3& p, double away) const {
  const SweepTable& sweeps = scene_.movers.sweeps;
  const Vec3 drawn = drawn_onto(sweeps, mover_, p);
  if (distance(drawn, p) <= away * (1 + kNearest) + kLastStep) return drawn;
  const double step = kNearest * away;
  const auto slope_along = [&](const Vec3& axis) {
    return sweeps.distance(mover_, p + step * axis) - sweeps.distance(mover_, p - step * axis);
  };
  const Vec3 slope{slope_along({1, 0, 0}), slope_along({0, 1, 0}), slope_along({0, 0, 1})};
  const double size = std::sqrt(dot(slope, slope));
  return size > 0 ? p - (away / size) * slope : drawn;
}

// h at p; keeps the best point so far, drawn onto the mover.
double DepthSearch::provable(const Vec3& p, std::span<const std::uint32_t> cuts) {
  const double depth = material(p, cuts);
  const double away = std::max(0.0, scene_.movers.sweeps.distance(mover_, p));
  if (depth - away > best_) {
    best_ = depth - away;
    place_ = away > 0 ? nearest_of_mover(p, away) : p;
  }
  return depth;
}

// Whether a box may hold something deeper; fills the node.
bool DepthSearch::make_node(const Box3& box, std::span<const std::uint32_t> cuts, Node& node) {
  const Vec3 center = 0.5 * (box.lo + box.hi);
  const double radius = 0.5 * distance(box.lo, box.hi);
  if (scene_.movers.sweeps.distance(mover_, center) > radius + slack_) return false;
  const double depth = provable(center, cuts);
  if (depth + radius <= scene_.threshold) return false;
  node.bound = depth + radius;
  node.box = box;
  node.cuts.clear();
  for (std::size_t k = 0; k < cuts.size(); ++k)
    if (distance_[k] <= depth + 2 * radius + slack_) node.cuts.push_back(cuts[k]);
  try_faces(box, node.cuts);
  return true;
}

// The boxes of a thin layer stay as thin as it is until they are short, so that all their middles
// lie in the middle of the layer; what lies deepest are its faces.
void DepthSearch::try_faces(const Box3& box, std::span<const std::uint32_t> cuts) {
  const Vec3 center = 0.5 * (box.lo + box.hi), half = 0.5 * (box.hi - box.lo);
  const double longest = std::max({half.x, half.y, half.z});
  for (int axis = 0; axis < 3; ++axis) {
    const double thick = component(half, axis);
    if (thick == 0 || thick > kFlat * longest) continue;
    const Vec3 off{axis == 0 ? thick : 0, axis == 1 ? thick : 0, axis == 2 ? thick : 0};
    provable(center - off, cuts), provable(center + off, cuts);
  }
}

void DepthSearch::push(Node node) {
  node.number = numbers_++;
  heap_.push_back(std::move(node));
  std::push_heap(heap_.begin(), heap_.end());
}

void DepthSearch::branch() {
  for (std::size_t boxes = 0; boxes < kMostDepthBoxes && !heap_.empty(); ++boxes) {
    std::pop_heap(heap_.begin(), heap_.end());
    const Node top = std::move(heap_.back());
    heap_.pop_back();
    if (top.bound <= best_ + std::max(scene_.threshold, kDepthShare * best_)) return;
    for (const Box3& half : halves(top.box)) {
      Node node;
      if (make_node(half, top.cuts, node)) push(std::move(node));
    }
  }
}

// The cuts that can decide within `reach` of p.
Candidates DepthSearch::near(const Vec3& p, double reach) {
  const Candidates cuts = cuts_before(scene_, time_, inflated(Box3{p, p}, reach));
  const double depth = material(p, cuts);
  Candidates kept;
  for (std::size_t k = 0; k < cuts.size(); ++k)
    if (distance_[k] <= depth + 2 * reach + slack_) kept.push_back(cuts[k]);
  return kept;
}

// Steps along axes and diagonals from the best point, halved when none helps.
void DepthSearch::improve(double step) {
  const double flat = root_.lo.y == root_.hi.y ? 0 : 1;
  const double reach = 8 * step;
  Vec3 from = place_;
  Candidates cuts = near(from, reach);
  while (step > kLastStep) {
    const double before = best_;
    const Vec3 at = place_;
    if (distance(at, from) > reach - 2 * step) cuts = near(from = at, reach);
    for (int x = -1; x <= 1; ++x)
      for (int y = -1; y <= 1; ++y)
        for (int z = -1; z <= 1; ++z)
          provable(at + step * Vec3{double(x), flat * y, double(z)}, cuts);
    if (best_ <= before + kLastStep) step /= 2;
  }
}

DeepPoint DepthSearch::run(const Vec3& seed) {
  const Candidates cuts = cuts_before(scene_, time_, root_);
  provable(seed, cuts);
  const double size = distance(root_.lo, root_.hi);
  improve(std::min(kFirstStep * size, kLongestStep));
  const double seeded = best_;
  Node root;
  if (make_node(root_, cuts, root)) push(std::move(root));
  branch();
  if (best_ > seeded) improve(std::max(scene_.threshold, kDepthShare * best_));
  return {best_, place_};
}

}  // namespace

double depth_of_hit(const CollisionScene& scene, const CollisionHit& hit) {
  const Vec3& p = hit.place;
  double depth = -scene.part.solid().distance(p);
  for (const std::uint32_t cut : cuts_before(scene, scene.movers.motions[hit.mover], {p, p}))
    depth = std::min(depth, scene.part.sweeps().distance(cut, p));
  return depth;
}

Candidates cuts_before(const CollisionScene& scene, std::int32_t time, const Box3& box) {
  const SweepTable& sweeps = scene.part.sweeps();
  const Vec3 center = 0.5 * (box.lo + box.hi);
  const double reach = 0.5 * distance(box.lo, box.hi);
  // How deep in the stock the box may reach: by the distance of its centre, and from each side.
  double deepest = reach - scene.part.solid().distance(center);
  const Box3& stock = scene.part.solid().bounds();
  for (int a = 0; a < 3; ++a)
    deepest = std::min({deepest, component(box.hi, a) - component(stock.lo, a),
                        component(stock.hi, a) - component(box.lo, a)});
  Box3 near = inflated(box, std::max(0.0, deepest));
  if (scene.turned) near.lo.y = near.hi.y = 0;
  Candidates cuts;
  const auto settle = [&cuts] {
    std::sort(cuts.begin(), cuts.end());
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  };
  for (const std::size_t block : scene.blocks.blocks_of(near)) {
    const Box3 of_block = scene.blocks.box(block);
    const Box3 here{max(of_block.lo, near.lo), min(of_block.hi, near.hi)};
    for (const std::uint32_t cut : sweeps.meeting(scene.blocks.sweeps(block), here))
      if (sweeps.motion(cut) <= time) cuts.push_back(cut);
    if (cuts.size() > 2 * sweeps.size()) settle();
  }
  settle();
  return cuts;
}

DeepPoint deepest_point(const CollisionScene& scene, const CollisionHit& hit, const Box3& box) {
  return DepthSearch(scene, hit.mover, box).run(hit.place);
}

}  // namespace mrsim
