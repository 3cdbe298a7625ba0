#include "removal/columns/turn_members.h"

#include "core/numbers/rounding.h"

#include <algorithm>
#include <array>

namespace mrsim {
namespace {

// How far two points lie beyond the line of a side. Between them that is linear: what holds for
// both holds for all between.
struct Beyond {
  double from = 0, to = 0;
  bool above(double x) const { return from > x && to > x; }
  bool below(double x) const { return from < x && to < x; }
  bool above(const Beyond& other) const {
    return from > other.from + kRounding && to > other.to + kRounding;
  }
};

}  // namespace

void append_sides(TurnRows turns, std::uint32_t sweep, std::uint32_t row,
                  std::vector<TurnMember>& out) {
  out.push_back({sweep, row, false});
  if (!turns[row].one_sided) out.push_back({sweep, row, true});
}

void least_of(TurnRows turns, std::span<const TurnMember> members, PointColumns& points) {
  const SweepKernels& kernels = sweep_kernels();
  for (const TurnMember& m : members) {
    const TurnSweep& s = turns[m.row];
    const std::vector<ConvexPolygon::Side>& sides = s.polygon.sides;
    if (!s.arc && !sides.empty()) {
      kernels.polygon_least(sides.data(), sides.size(), s.round, m.behind, m.sweep, points);
      continue;
    }
    for (std::size_t k = 0; k < points.count; ++k) {
      const double d = section_distance(s, {m.behind ? -points.x[k] : points.x[k], points.z[k]});
      if (d > points.least[k] || (d == points.least[k] && m.sweep > points.nearest[k])) continue;
      points.least[k] = d, points.nearest[k] = m.sweep;
    }
  }
}

// Keeps the sides of a polygon that can decide its distance somewhere between `from` and `to`.
// Outside the polygon only those sides decide that the point is beyond: a side is dropped if the
// whole way surely lies on the inner side of its line. Inside, the nearest line decides: a side is
// dropped if its line is farther than another one all the way.
FacingMember facing(TurnRows turns, const TurnMember& member, double from, double to, double z,
                    TurnSides& sides) {
  const TurnSweep& s = turns[member.row];
  FacingMember facing{member, static_cast<std::uint32_t>(sides.size()), 0, s.round};
  if (s.arc) return facing;
  const TurnSides& all = s.polygon.sides;
  std::vector<Beyond> beyond(all.size());
  const double sign = member.behind ? -1 : 1;
  for (std::size_t i = 0; i < all.size(); ++i)
    beyond[i] = {side_of(all[i], {sign * from, z}), side_of(all[i], {sign * to, z})};
  const bool outside =
      std::any_of(beyond.begin(), beyond.end(), [](const Beyond& b) { return b.above(kRounding); });
  const bool inside = std::all_of(beyond.begin(), beyond.end(),
                                  [](const Beyond& b) { return b.below(-kRounding); });
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (outside && beyond[i].below(-kRounding)) continue;
    if (inside && std::any_of(beyond.begin(), beyond.end(),
                              [&](const Beyond& b) { return b.above(beyond[i]); }))
      continue;
    sides.push_back(all[i]);
  }
  facing.count = static_cast<std::uint32_t>(sides.size()) - facing.first;
  return facing;
}

void least_of(TurnRows turns, std::span<const FacingMember> members, const TurnSides& sides,
              PointColumns& points) {
  const SweepKernels& kernels = sweep_kernels();
  for (const FacingMember& f : members)
    if (f.count > 0)
      kernels.polygon_least(sides.data() + f.first, f.count, f.round, f.member.behind,
                            f.member.sweep, points);
    else
      least_of(turns, std::span(&f.member, 1), points);
}

}  // namespace mrsim
