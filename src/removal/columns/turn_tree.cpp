#include "removal/columns/turn_tree.h"

#include "core/numbers/rounding.h"
#include "core/numbers/vec.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mrsim {
namespace {

// A pack up to this many times the size of a region goes into the region's list as a whole.
constexpr double kSmall = 8;

}  // namespace

TurnRegion turn_region(const Box3& box) {
  const double near_x = std::max({0.0, box.lo.x, -box.hi.x});
  const double near_y = std::max({0.0, box.lo.y, -box.hi.y});
  const double far_x = std::max(std::fabs(box.lo.x), std::fabs(box.hi.x));
  const double far_y = std::max(std::fabs(box.lo.y), std::fabs(box.hi.y));
  const double nearest = std::sqrt(near_x * near_x + near_y * near_y);
  const double farthest = std::sqrt(far_x * far_x + far_y * far_y);
  return {{0.5 * (nearest + farthest), 0.5 * (box.lo.z + box.hi.z)},
          {0.5 * (farthest - nearest), 0.5 * (box.hi.z - box.lo.z)}};
}

void TurnTree::append_sweeps(std::uint32_t pack, std::vector<std::uint32_t>& out) const {
  const Pack& p = packs_[pack / 2];
  for (std::uint32_t k = 0; k < kLanes && (p.lanes >> k & 1u) != 0; ++k) {
    if (p.leaf)
      out.push_back(items_[p.first + k].sweep);
    else
      append_sweeps(2 * (p.first + k), out);
  }
}

void TurnTree::measure(const Pack& pack, double x, double z, double* out) const {
  sweep_kernels().polygons(sides_.data() + pack.sides, pack.side_count, pack.round, x, z, out);
  for (std::size_t k = 0; pack.curved >> k != 0; ++k)
    if ((pack.curved >> k & 1u) != 0)
      out[k] = section_distance(turns_[items_[pack.first + k].row], {x, z});
}

// Depth first: the nearest child is searched to its leaves before its siblings are looked at.
void TurnTree::nearest(std::uint32_t pack, double rho, double z, Nearest& best) const {
  struct Waiting {
    double bound;
    std::uint32_t pack;
  };
  constexpr std::size_t kMostWaiting = 128;  // eight a tier; 2^32 sweeps make eleven tiers
  Waiting waiting[kMostWaiting];
  alignas(64) double d[kLanes];
  const bool behind = pack % 2 != 0;
  const double x = behind ? -rho : rho;
  std::size_t count = 0;
  waiting[count++] = {-kInfinity, pack / 2};
  while (count > 0) {
    const Waiting at = waiting[--count];
    if (at.bound > best.distance) continue;
    const Pack& p = packs_[at.pack];
    measure(p, x, z, d);
    const unsigned lanes = behind ? p.behind : p.lanes;
    const std::size_t from = count;
    for (std::uint32_t k = 0; lanes >> k != 0; ++k) {
      if ((lanes >> k & 1u) == 0 || d[k] > best.distance) continue;
      if (p.leaf) {
        const Item& item = items_[p.first + k];
        if (d[k] < best.distance || item.sweep < best.sweep)
          best = {d[k], item.sweep, item.row, behind};
        continue;
      }
      std::size_t slot = count++;
      for (; slot > from && waiting[slot - 1].bound < d[k]; --slot)
        waiting[slot] = waiting[slot - 1];
      waiting[slot] = {d[k], p.first + k};
    }
  }
}

// Finds the sweeps that may be nearest somewhere in a region. It drops a sweep i for one of two
// reasons. Either i is farther from the centre than a sweep that is nearest somewhere can be. Or
// the tangent plane of d_i at the centre lies above d_j at each corner, j being the sweep nearest
// to the centre: then it does between the corners, too, since it is linear and d_j is convex, and
// d_i lies above its tangent plane.
class TurnTree::Narrowing {
 public:
  Narrowing(const TurnTree& tree, const TurnRegion& region, const Nearest& best, double limit,
            double slack)
      : tree_(tree), region_(region), nearest_(best.distance), radius_(length(region.half)) {
    limit_ = std::min(limit, best.distance + 2 * radius_ + slack);
    if (best.sweep == ~0u) return;
    const TurnSweep& j = tree.turns_[best.row];
    if (j.arc) return;
    beaten_ = true;
    for (int k = 0; k < 4; ++k)
      corner_[k] = section_distance(j, seen(corner(k), best.behind)) + slack;
  }

  // Appends the packs that are left of a pack.
  void narrow(std::uint32_t pack, Packs& out) {
    const Pack& p = tree_.packs_[pack / 2];
    const unsigned kept = kept_lanes(pack);
    if (kept == 0) return;
    // A small pack stays whole: for each point one call measures all of its children.
    const bool one = (kept & (kept - 1)) == 0;
    if (p.leaf || (!one && tree_.size_[pack / 2] <= kSmall * radius_)) return out.push_back(pack);
    for (std::uint32_t k = 0; kept >> k != 0; ++k)
      if ((kept >> k & 1u) != 0) narrow(2 * (p.first + k) + pack % 2, out);
  }

  void members(std::uint32_t pack, std::vector<TurnMember>& out) {
    const Pack& p = tree_.packs_[pack / 2];
    const unsigned kept = kept_lanes(pack);
    for (std::uint32_t k = 0; kept >> k != 0; ++k) {
      if ((kept >> k & 1u) == 0) continue;
      if (!p.leaf) {
        members(2 * (p.first + k) + pack % 2, out);
        continue;
      }
      const Item& item = tree_.items_[p.first + k];
      out.push_back({item.sweep, item.row, pack % 2 != 0});
    }
  }

 private:
  // The children that may be nearest somewhere.
  unsigned kept_lanes(std::uint32_t pack) const {
    const Pack& p = tree_.packs_[pack / 2];
    const bool behind = pack % 2 != 0;
    const Vec2 q = seen(region_.center, behind);
    alignas(64) double d[kLanes];
    tree_.measure(p, q.x, q.y, d);
    const unsigned lanes = behind ? p.behind : p.lanes;
    unsigned kept = 0;
    for (std::uint32_t k = 0; lanes >> k != 0; ++k)
      if ((lanes >> k & 1u) != 0 && is_kept(p, k, behind, d[k])) kept |= 1u << k;
    return kept;
  }

  Vec2 corner(int k) const {
    return region_.center +
           Vec2{k & 1 ? region_.half.x : -region_.half.x, k & 2 ? region_.half.y : -region_.half.y};
  }

  static Vec2 seen(Vec2 q, bool behind) { return {behind ? -q.x : q.x, q.y}; }

  bool is_kept(const Pack& p, std::size_t lane, bool behind, double d) const {
    if (d > limit_) return false;
    if (!beaten_ || d <= nearest_ || (p.curved >> lane & 1u) != 0) return true;
    const Vec2 u = normal(p, lane, seen(region_.center, behind));
    double support = -kInfinity;
    for_each_side(p, lane,
                  [&](const ConvexPolygon::Side& s) { support = std::max(support, dot(u, s.a)); });
    for (int k = 0; k < 4; ++k)
      if (dot(u, seen(corner(k), behind)) - support - p.round[lane] <= corner_[k]) return true;
    return false;
  }

  template <typename Body>
  void for_each_side(const Pack& p, std::size_t lane, Body body) const {
    for (std::size_t i = p.sides; i < p.sides + p.side_count; ++i) {
      const PolygonSides& s = tree_.sides_[i];
      body(ConvexPolygon::Side{{s.ax[lane], s.ay[lane]}, {s.dx[lane], s.dy[lane]}, s.length[lane]});
    }
  }

  // Unit normal of the polygon where it is nearest to q. It need not be exact: the plane across any
  // direction that touches the polygon bounds the distance from below.
  Vec2 normal(const Pack& p, std::size_t lane, Vec2 q) const {
    double most = -kInfinity, least = kInfinity;
    Vec2 flat, off;
    for_each_side(p, lane, [&](const ConvexPolygon::Side& s) {
      const double n = side_of(s, q);
      if (n > most) most = n, flat = right_of(s.direction);
      if (n <= 0) return;
      const Vec2 w = q - foot_on(s, q);
      if (dot(w, w) < least) least = dot(w, w), off = w;
    });
    const double n = length(off);
    return most > 0 && n > 0 ? (1 / n) * off : flat;
  }

  const TurnTree& tree_;
  const TurnRegion& region_;
  double nearest_, radius_, limit_;
  bool beaten_ = false;
  std::array<double, 4> corner_{};
};

void TurnTree::narrow(const TurnRegion& region, const Nearest& best, double limit, double slack,
                      std::span<const std::uint32_t> in, Packs& out) const {
  out.clear();
  Narrowing narrowing(*this, region, best, limit, slack);
  for (const std::uint32_t pack : in) narrowing.narrow(pack, out);
}

void TurnTree::members(const TurnRegion& region, const Nearest& best, double limit, double slack,
                       std::span<const std::uint32_t> in, std::vector<TurnMember>& out) const {
  Narrowing narrowing(*this, region, best, limit, slack);
  for (const std::uint32_t pack : in) narrowing.members(pack, out);
}

}  // namespace mrsim
