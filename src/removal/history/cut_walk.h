// The stock through time: which motion first removes a place, and how much each motion removes.
//
// Place p of the stock is removed by the first motion i whose sweep holds it, d_i(p) <= 0. That is
// a pure function of (stock, motions, p), so the result is the same on any number of threads. The
// method and its error bound stand in docs/history.md.
#pragma once

#include "removal/history/cut_extent.h"
#include "removal/history/cut_sink.h"
#include "removal/part/part_field.h"
#include "removal/simd/sweep_kernels.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace mrsim {

inline constexpr int kCutLeaf = 4;

/// Walks one block of voxels at a time, on one thread, from large cells to small ones, each with
/// the sweeps that can be the first somewhere in it, in the order of the program.
class CutWalker {
 public:
  /// `frames`: by motion, where extents are wanted.
  CutWalker(const PartField& field, const CutLattice& lattice,
            std::span<const CutFrame> frames = {});

  /// `sweeps`: all that reach the block or half a voxel beyond, ascending. `sink` may be null.
  /// Requires: the block's size is a power of two, at least 16.
  /// Adds the mm^3 that each sweep removes to `removed`, in the order of the list; a voxel on a
  /// surface counts by its share of material, 1/2 - d / voxel within [0, 1].
  void walk(const CutCell& block, std::span<const std::uint32_t> sweeps, CutSink* sink,
            std::span<double> removed);
  /// Extents of all walks since the list changed last, in the order of the list.
  const std::vector<CutExtent>& extents() const { return extents_; }

 private:
  using List = std::vector<std::uint32_t>;  // indices into sweeps_, ascending
  struct Child {
    CutCell cell;
    List list;
    bool in_stock = false;  // deep in the stock, which never decides
    bool decided = false;   // nothing more to be found: in the air, or in a sweep of the list
    double least = 0;       // distance of the centre from the nearest sweep of the list
  };
  using Children = std::array<Child, 8>;

  int leaf_size() const { return lattice_.half_plane ? 2 * kCutLeaf : kCutLeaf; }
  void visit(const CutCell& cell, const List& list, bool in_stock, std::size_t depth);
  std::size_t divide(const CutCell& cell, bool in_stock, Children& children);
  void distribute(const List& list, double radius, std::span<Child> children);
  void settle(Child& child, std::size_t depth);
  void fill_tile(const CutCell& cell, std::uint32_t index);
  void evaluate(const CutCell& cell, const List& list, bool in_stock);
  void set_points(const CutCell& cell);
  bool take(std::uint32_t index);
  void measure(std::uint32_t index);
  void extend(std::uint32_t index, const Vec3& p, double gone);
  double radius_of(int size) const;
  double ring(double x) const;

  const PartField& field_;
  CutLattice lattice_;
  double band_;   // mm: half a voxel, and rounding
  double share_;  // of a voxel by mm
  std::span<const std::uint32_t> sweeps_;
  CutSink* sink_ = nullptr;
  std::array<Children, 8> levels_;
  std::span<double> removed_;
  std::span<const CutFrame> frames_;
  std::vector<CutExtent> extents_;
  PointColumns points_;
  double left_[PointColumns::kMost];    // share of each voxel that is still there
  double volume_[PointColumns::kMost];  // mm^3 of each voxel
  std::int32_t cut_[PointColumns::kMost];
};

}  // namespace mrsim
