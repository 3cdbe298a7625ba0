// The history of turned parts in space: which motion first removes a place depends on its distance
// from the axis and on z alone (docs/history.md, Turned parts).
#pragma once

#include "removal/history/cut_sink.h"
#include "removal/part/part_field.h"
#include "removal/simd/sweep_kernels.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace mrsim {

/// Some planes of voxels across the axis, each as rings of one value.
class RingPlanes {
 public:
  /// A ring ends where the next one begins, mm from the axis; the last one never.
  struct Ring {
    double end = 0;
    std::int32_t value = 0;  ///< a motion, kStillThere, kNeverThere, or at most kAsk
  };
  /// A narrow ring of more than one value: its voxels are evaluated one by one. kAsk - i is
  /// question i.
  static constexpr std::int32_t kAsk = -3;
  struct Question {
    std::vector<std::uint32_t> sweeps;  ///< sweeps of which one is the first, ascending
    bool in_stock = false;              ///< the whole ring lies in the stock
  };

  /// Planes `first` to first + count - 1 of a lattice in space. `count`: a power of two.
  /// Requires: the stock and all sweeps are turned.
  RingPlanes(const PartField& field, double voxel, std::int32_t first, int count);

  std::int32_t first() const { return first_; }
  std::span<const Ring> plane(std::int32_t z) const {
    return planes_[static_cast<std::size_t>(z - first_)];
  }
  const Question& question(std::int32_t value) const {
    return questions_[static_cast<std::size_t>(kAsk - value)];
  }

 private:
  using List = std::vector<std::uint32_t>;  // sweeps, ascending
  // Rings from `low` to `high` mm on `deep` planes.
  struct Part {
    double low = 0, high = 0;
    std::int32_t z = 0;
    int deep = 0;
    List list;
    bool in_stock = false;  // all of it
    bool decided = false;   // in the air, or in a sweep of the list
    double least = 0;       // distance of the centre from the nearest sweep of the list
  };
  using Parts = std::array<Part, PointColumns::kPad>;

  void divide(const Part& whole, std::size_t depth);
  void split(const Part& whole, Parts& parts);
  void distribute(const Part& whole, Parts& parts);
  void settle(const Part& part, std::size_t depth);
  void append(const Part& part, std::int32_t value);

  const PartField& field_;
  CutLattice lattice_;
  std::int32_t first_;
  std::vector<std::vector<Ring>> planes_;
  std::vector<Question> questions_;
  std::vector<Parts> levels_;
  PointColumns points_;
};

/// Blocks of voxels of a turned part, from the rings of their planes.
class RingWalker {
 public:
  RingWalker(const PartField& field, double voxel) : field_(field), lattice_{voxel, false} {
    points_.count = 1;
    points_.nearest[0] = 0;
  }
  /// Hands all voxels of a block to `sink`, in leaves of 8^3. Requires: the block's size is a power
  /// of two, at least 8, and `planes` has all of its planes.
  void walk(const RingPlanes& planes, const CutCell& block, CutSink& sink);

 private:
  static constexpr int kLeaf = 8;
  bool is_uniform(const RingPlanes& planes, const CutCell& cell, std::int32_t& value);
  void write_leaf(const RingPlanes& planes, const CutCell& cell, CutSink& sink);
  void ask(const RingPlanes& planes, const CutCell& cell);
  std::int32_t first_of(const RingPlanes::Question& question, const Vec3& p);

  const PartField& field_;
  CutLattice lattice_;
  PointColumns points_;
  std::array<const RingPlanes::Ring*, kLeaf>
      inner_{};  // of each plane, of the cell's nearest column
  std::int32_t cut_[kLeaf * kLeaf * kLeaf];
};

}  // namespace mrsim
