// The tool is the intersection of a mill that reaches up and one that reaches down. In its lower
// half its distance is that of the former, in its upper half that of the latter. Along the path the
// tool passes p at one position. On one side of it the tool is higher, and falls towards that
// position: the sweep of a mill that reaches up. On the other side the same holds upside down.
#include "removal/forms/disc_sweep.h"

#include "core/numbers/trig.h"
#include "core/numbers/units.h"
#include "removal/simd/scalar_forms.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mrsim {
namespace {

// What faces p: the lower half of the disc, or the upper one upside down.
struct DiscSide {
  double core = 0, round = 0;
  double edge = 0;  ///< height of the flat core above the tip
  double up = 1;    ///< -1: upside down
};

class DiscPath {
 public:
  DiscPath(const Profile::Disc& disc, const ToolPath& path, const Vec3& p)
      : path_(path),
        p_(p),
        low_{disc.core, disc.round, disc.round, 1},
        high_{disc.lid_core, disc.lid_round, disc.top - disc.lid_round, -1},
        rise_(path.rise.z),
        first_(path.center.z),
        middle_(0.5 * disc.top) {}

  PathSample least(double begin, double end) const {
    const double level = (p_.z - middle_ - first_) / rise_, passed = std::clamp(level, begin, end);
    const DiscSide &before = rise_ > 0 ? high_ : low_, &after = rise_ > 0 ? low_ : high_;
    if (begin == end) return turn(level > end ? before : after, begin, end);
    PathSample best;
    best.distance = std::numeric_limits<double>::infinity();
    // Towards the position where the tool passes p.
    if (passed > begin) best = turn(before, begin, passed);
    if (passed < end) {
      const PathSample other = turn(after, end, passed);
      if (other.distance < best.distance) best = other;
    }
    return best;
  }

 private:
  // The best position of the last turn: each position of an earlier turn has one below it in the
  // last.
  PathSample turn(const DiscSide& side, double from, double to) const {
    const double way = to > from ? 1 : -1;
    if (std::fabs(to - from) > kTwoPi) from = to - way * kTwoPi;
    const SinCos sc = sincos(from), angle = sincos(std::fabs(to - from));
    const Vec3 u = sc.cos * path_.u + sc.sin * path_.v;
    const Vec3 v = way * (sc.cos * path_.v - sc.sin * path_.u);
    HelixRecord r;
    r.x = path_.center.x, r.y = path_.center.y;
    r.z = side.up * (path_.center.z + from * rise_ + side.edge);
    r.ux = u.x, r.uy = u.y, r.vx = v.x, r.vy = v.y;
    r.radius = path_.radius, r.fall = std::fabs(rise_);
    r.core = side.core, r.round = side.round;
    r.end = {std::fabs(to - from), angle.sin, angle.cos};
    const lane::HelixLeast least = lane::helix_least(r, p_.x, p_.y, side.up * p_.z, true);
    return {least.distance, from + way * least.t};
  }

  const ToolPath& path_;
  const Vec3 p_;
  const DiscSide low_, high_;
  const double rise_;    // of the path, mm a radian
  const double first_;   // height of the tip at 0
  const double middle_;  // half the height of the disc
};

}  // namespace

bool is_disc_helix(const Profile& tool, const ToolPath& path) {
  return tool.disc() && path.arc && path.horizontal && path.rise.z != 0;
}

PathSample disc_minimum(const Profile& tool, const ToolPath& path, const Vec3& p, double begin,
                        double end) {
  return DiscPath(*tool.disc(), path, p).least(begin, end);
}

}  // namespace mrsim
