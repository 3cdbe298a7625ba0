// A long list of sweeps to which many points are measured: straight moves of one convex tool that
// follow one another nearly on a line are a run, and one bound shows that none of them is near.
#pragma once

#include "removal/columns/sweep_columns.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace mrsim {

/// The moves of a run lie within its spread of its chord (RunChords). What a convex tool sweeps
/// along a line is convex, so the distance from what it would sweep along the chord, less the
/// spread, is not above the distance from any of the moves.
class MoveRuns {
 public:
  /// Finds the runs of a list, unless it is the one before.
  void prepare(const SweepColumns& c, std::span<const std::uint32_t> list);
  /// Finds the bounds of all runs at p. A result above `limit` only means *above limit*.
  void measure(const SweepColumns& c, const Vec3& p, double limit);
  /// A sweep in the middle of the run with the least bound, if there is a run.
  std::optional<std::uint32_t> promising() const;
  /// The list less the runs whose bound is above `limit`; valid until the next call.
  std::span<const std::uint32_t> within(double limit);

 private:
  struct Run {
    std::uint32_t first = 0, count = 0;  ///< indices into the list
    double spread = 0;                   ///< mm, with room for rounding
  };
  /// Runs of one tool, side by side; or, as one run without a chord, sweeps that have no such
  /// bound.
  struct Group {
    std::int32_t tool = -1;            ///< -1: none
    std::uint32_t first = 0, end = 0;  ///< in `runs_`
    std::uint32_t chord = 0;           ///< of the first
    double spread = 0;                 ///< the largest
  };
  void add_moves(const SweepColumns& c, std::uint32_t first, std::uint32_t end);

  std::uint64_t table_ = 0;  ///< SweepColumns::serial that the list is of
  std::vector<std::uint32_t> list_, within_;
  std::vector<Run> runs_;
  std::vector<Group> groups_;
  std::vector<ChainLine> chords_;  ///< of the runs that have one
  std::vector<double> columns_;    ///< the same side by side (ChainColumns)
  std::size_t stride_ = 0;         ///< of the columns
  std::vector<double> bounds_;     ///< by run; minus infinity where there is none
};

}  // namespace mrsim
