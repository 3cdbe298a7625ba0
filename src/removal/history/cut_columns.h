// The history of a block whose sweeps are closed upwards: one that holds a point holds everything
// above it. Upright cutters that reach above the stock and nowhere narrow leave such sweeps. Their
// distances do not grow upwards, so each column is cut from its top down: a sweep is evaluated at
// the top of what is left, and further down only if it removes that. This takes a distance for each
// sweep and column, where CutWalker takes one for each sweep and voxel.
#pragma once

#include "removal/history/cut_sink.h"
#include "removal/part/part_field.h"
#include "removal/simd/sweep_kernels.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace mrsim {

/// Walks one block of kBlockVoxels^3 voxels at a time, on one thread.
class ColumnWalker {
 public:
  ColumnWalker(const PartField& field, double voxel);

  /// Does what CutWalker::walk() does. Requires: is_upward() of all sweeps. Adds the mm^3 that each
  /// sweep removes to `removed`.
  void walk(const std::array<std::int32_t, 3>& origin, std::span<const std::uint32_t> sweeps,
            CutSink* sink, std::span<double> removed);

 private:
  static constexpr int kSide = 8;                       // columns of a leaf each way
  static constexpr std::size_t kLanes = kSide * kSide;  // columns of a leaf
  static constexpr int kDeep = 64;                      // voxels of a column

  using List = std::vector<std::uint32_t>;  // indices into sweeps_, ascending
  // A square of columns.
  struct Square {
    std::array<std::int32_t, 3> origin{};
    List list;
    double clear = 0;  // everything at this height and above has gone
    double floor = 0;  // a sweep with a flat end, wider than the square, has been as low as this
    bool closed = false;
  };
  // A column that a sweep is cutting down.
  struct Falling {
    std::uint8_t lane = 0;
    int at = 0;           // the last voxel that it was evaluated for
    int step = 1;         // voxels to the next one
    double distance = 0;  // there
  };

  void visit(const Square& square, int size, std::size_t depth);
  void distribute(const List& list, double radius, std::array<Square, 4>& squares);
  bool reaches(std::uint32_t index, double d, double reach, const Vec3& center,
               Square& square) const;
  void carve(const std::array<std::int32_t, 3>& origin, const List& list);
  void fill_from_stock(const std::array<std::int32_t, 3>& origin);
  void fill_cell(const std::array<std::int32_t, 3>& origin, int low);
  void set_lanes(const std::array<std::int32_t, 3>& origin);
  bool take(std::uint32_t index);
  double cut_down(std::uint32_t index);
  bool step_down(Falling& f, double d, double& gone);
  double share_of(double d) const;
  double remove(std::size_t lane, int low, int high, double d);
  void lower_top(std::size_t lane);
  void measure(std::uint32_t index, PointColumns& points);
  void hand_on(const std::array<std::int32_t, 3>& origin);
  double height(int z) const { return bottom_ + voxel_ * z; }

  const PartField& field_;
  CutLattice lattice_;
  double voxel_, share_, band_, slack_;
  double bottom_ = 0;  // height of the block's lowest voxels
  std::span<const std::uint32_t> sweeps_;
  std::span<double> removed_;
  CutSink* sink_ = nullptr;
  std::vector<double> lowest_;  // of each sweep, mm
  std::array<std::array<Square, 4>, 4> levels_;
  PointColumns points_, below_;
  std::size_t open_ = 0;                    // lanes with something left
  std::array<std::uint8_t, kLanes> lanes_;  // of points_
  std::array<int, kLanes> top_;             // highest voxel that is left
  std::array<int, kLanes> floor_at_;        // voxel cut by a floor, -1 = none yet ...
  std::array<double, kLanes> floor_;        // ... and no lower than this, mm
  std::array<Falling, kLanes> falling_;
  std::size_t falling_count_ = 0;
  std::int32_t motion_ = 0;                            // the motion that cuts now
  std::array<std::array<float, kDeep>, kLanes> left_;  // share of each voxel that is still there
  std::array<std::array<std::int32_t, kDeep>, kLanes> cut_;
};

}  // namespace mrsim
