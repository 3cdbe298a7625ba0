// The points of a block are halved until each is alone, with the cuts that can matter about them: a
// cut that clears them all drops those of later movers with all cuts after it, and one that reaches
// none of them is dropped.
#include "removal/collision/collision_probe.h"

#include "core/numbers/vec.h"
#include "core/process/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace mrsim {
namespace {

struct Probe {
  std::size_t block = 0;
  std::uint32_t mover = 0;
  Vec3 place;
};

// The middle of the mover, then those of the faces of its bounds: what a straight move leads with
// is among them.
constexpr std::array<std::array<int, 3>, 7> kLooked{
    {{0, 0, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};

constexpr double kInset = 4;  // thresholds: so far in the stock a point is deep enough

// Where to look from: within `box` and away from its sides, which may be the stock's.
Vec3 looked_at(const Box3& bounds, const Box3& box, double inset, const std::array<int, 3>& way) {
  Vec3 p;
  for (int a = 0; a < 3; ++a) {
    const double low = component(box.lo, a), high = component(box.hi, a);
    const double margin = std::min(inset, 0.5 * (high - low));
    const bool is_finite = std::isfinite(component(bounds.lo, a) + component(bounds.hi, a));
    const Box3& from = is_finite ? bounds : box;
    const double middle = 0.5 * (component(from.lo, a) + component(from.hi, a));
    const double wanted = middle + way[std::size_t(a)] * (component(from.hi, a) - middle);
    component(p, a) = std::max(low + margin, std::min(wanted, high - margin));
  }
  return p;
}

// Points of the mover that lie deep in the stock.
void add_probes(const CollisionScene& scene, std::uint32_t mover, const Box3& box,
                std::vector<Probe>& out) {
  const Box3 bounds = scene.movers.sweeps.bounds(mover);
  const double inset = kInset * scene.threshold;
  for (const auto& way : kLooked) {
    const Vec3 place = drawn_onto(scene.movers.sweeps, mover, looked_at(bounds, box, inset, way));
    if (scene.movers.sweeps.distance(mover, place) > scene.rounding() ||
        -scene.part.solid().distance(place) <= scene.threshold)
      continue;
    const std::size_t block = scene.blocks.find(place);
    if (block < scene.blocks.size()) out.push_back({block, mover, place});
  }
}

class BlockProber {
 public:
  BlockProber(const CollisionScene& scene, std::vector<CollisionHit>& hits)
      : scene_(scene), slack_(scene.rounding()), hits_(hits) {}

  void visit(std::span<Probe> probes, std::span<const std::uint32_t> cuts);

 private:
  std::int32_t time_of(const Probe& probe) const { return scene_.movers.motions[probe.mover]; }

  const CollisionScene& scene_;
  double slack_;
  std::vector<CollisionHit>& hits_;
};

void BlockProber::visit(std::span<Probe> probes, std::span<const std::uint32_t> cuts) {
  const SweepTable& sweeps = scene_.part.sweeps();
  Box3 bounds;
  std::int32_t last = -1;
  for (const Probe& probe : probes) {
    extend(bounds, probe.place);
    last = std::max(last, time_of(probe));
  }
  const Vec3 center = 0.5 * (bounds.lo + bounds.hi);
  const double radius = probes.size() == 1 ? 0 : 0.5 * distance(bounds.lo, bounds.hi);
  const auto end = std::partition_point(
      cuts.begin(), cuts.end(), [&](std::uint32_t cut) { return sweeps.motion(cut) <= last; });
  const auto earlier = cuts.first(static_cast<std::size_t>(end - cuts.begin()));
  std::vector<double> d(earlier.size());
  sweeps.distances(earlier, center, d.data());
  Candidates left;
  for (std::size_t k = 0; k < earlier.size(); ++k) {
    if (d[k] <= scene_.threshold - radius) {
      last = sweeps.motion(earlier[k]) - 1;
      break;
    }
    if (d[k] <= scene_.threshold + radius + slack_) left.push_back(earlier[k]);
  }
  const auto kept = std::partition(probes.begin(), probes.end(),
                                   [&](const Probe& probe) { return time_of(probe) <= last; });
  probes = probes.first(static_cast<std::size_t>(kept - probes.begin()));
  if (probes.empty()) return;
  if (probes.size() == 1 && radius == 0)
    return hits_.push_back({probes.front().mover, probes.front().place});
  const Vec3 size = bounds.hi - bounds.lo;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  std::sort(probes.begin(), probes.end(), [axis](const Probe& a, const Probe& b) {
    return std::tuple(component(a.place, axis), a.mover, a.place.x, a.place.y, a.place.z) <
           std::tuple(component(b.place, axis), b.mover, b.place.x, b.place.y, b.place.z);
  });
  const std::size_t half = (probes.size() + 1) / 2;
  visit(probes.first(half), left);
  if (half < probes.size()) visit(probes.subspan(half), left);
}

// Points of movers from `first` to before `end`, by their blocks.
std::vector<Probe> find_probes(const CollisionScene& scene, std::size_t first, std::size_t end,
                               const std::function<Box3(std::uint32_t mover)>& box_of,
                               int threads) {
  constexpr std::size_t kGrain = 64;
  std::vector<std::vector<Probe>> parts((end - first + kGrain - 1) / kGrain);
  parallel_for(parts.size(), threads, [&](std::size_t part) {
    const std::size_t begin = first + part * kGrain;
    for (std::size_t m = begin; m < std::min(end, begin + kGrain); ++m) {
      const auto mover = static_cast<std::uint32_t>(m);
      const Box3 box = box_of(mover);
      if (!is_empty(box)) add_probes(scene, mover, box, parts[part]);
    }
  });
  std::vector<Probe> probes;
  for (const std::vector<Probe>& part : parts)
    probes.insert(probes.end(), part.begin(), part.end());
  std::stable_sort(probes.begin(), probes.end(),
                   [](const Probe& a, const Probe& b) { return a.block < b.block; });
  return probes;
}

void ask_probes(const CollisionScene& scene, double near, std::vector<Probe> probes, int threads,
                std::vector<CollisionHit>& hits) {
  std::vector<std::size_t> begins;  // of the probes of each block that has some
  for (std::size_t i = 0; i < probes.size(); ++i)
    if (i == 0 || probes[i].block != probes[i - 1].block) begins.push_back(i);
  begins.push_back(probes.size());
  std::vector<std::vector<CollisionHit>> found(begins.size() - 1);
  parallel_for(found.size(), threads, [&](std::size_t k) {
    const std::size_t block = probes[begins[k]].block;
    const Candidates cuts = scene.part.sweeps().meeting(scene.blocks.sweeps(block),
                                                        inflated(scene.blocks.box(block), near));
    BlockProber(scene, found[k])
        .visit(std::span(probes).subspan(begins[k], begins[k + 1] - begins[k]), cuts);
  });
  for (const std::vector<CollisionHit>& block : found)
    hits.insert(hits.end(), block.begin(), block.end());
}

}  // namespace

std::vector<CollisionHit> probe_movers(const CollisionScene& scene, double near,
                                       const std::function<Box3(std::uint32_t mover)>& box_of,
                                       int threads) {
  constexpr std::size_t kAtOnce = 16'384;  // movers: their points take up to 20 MB
  const std::size_t movers = scene.movers.motions.size();
  std::vector<CollisionHit> hits;
  for (std::size_t first = 0; first < movers; first += kAtOnce) {
    const auto begin = static_cast<std::ptrdiff_t>(hits.size());
    ask_probes(scene, near,
               find_probes(scene, first, std::min(movers, first + kAtOnce), box_of, threads),
               threads, hits);
    std::sort(hits.begin() + begin, hits.end(), [](const CollisionHit& a, const CollisionHit& b) {
      return std::tie(a.mover, a.place.x, a.place.y, a.place.z) <
             std::tie(b.mover, b.place.x, b.place.y, b.place.z);
    });
    const auto same = [](const CollisionHit& a, const CollisionHit& b) {
      return a.mover == b.mover;
    };
    hits.erase(std::unique(hits.begin() + begin, hits.end(), same), hits.end());
  }
  return hits;
}

}  // namespace mrsim
