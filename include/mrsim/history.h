/// mrsim: what each motion of a program removes, and in what time.
///
/// The stock is divided into voxels; a motion removes what no motion before it has removed. A voxel
/// on a surface counts by its share of material, so that volumes are finer than the voxels
/// (docs/history.md). Standard library types only.
#pragma once

#include <mrsim/cycle_time.h>
#include <mrsim/types.h>

#include <string>
#include <vector>

namespace mrsim {

/// How much of the history a run makes.
enum class HistoryDetail : std::uint8_t {
  off,      ///< nothing
  summary,  ///< for sums by tool: voxels of longest side / 200, coarser where the program is long
  full,     ///< for single motions: the voxels of the run
};

/// What some motions remove together.
struct Removal {
  double removed = 0;      ///< mm^3
  double seconds = 0;      ///< of cutting, rapids excluded
  double air_seconds = 0;  ///< of these, while nothing is removed

  Removal& operator+=(const Removal& other) {
    removed += other.removed, seconds += other.seconds, air_seconds += other.air_seconds;
    return *this;
  }
  double rate() const { return seconds > 0 ? removed / seconds : 0; }     ///< mm^3/s
  double air() const { return seconds > 0 ? air_seconds / seconds : 0; }  ///< share of the time
};

/// The largest depth, width and angle of engagement of some cuts (docs/history.md, Depth and
/// width). NaN where it is not defined.
struct CutShape {
  double depth = 0;       ///< mm
  double width = 0;       ///< mm
  double engagement = 0;  ///< radians

  /// The larger of each two; what is not defined gives way to a value above 0.
  MRSIM_API CutShape& operator+=(const CutShape& other);
};

struct ToolRemoval {
  int tool = -1;  ///< index into Program::tools
  Removal removal;
};

struct History {
  double voxel = 0;              ///< mm; 0 = no history was made
  std::vector<double> removed;   ///< #motions of the program, mm^3
  std::vector<double> air;       ///< #motions: share of the way on which nothing is removed
  std::vector<CutShape> shapes;  ///< #motions, or none: where HistoryDetail::full asks for them
  Removal total;
  std::vector<ToolRemoval> tools;  ///< in the order of their first cuts
};

/// What motion `motion` of the program (from 0) removes. Requires: `time` and `history` are of
/// `program`, and a history was made: History::voxel > 0.
MRSIM_API Removal removal_of(const Program& program, const CycleTime& time, const History& history,
                             std::size_t motion);

/// The history as a table: a row for each cutting motion ("motion"), and sums for each line
/// ("line"), tool ("tool") and the program ("program"); docs/history.md explains the columns.
/// Requires: all three are of one run. Throws Error "memory". Cost: linear in the motions.
MRSIM_API std::string history_csv(const Program& program, const CycleTime& time,
                                  const History& history);
/// These rows as one JSON object (docs/schema/history.json).
MRSIM_API std::string history_json(const Program& program, const CycleTime& time,
                                   const History& history);

}  // namespace mrsim
