// The sweeps of a list that are evaluated one by one, by no kernel of lists: each has a bound below
// its distance that costs less, found for many at once, so that few of them are evaluated.
#pragma once

#include "removal/columns/sweep_columns.h"
#include "removal/columns/turn_tree.h"
#include "removal/sweep/move_runs.h"

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace mrsim {

inline constexpr std::size_t kListChunk = 128;  ///< sweeps of a list that are evaluated together

/// The sweeps of one form in a chunk of a list: their rows, and where their results go.
struct ListPart {
  std::size_t n = 0;
  std::uint32_t rows[kListChunk];
  std::uint32_t slots[kListChunk];
  void add(std::uint32_t row, std::size_t slot) {
    rows[n] = row;
    slots[n++] = static_cast<std::uint32_t>(slot);
  }
};

/// No sweep is nearer to p than the box that holds it; minus infinity where p lies in the box.
double box_bound(const Box3& box, const Vec3& p);

inline void take_nearer(double d, std::uint32_t id, TurnTree::Nearest& best) {
  if (d < best.distance || (d == best.distance && id < best.sweep))
    best.distance = d, best.sweep = id;
}

/// The one of them with the least bound at p.
std::optional<std::uint32_t> least_bound(const SweepColumns& c, std::span<const std::uint32_t> ids,
                                         const Vec3& p);

class BoundedSweeps {
 public:
  BoundedSweeps(const SweepColumns& c, const Vec3& p) : c_(c), p_(p) {}

  /// Brings `best` up to date with SortedList::bounded().
  /// The one that was the nearest to the thread's last point, and then the one with the least
  /// bound, come first: few others can be nearer.
  /// Ends where one is nearer than `enough`.
  void nearest(std::span<const std::uint32_t> list, double enough, TurnTree::Nearest& best);

  /// Where on a sweep the point is nearest, if it is the nearest line.
  std::optional<double> place_on(std::uint32_t sweep) const {
    return sweep == line_ ? std::optional(t_) : std::nullopt;
  }

 private:
  using Single = std::pair<double, std::uint32_t>;  // bound, sweep
  struct Memory {
    MoveRuns runs;
    std::vector<Single> singles;
    std::uint32_t last = 0;  // the nearest of the last list, if still one of this table
  };
  static Memory& thread_memory();
  void take(std::uint32_t id, double limit, TurnTree::Nearest& best);
  std::span<const std::uint32_t> near_runs(std::span<const std::uint32_t> list,
                                           TurnTree::Nearest& best);

  const SweepColumns& c_;
  Vec3 p_;
  std::uint32_t line_ = ~0u;  // the nearest line so far, and the place on it
  double t_ = 0;
};

}  // namespace mrsim
