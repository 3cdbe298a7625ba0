// The stock through time: which motion first removes a place, and how much each motion removes.
//
// Place p of the stock is removed by the first motion i whose sweep holds it, d_i(p) <= 0. That is
// a pure function of (stock, motions, p), so the result is the same on any number of threads. The
// method and its error bound are told in docs/history.md.
#pragma once

#include "removal/part/part_field.h"
#include "removal/simd/sweep_kernels.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace mrsim {

inline constexpr std::int32_t kStillThere = -1;  ///< no motion removes the place
inline constexpr std::int32_t kNeverThere = -2;  ///< the place lies outside of the stock

/// Where voxels lie: in space, or for turned parts in the half plane y = 0, x >= 0, where each
/// voxel stands for a ring about the Z axis.
struct CutLattice {
  double voxel = 0;  ///< mm
  bool half_plane = false;

  /// Centre of a voxel, mm. In space the lattice is that of the level set (lattice.h).
  Vec3 position(const std::array<std::int32_t, 3>& at) const;
};

/// A cube of size^3 voxels; in the half plane a square of size x 1 x size.
struct CutCell {
  std::array<std::int32_t, 3> origin{};  ///< its first voxel
  int size = 0;
};

/// Takes the voxels of a walk, each exactly once.
class CutSink {
 public:
  virtual ~CutSink() = default;
  /// All voxels of a cell are cut by one motion, or are kStillThere or kNeverThere.
  virtual void tile(const CutCell& cell, std::int32_t cut) = 0;
  /// The voxels of a cell of kCutLeaf^3, z fastest.
  virtual void leaf(const CutCell& cell, const std::int32_t* cut) = 0;
};
inline constexpr int kCutLeaf = 4;

/// One block of voxels at a time, on one thread: from large cells to small ones, each with the
/// sweeps that can be the first somewhere in it, in the order of the program.
class CutWalker {
 public:
  CutWalker(const PartField& field, const CutLattice& lattice);

  /// `sweeps`: all that reach the block or half a voxel beyond, ascending. `sink` may be null.
  /// Requires: the block's size is a power of two, at least 16.
  void walk(const CutCell& block, std::span<const std::uint32_t> sweeps, CutSink* sink);

  /// mm^3 that each sweep of the last walk removes, in the order of its list. A voxel on a surface
  /// counts by its share of material, 1/2 - d / voxel within [0, 1].
  std::span<const double> removed() const { return removed_; }

 private:
  using List = std::vector<std::uint32_t>;  // places in sweeps_, ascending
  struct Child {
    CutCell cell;
    List list;
    bool in_stock = false;  // deep in the stock, which never decides
    bool closed = false;    // nothing more to be found: in the air, or in a sweep of the list
    double least = 0;       // distance of the centre from the nearest sweep of the list
  };
  using Children = std::array<Child, 8>;

  int leaf_size() const { return lattice_.half_plane ? 2 * kCutLeaf : kCutLeaf; }
  void visit(const CutCell& cell, const List& list, bool in_stock, std::size_t depth);
  std::size_t divide(const CutCell& cell, bool in_stock, Children& children);
  void distribute(const List& list, double radius, std::span<Child> children);
  void settle(Child& child, std::size_t depth);
  void fill_tile(const CutCell& cell, std::uint32_t place);
  void evaluate(const CutCell& cell, const List& list, bool in_stock);
  void place_points(const CutCell& cell);
  bool take(std::uint32_t place);
  void measure(std::uint32_t place);
  double radius_of(int size) const;
  double ring(double x) const;

  const PartField& field_;
  CutLattice lattice_;
  double band_;   // mm: half a voxel, and rounding
  double share_;  // of a voxel by mm
  std::span<const std::uint32_t> sweeps_;
  CutSink* sink_ = nullptr;
  std::array<Children, 8> levels_;
  std::vector<double> removed_;
  PointColumns points_;
  double left_[PointColumns::kMost];    // share of each voxel that is still there
  double volume_[PointColumns::kMost];  // mm^3 of each voxel
  std::int32_t cut_[PointColumns::kMost];
};

}  // namespace mrsim
