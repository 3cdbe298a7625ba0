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

/// What the dominance test of the carver (DESIGN.md) needs to know of a sweep. Within a ball of
/// radius r about p, sweep i is never nearer than j when their groups are equal and not negative,
/// i is convex, and squared_i - squared_j >= 2 r |q_i - q_j| + r^2 for their nearest points q; for
/// plan also only if the tip of j is no higher (rising) or as high (otherwise), r in plan.
struct SweepSkeleton {
  enum class Kind : std::uint8_t {
    none,     ///< nothing to compare
    strip,    ///< ball that reaches up, any line: all points within `radius` of the path's upward
              ///< strip
    section,  ///< insert on a line: all points within `radius` (of the nose) of a convex polygon in
              ///< (rho, z), turned. The polygon is filled, its distance inside is 0: compare only
              ///< where squared_j > r^2
    plan      ///< horizontal or upright move: the distance grows with the lateral distance from the
              ///< path, and depends besides on the height above the tip alone
  };
  Kind kind = Kind::none;
  bool rising = false;      ///< plan: open top, no undercut; a lower tip removes more
  bool convex = true;       ///< of the skeleton, or of the path in plan: false for arcs
  std::int32_t group = -1;  ///< same tool, same kind; -1 = none
  double radius = 0;  ///< strip: of the ball; section: of the nose; plan: largest of the cutter
  double low = 0, high = 0;  ///< strip: heights of the ball's centre; plan: of the tip; mm
  double length = 0;         ///< of the path, mm
  double flat = 0;           ///< plan: radius of the flat end, 0 = none, mm
};

/// Columns that SweepTable::nearest fills, each as long as the list of sweeps.
struct NearestColumns {
  double* distance = nullptr;  ///< the same bits as distance(ids[k], p)
  double* squared = nullptr;   ///< squared distance to the skeleton, for plan to the path in plan;
                               ///< infinite for none
  double *x = nullptr, *y = nullptr, *z = nullptr;  ///< nearest point; section: (rho, 0, z); plan:
                                                    ///< z is that of the tip
};

/// Which motions and which part of the tools a table holds. The default is what removes material;
/// the others are asked for collisions: rapids with any part, and shank and holder on all moves.
struct SweepSelection {
  enum class Part : std::uint8_t { cutter, shank, holder };
  Part part = Part::cutter;
  bool cuts = true;     ///< lines and arcs
  bool rapids = false;  ///< rapids, as straight lines
};

/// The cutting motions of a program with the shapes of their tools.
class SweepTable {
 public:
  /// Sweeps of every motion that cuts: lines and arcs, not rapids, not moves of assumed start, not
  /// zero-length ones of zero extent. `top` is the height (mm) up to which a milling cutter without
  /// flute length reaches: anything above the stock's top. Throws Error "tool-missing",
  /// "tool-invalid", "motion-unsupported", naming tool and line. A selection of shank or holder
  /// makes a sweep for each of its pieces, and none for tools without them; rapids without a tool
  /// are left out.
  SweepTable(std::span<const Motion> motions, std::span<const Tool> tools, double top,
             const SweepSelection& selection = {});
  SweepTable(SweepTable&&) noexcept;
  SweepTable& operator=(SweepTable&&) noexcept;
  ~SweepTable();

  std::size_t size() const;
  /// Index of the motion that makes sweep i. Never falls with i.
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
