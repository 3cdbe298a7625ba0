// What a tool sweeps along one motion, as a signed distance in double: negative where the tool has
// been, zero set exact, 1-Lipschitz, exact outside wherever a closed form exists (docs/removal.md
// lists the forms and the error bound of the others).
//
// A motion is never chopped: one cutting motion, one sweep. Sweeps are kept by columns so that one
// point can be asked of many sweeps, or many points of one, at a few nanoseconds each.
#pragma once

#include <mrsim/types.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace mrsim {

struct SweepSample {
  double distance = 0;
  std::int32_t patch =
      0;  ///< smooth face of the sweep: equal for two points whose surfaces join without a crease
};

/// What the dominance test of the carver (DESIGN.md) needs to know of a sweep. Two sweeps may be
/// compared when their groups are equal and not negative: same tool, same kind.
struct SweepSkeleton {
  enum class Kind : std::uint8_t {
    none,   ///< nothing to compare (group -1)
    strip,  ///< a ball that reaches up: the sweep is the set within `radius` of the path's upward
            ///< strip, a convex set; p's nearest point on it decides
    plan    ///< horizontal or upright move: distance is a function of the lateral distance from the
            ///< path (growing) and of the height above the tip
  };
  Kind kind = Kind::none;
  bool rising = false;   ///< plan: a lower tip removes more (open top, no undercut); otherwise only
                         ///< sweeps at equal heights may be compared
  bool straight = true;  ///< plan: the path is a segment (its lateral distance is convex)
  std::int32_t group = -1;
  double radius = 0;  ///< strip: of the ball; plan: largest of the cutter
  double low = 0,
         high = 0;    ///< least and greatest height of the path (strip: of the ball's centre)
  double length = 0;  ///< 3-D length of the path
};

/// Columns that SweepTable::nearest fills, each as long as the list of sweeps.
struct NearestColumns {
  double* distance = nullptr;  ///< the same bits as distance(ids[k], p)
  double* squared = nullptr;   ///< strip: squared distance to the skeleton; plan: to the path in
                               ///< plan; none: +infinity
  double *x = nullptr, *y = nullptr, *z = nullptr;  ///< the nearest point; plan: z is the tip's
};

/// The cutting motions of a program with the shapes of their tools.
class SweepTable {
 public:
  /// Sweeps of every motion that cuts: lines and arcs, not rapids, not moves of assumed start, not
  /// zero-length ones of zero extent. `top` is the height (mm) up to which a milling cutter without
  /// flute length reaches: anything above the stock's top. Throws Error "tool-missing",
  /// "tool-invalid", "motion-unsupported", naming tool and line.
  SweepTable(std::span<const Motion> motions, std::span<const Tool> tools, double top);
  SweepTable(SweepTable&&) noexcept;
  SweepTable& operator=(SweepTable&&) noexcept;
  ~SweepTable();

  std::size_t size() const;
  /// Index of the motion that makes sweep i. Ascending in i.
  std::int32_t motion(std::size_t i) const;
  /// A box that holds sweep i; infinite towards the shank where the cutter reaches above the stock.
  Box3 bounds(std::size_t i) const;

  /// Signed distance of p from sweep i, mm.
  double distance(std::size_t i, const Vec3& p) const;
  SweepSample sample(std::size_t i, const Vec3& p) const;
  /// Unit gradient of distance(i, .) at p (out of the sweep), on the given patch where p lies on a
  /// crease.
  Vec3 gradient(std::size_t i, const Vec3& p, std::int32_t patch) const;

  /// Signed distance of p from the face `patch`, continued smoothly beyond its creases: what
  /// gradient(i, p, patch) is the gradient of. Positive outside of the sweep.
  double patch_distance(std::size_t i, const Vec3& p, std::int32_t patch) const;

  /// out[k] = distance(ids[k], p), the same bits.
  void distances(std::span<const std::uint32_t> ids, const Vec3& p, double* out) const;
  /// out[k] = distance(i, points[k]), the same bits.
  void distances(std::size_t i, std::span<const Vec3> points, double* out) const;

  SweepSkeleton skeleton(std::size_t i) const;
  /// Distances together with the nearest points of the skeletons. Cost: a little above distances().
  void nearest(std::span<const std::uint32_t> ids, const Vec3& p, const NearestColumns& out) const;

  /// Largest error of any distance in mm (rounding and minimisation), for the slack of pruning.
  double max_error() const;
  /// Smallest radius of any cutter or nose used (0 when none has one), for the default voxel.
  double smallest_radius() const;

 private:
  struct Columns;
  std::unique_ptr<Columns> columns_;
};

}  // namespace mrsim
