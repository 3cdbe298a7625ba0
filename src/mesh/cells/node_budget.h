// How many nodes an octree may have within a tolerance, and what all rounds of splitting may take,
// before the tolerance is raised or given up (docs/mesh.md, Default settings).
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>

namespace mrsim::detail {

/// Where `most_nodes` is 0, everything fits. `nodes`: of the octree at the time of the call.
class NodeBudget {
 public:
  /// Share of the largest tolerance up to which it may be raised because of the nodes.
  static constexpr double kRaisedForNodes = 0.5;

  /// `is_raised`: the octree is made for a tolerance that has been raised.
  NodeBudget(std::size_t most_nodes, double most_tolerance, bool is_raised)
      : given_(static_cast<double>(most_nodes)),
        most_tolerance_(most_tolerance),
        most_((is_raised ? kRaisedShare : 1) * given_) {}

  /// Fewer once the tolerance has been raised for the nodes: part of the time is gone, and the mesh
  /// is worth less. 0 = any number.
  double most() const { return most_; }

  /// The octree is made; its surface is not drawn yet.
  void begin(std::size_t nodes) { first_ = static_cast<double>(nodes); }
  /// Notes that the surface was drawn in so many nodes. A round with few nodes counts as a larger
  /// one, so that cells that fail again and again raise the tolerance in the end.
  void add_round(std::size_t nodes) {
    work_ += std::max(static_cast<double>(nodes), kFullRounds / kManyRounds * most_);
  }
  /// Notes that so many cells are split.
  void add_failed(std::size_t cells) {
    first_ = 0;
    failed_before_ = std::exchange(failed_, cells);
  }

  /// Nodes in the end, before the first cells that failed are split. If the octree has already
  /// grown by more than kDense to draw the surface at all, creases are closer than the cells, and
  /// each node takes about three times as long: it counts as three.
  double nodes_after_first(std::size_t failed, std::size_t nodes) const {
    constexpr double kDense = 1.1, kSlow = 3, kSmall = 0.25;
    if (static_cast<double>(nodes) < kSmall * given_) return split_nodes(failed, nodes, 1);
    const double growth = static_cast<double>(nodes) / first_, slow = growth > kDense ? kSlow : 1;
    return slow * growth * growth * split_nodes(failed, nodes, 1);
  }

  /// Whether the cells that failed may be split at this tolerance. A round costs as much as the
  /// nodes that are drawn in it: if only few cells fail after many rounds, most triangles are
  /// within the tolerance, and doubling it ends the rounds soon.
  bool fits(std::size_t failed, std::size_t nodes, double tolerance) const {
    if (given_ == 0 || failed == 0) return true;
    const bool has_time = !has_taken_long() || (is_few(failed, nodes) && !may_raise(tolerance));
    return has_time && expected_nodes(failed, nodes) <= most_;
  }

  /// Whether the tolerance may be doubled: once more for rounds than for nodes, as the mesh is
  /// nearly done then.
  bool may_raise(double tolerance) const {
    return 2 * tolerance <= most_tolerance_ * (has_taken_long() ? 1 : kRaisedForNodes);
  }
  /// Notes that the tolerance is doubled.
  void raise(std::size_t nodes) {
    if (has_taken_long())
      full_rounds_ += kMoreRounds;
    else
      most_ = std::max(kRaisedShare * given_, kGrown * static_cast<double>(nodes));
  }

  /// From this number on cells are not few: a hundredth of the nodes, 120 at least.
  static double few(std::size_t nodes) {
    constexpr double kShare = 0.01, kSmall = 12000;
    return kShare * std::max(static_cast<double>(nodes), kSmall);
  }
  static bool is_few(std::size_t cells, std::size_t nodes) {
    return static_cast<double>(cells) < few(nodes);
  }

 private:
  static constexpr double kSplitNodes = 8;     ///< nodes that a failed cell adds
  static constexpr double kRaisedShare = 0.7;  ///< of the most nodes, once it has been raised
  static constexpr double kGrown = 1.25;     ///< times the present nodes, which it may grow by then
  static constexpr double kFullRounds = 4;   ///< with the most nodes: what all rounds may take
  static constexpr double kManyRounds = 32;  ///< count as much as that, however little is drawn
  static constexpr double kMoreRounds = 1;   ///< in addition, each time it is raised for that

  static double split_nodes(std::size_t failed, std::size_t nodes, double growth) {
    return static_cast<double>(nodes) + kSplitNodes * static_cast<double>(failed) * growth;
  }
  bool has_taken_long() const { return work_ > full_rounds_ * most_; }

  // Where the failed cells have grown in two rounds running, three more such rounds are expected
  // (crests of a winding helix do this).
  double expected_nodes(std::size_t failed, std::size_t nodes) const {
    if (first_ > 0) return nodes_after_first(failed, nodes);
    const bool grows =
        !is_few(failed_before_, nodes) && failed_ > failed_before_ && failed > failed_;
    const double f = grows ? static_cast<double>(failed) / static_cast<double>(failed_) : 1;
    return split_nodes(failed, nodes, f * f * f);
  }

  double given_;
  double most_tolerance_;  // mm
  double most_;
  double first_ = 0;  // nodes of the octree as it was made, 0 after the first round
  double work_ = 0;   // nodes drawn in all rounds together
  double full_rounds_ = kFullRounds;
  std::size_t failed_ = 0, failed_before_ = 0;  // cells in the last round and the one before
};

}  // namespace mrsim::detail
