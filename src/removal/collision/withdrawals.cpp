#include "removal/collision/withdrawals.h"

#include "core/numbers/motions.h"
#include "core/numbers/vec.h"
#include "removal/collision/collision_movers.h"
#include "removal/tool/polygon.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace mrsim {
namespace {

constexpr std::size_t kMostRapids = 4;     // withdrawals in a row: aside, back, and in between
constexpr double kSine = 0.1736481776669;  // of 10 degrees

// Whether unit direction u leads from corner b of the polygon a, b, c (counter-clockwise) into the
// polygon, or past a side of it at no more than the angle of kSine.
bool leads_in(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& u) {
  const Vec2 to_c = (1 / length(c - b)) * (c - b), to_a = (1 / length(a - b)) * (a - b);
  const auto past = [&u](const Vec2& side, double outside) {
    return dot(u, side) > 0 && outside <= kSine;
  };
  const double beyond_c = -cross(to_c, u), beyond_a = cross(to_a, u);
  if (beyond_c <= 0 && beyond_a <= 0) return true;
  return (beyond_c > 0 && past(to_c, beyond_c)) || (beyond_a > 0 && past(to_a, beyond_a));
}

}  // namespace

const InsertOutline& Withdrawals::insert(int tool) {
  const auto [at, added] = inserts_.try_emplace(tool);
  if (added) at->second = make_insert(tools_[static_cast<std::size_t>(tool)]);
  return at->second;
}

// How many rapids in a row, this one included, follow the last cut of the same tool; 0: there is no
// such cut, or there are too many.
std::size_t Withdrawals::rapids_since_cut(std::size_t at) const {
  std::size_t rapids = 0;
  Vec3 from = motions_[at].start;
  for (std::size_t i = at + 1; i-- > 0 && rapids <= kMostRapids;) {
    const Motion& m = motions_[i];
    if (i != at && !moves(m)) continue;
    if (m.tool != motions_[at].tool || m.assumed_start) return 0;
    if (i != at && distance(m.end, from) > kSameTip) return 0;
    if (m.kind != MotionKind::rapid) return rapids;
    from = m.start;
    ++rapids;
  }
  return 0;
}

bool Withdrawals::follows_cut(std::size_t at) {
  const Motion& m = motions_[at];
  if (m.tool < 0 || !is_turning(tools_[static_cast<std::size_t>(m.tool)].type)) return false;
  if (m.start.x < 0 || m.end.x < 0) return false;  // works behind the axis
  return insert(m.tool).core.size() > 2 && rapids_since_cut(at) > 0;
}

bool Withdrawals::withdraws(std::size_t at, const Vec3& place, double touch) {
  const Motion& m = motions_[at];
  const InsertOutline& insert = this->insert(m.tool);
  const Vec2 start{m.start.x, m.start.z};
  const Vec2 met = Vec2{std::sqrt(place.x * place.x + place.y * place.y), place.z} - start;
  if (polygon_distance(make_polygon(insert.core), met) <= insert.round + touch) return true;
  if (rapids_since_cut(at) != 1) return false;
  const std::vector<Vec2>& p = insert.core;
  const std::size_t n = p.size();
  std::size_t near = 0;
  for (std::size_t i = 1; i < n; ++i)
    if (length(p[i] - met) < length(p[near] - met)) near = i;
  const Vec2 way = Vec2{m.end.x, m.end.z} - start;
  return leads_in(p[(near + n - 1) % n], p[near], p[(near + 1) % n], (1 / length(way)) * way);
}

}  // namespace mrsim
