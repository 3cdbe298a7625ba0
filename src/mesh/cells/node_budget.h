// How many nodes an octree may have within a tolerance, and what all rounds of splitting may take,
// before the tolerance is raised, another octree is made, or the mesh is given up (docs/mesh.md,
// Default settings).
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>

namespace mrsim::detail {

/// Where `most_nodes` is 0, everything fits. `nodes`: of the octree at the time of the call.
class NodeBudget {
 public:
  /// `tolerance`: mm, and the one up to which it may be raised.
  NodeBudget(std::size_t most_nodes, double tolerance, double most_tolerance)
      : given_(static_cast<double>(most_nodes)),
        most_tolerance_(most_tolerance),
        wish_(tolerance),
        begun_with_(tolerance),
        tolerance_(tolerance),
        first_most_(given_),
        most_(given_) {}

  /// mm: of the mesh that is made now.
  double tolerance() const { return tolerance_; }

  /// Fewer once the tolerance has been raised for the nodes: part of the time is gone, and the mesh
  /// is worth less. 0 = any number.
  double most() const { return most_; }

  /// The nodes that may be expected by the memory, before the surface is drawn. Twice as many for a
  /// raised tolerance: the estimate is as much too large for coarse octrees.
  double most_expected() const { return (tolerance_ > wish_ ? 2 : 1) * most_; }

  /// The octree is made; its surface is not drawn yet.
  void begin(std::size_t nodes) { first_ = static_cast<double>(nodes); }
  /// Notes that the surface was drawn in so many nodes. A round with few nodes counts as a larger
  /// one, so that cells that fail again and again raise the tolerance in the end.
  void add_round(std::size_t nodes) {
    const auto drawn = static_cast<double>(nodes);
    work_ += std::max(drawn, kFullRounds / kManyRounds * most_);
    if (first_ > 0) growth_ = drawn / first_;
    is_dense_ = is_dense_ || (growth_ > kDense && drawn >= kSmall * given_);
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
    constexpr double kSlow = 3;
    if (static_cast<double>(nodes) < kSmall * given_) return split_nodes(failed, nodes, 1);
    return (is_dense_ ? kSlow : 1) * growth_ * growth_ * split_nodes(failed, nodes, 1);
  }

  /// Whether the cells that failed may be split at this tolerance. A round costs as much as the
  /// nodes that are drawn in it: if only few cells fail after many rounds, most triangles are
  /// within the tolerance, and doubling it ends the rounds soon.
  bool fits(std::size_t failed, std::size_t nodes) const {
    if (given_ == 0 || failed == 0) return true;
    const bool has_time = !has_taken_long() || (is_few(failed, nodes) && !may_raise());
    return has_time && expected_nodes(failed, nodes) <= most_;
  }

  /// Whether the tolerance may be doubled: once more for rounds than for nodes, as the mesh is
  /// nearly done then.
  bool may_raise() const {
    return 2 * tolerance_ <= most_tolerance_ * (has_taken_long() ? 1 : kRaisedForNodes);
  }
  /// Doubles the tolerance.
  void raise(std::size_t nodes) {
    tolerance_ *= 2;
    if (has_taken_long())
      full_rounds_ += kMoreRounds;
    else
      most_ = std::max(kRaisedShare * given_, kGrown * static_cast<double>(nodes));
  }

  /// The octree has too many nodes, or takes too many rounds: raises the tolerance for another one,
  /// which has far fewer. False: none is worth its time. `is_drawn`: its surface was drawn.
  bool begin_again(bool is_drawn) {
    // Raising it before did not help as long as the octree was the same.
    const double next = is_drawn ? std::max(2 * begun_with_, tolerance_) : 2 * tolerance_;
    spent_ += is_drawn ? work_ : kUndrawn * most_;
    if (is_dense_ || spent_ > kFullRounds * given_ || next > kRaisedForNodes * most_tolerance_)
      return false;
    begun_with_ = tolerance_ = next;
    first_most_ *= kNextShare;
    most_ = first_most_;
    begin_rounds();
    return true;
  }

  /// The mesh is made: what it has lost is drawn, at the same tolerance.
  void begin_lost() {
    most_ = (tolerance_ > wish_ ? kRaisedShare : 1) * given_;
    most_tolerance_ = tolerance_;
    begin_rounds();
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
  static constexpr double kNextShare = 0.7;  ///< of the nodes of an octree, which another may have
  static constexpr double kUndrawn =
      0.25;                               ///< of a drawn node: what a node counts that is not drawn
  static constexpr double kDense = 1.1;   ///< growth to draw the surface at all
  static constexpr double kSmall = 0.25;  ///< share of the most nodes below which that is nothing
  static constexpr double kSplitNodes = 8;  ///< nodes that a failed cell adds
  /// Share of the largest tolerance up to which it may be raised because of the nodes.
  static constexpr double kRaisedForNodes = 0.5;
  static constexpr double kRaisedShare = 0.7;  ///< of the most nodes, once it has been raised
  static constexpr double kGrown = 1.25;     ///< times the present nodes, which it may grow by then
  static constexpr double kFullRounds = 4;   ///< with the most nodes: what all rounds may take
  static constexpr double kManyRounds = 32;  ///< count as much as that, however little is drawn
  static constexpr double kMoreRounds = 1;   ///< in addition, each time it is raised for that

  static double split_nodes(std::size_t failed, std::size_t nodes, double growth) {
    return static_cast<double>(nodes) + kSplitNodes * static_cast<double>(failed) * growth;
  }
  void begin_rounds() {
    full_rounds_ = kFullRounds;
    first_ = work_ = 0, growth_ = 1;
    failed_ = failed_before_ = 0;
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
  double wish_;            // mm
  double begun_with_;      // mm: the tolerance that the octree was made for
  double tolerance_;       // mm
  double spent_ = 0;       // nodes drawn in the octrees before, together
  double first_most_;      // nodes: `most_` when the octree was begun
  double most_;
  double first_ = 0;   // nodes of the octree as it was made, 0 after the first round
  double growth_ = 1;  // of the octree in the first round
  bool is_dense_ = false;
  double work_ = 0;  // nodes drawn in all rounds together
  double full_rounds_ = kFullRounds;
  std::size_t failed_ = 0, failed_before_ = 0;  // cells in the last round and the one before
};

}  // namespace mrsim::detail
