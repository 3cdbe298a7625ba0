// What a tool sweeps along one motion, as a signed distance in double: negative where the tool has
// been, zero set exact, 1-Lipschitz, exact outside wherever a closed form exists (docs/sweeps.md
// lists the forms and the error bound of the others).
//
// A motion is never chopped: one cutting motion, one sweep. Sweeps are kept by columns so that one
// point can be measured to many sweeps, or many points to one, at a few nanoseconds each.
#pragma once

#include "removal/columns/sweep_selection.h"
#include "removal/field/field.h"
#include "removal/forms/sweep_sample.h"
#include <mrsim/types.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace mrsim {

struct PointColumns;  // removal/simd/sweep_kernels.h
struct SweepColumns;  // removal/columns/sweep_columns.h
class TurnTree;       // removal/columns/turn_tree.h

/// The cutting motions of a program with the shapes of their tools.
class SweepTable {
 public:
  /// Sweeps of every motion that cuts: lines and arcs, not rapids, not moves of assumed start, not
  /// zero-length ones of zero extent, not threads that turning tools cut (no bodies of revolution).
  /// A milling cutter without flute length reaches up to infinity.
  /// Throws Error "tool-missing", "tool-invalid", "motion-unsupported", naming tool and line. A
  /// selection of shank or holder makes a sweep for each of its pieces, and none for tools without
  /// them; rapids without a tool are left out.
  SweepTable(std::span<const Motion> motions, std::span<const Tool> tools,
             const SweepSelection& selection = {}, int threads = 1);
  SweepTable(SweepTable&&) noexcept;
  SweepTable& operator=(SweepTable&&) noexcept;
  ~SweepTable();

  std::size_t size() const;
  /// What a list of all sweeps holds, ascending: the indices of milling sweeps, and above size()
  /// numbers of packs of turning sweeps, then of milling sweeps, none of them longer than
  /// `longest` mm. Lists of candidates (removal/prune) hold such numbers too.
  std::vector<std::uint32_t> all(double longest = std::numeric_limits<double>::infinity()) const;
  /// The sweeps of a list, packs expanded, whose bounds meet a box; ascending.
  std::vector<std::uint32_t> expanded(std::span<const std::uint32_t> list, const Box3& box) const;
  /// The sweeps of expanded() that may meet a bounded box. Bounds of turning sweeps are far larger
  /// than these sweeps, so their tree is asked. The cost grows with the sweeps about the box, not
  /// with the length of the list.
  std::vector<std::uint32_t> meeting(std::span<const std::uint32_t> list, const Box3& box) const;
  /// Index of the motion that makes sweep i. Never falls with i.
  std::int32_t motion(std::size_t i) const;
  /// A box that holds sweep (or pack) i; infinite towards the shank where the cutter reaches above
  /// the stock. A turning pack takes as many steps as it has sweeps.
  Box3 bounds(std::size_t i) const;

  /// Signed distance of p from sweep i, mm.
  double distance(std::size_t i, const Vec3& p) const;
  SweepSample sample(std::size_t i, const Vec3& p) const;
  /// sample(i, p).patch; `t`: Nearest::t, if the sweep is known to be nearest there.
  std::int32_t patch(std::size_t i, const Vec3& p, std::optional<double> t = {}) const;
  /// Unit gradient of distance(i, .) at p (out of the sweep), on the given patch where p lies on a
  /// crease.
  Vec3 gradient(std::size_t i, const Vec3& p, std::int32_t patch) const;

  /// Signed distance of p from the face `patch`, continued smoothly beyond its creases: what
  /// gradient(i, p, patch) is the gradient of. Positive outside of the sweep.
  double patch_distance(std::size_t i, const Vec3& p, std::int32_t patch) const;

  /// The face's plane for Newton's method: value and normal (field.h, face_plane).
  FacePlane face_plane(std::size_t i, const Vec3& p, std::int32_t patch) const;

  /// Encloses patch_distance(i, ., patch) on a triangle (field.h, patch_range).
  FaceRange patch_range(std::size_t i, const Corners3& t, std::int32_t patch) const;

  /// out[k] = distance(ids[k], p), the same bits.
  void distances(std::span<const std::uint32_t> ids, const Vec3& p, double* out) const;
  /// The same, but a distance that is more than `margin` mm above the least one may be any that is;
  /// that costs less where distances are found by a search.
  void near_distances(std::span<const std::uint32_t> ids, const Vec3& p, double margin,
                      double* out) const;

  /// The least distance of p from the sweeps of a list and whose it is, the lowest index of equal
  /// ones; infinite when the list is empty.
  struct Nearest {
    double distance = std::numeric_limits<double>::infinity();
    std::uint32_t sweep = 0;
    std::optional<double> t;  ///< where on a straight path, if that is known
  };
  /// `enough`: where a sweep is nearer than that, any such sweep will do.
  Nearest nearest(std::span<const std::uint32_t> list, const Vec3& p,
                  double enough = -std::numeric_limits<double>::infinity()) const;

  /// Brings the least distances at `points` up to date with the sweeps of a list, the same bits as
  /// distance().
  void least(std::span<const std::uint32_t> ids, PointColumns& points) const;

  /// All sweeps are the same at every angle about the Z axis: of inserts, and of other tools that
  /// move up and down on it.
  bool is_turned() const;
  /// The turning sweeps; empty where there are none.
  const TurnTree& turn_tree() const;
  /// What the table is made of, for pruning.
  const SweepColumns& columns() const { return *columns_; }

  /// What sweep i has cleared above p's column, where it is a horizontal or upright move of a
  /// cutter with a flat end and a straight wall: all from `z` up to `top`, infinite where the
  /// cutter reaches up, within `inside` mm of p in plan. None for others.
  struct FlatFloor {
    double z = 0, top = 0, inside = 0;
  };
  std::optional<FlatFloor> flat_floor(std::size_t i, const Vec3& p) const;

  /// Bytes that the table holds.
  std::size_t memory() const;
  /// Segments of paths by which sweeps are pruned (removal/columns/height_segments.h).
  std::size_t segments() const;

  /// Largest error of any distance in mm (rounding and minimisation), for the slack of pruning.
  double max_error() const;
  /// Smallest radius of any cutter or nose used (0 when none has one), for the default voxel.
  double smallest_radius() const;
  /// mm: no ball of a larger radius fits into the tool at rest. Infinite for turning.
  double ball_radius(std::size_t i) const;

 private:
  std::unique_ptr<SweepColumns> columns_;
};

}  // namespace mrsim
