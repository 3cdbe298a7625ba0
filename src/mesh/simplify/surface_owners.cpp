#include "mesh/simplify/surface_owners.h"

#include <cmath>
#include <utility>

namespace mrsim::detail {
namespace {

constexpr int kHalvings = 24;  ///< of a part, to its border

}  // namespace

std::optional<FieldSample> SurfaceOwners::face_at(const Vec3& p, std::int32_t& cell) const {
  cell = tree_.locate(p, cell);
  const FieldSample s = tree_.sample_at(p, cell);
  if (std::abs(s.distance) > surface_band(p)) return {};
  return s;
}

bool SurfaceOwners::reaches(std::int32_t owner, const Vec3& p) const {
  if (owner == kStockOwner) return false;
  const std::uint32_t only = field_.candidate(owner);
  return std::abs(field_.sample(p, {&only, 1}).distance) <= surface_band(p);
}

std::optional<Vec3> SurfaceOwners::change(const Place& from, const Place& to, std::int32_t cell,
                                          const Vec3& shift) const {
  Place first = from, last = to;
  if (!halve_between(first, last) || !has_owner(first, cell) || !has_owner(last, cell)) {
    first = from, last = to;  // a third owner lies between
    for (int i = 0; i < kHalvings; ++i) {
      const Vec3 middle = 0.5 * (first.p + last.p);
      const std::optional<FieldSample> s = face_at(middle, cell);
      if (!s) return {};
      (s->owner == from.owner ? first : last).p = middle;
    }
  }
  const Vec3 p = 0.5 * (first.p + last.p) + shift;
  return face_at(p, cell) ? std::optional<Vec3>(p) : std::nullopt;
}

bool SurfaceOwners::has_owner(const Place& place, std::int32_t cell) const {
  const std::optional<FieldSample> s = face_at(place.p, cell);
  return s && s->owner == place.owner;
}

// Bisects between the two, by these two sweeps alone. False where neither is on the surface at a
// point of it.
bool SurfaceOwners::halve_between(Place& from, Place& to) const {
  std::uint32_t both[2];
  std::size_t count = 0;
  for (const std::int32_t owner : {from.owner, to.owner})
    if (owner != kStockOwner) both[count++] = field_.candidate(owner);
  if (count == 2 && both[1] < both[0]) std::swap(both[0], both[1]);
  for (int i = 0; i < kHalvings; ++i) {
    const Vec3 p = 0.5 * (from.p + to.p);
    const FieldSample s = field_.sample(p, {both, count});
    if (std::abs(s.distance) > surface_band(p)) return false;
    (s.owner == from.owner ? from : to).p = p;
  }
  return true;
}

}  // namespace mrsim::detail
