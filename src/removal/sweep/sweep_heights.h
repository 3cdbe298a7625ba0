// Sweeps as heights: an upright cutter that reaches above all places in question and nowhere
// narrows removes, at each place in plan, all above its bottom. Closed forms for horizontal moves,
// for straight ones of convex cutters and for helices of flat mills; on other straight moves and
// helices the least height is found along the path; other arcs lie near their chords and are found
// between those bounds by their distances.
#pragma once

#include "removal/simd/sweep_kernels.h"
#include "removal/sweep/sweep_table.h"
#include "removal/tool/underside.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace mrsim {

struct ToolPath;

/// Whether sweep i is closed upwards: if it holds a point, it holds everything above it.
bool is_upward(const SweepTable& sweeps, std::uint32_t i);

/// The tools of a table as undersides.
class SweepUndersides {
 public:
  explicit SweepUndersides(const SweepTable& sweeps);
  const Underside& operator[](std::int32_t shape) const {
    return tools_[static_cast<std::size_t>(shape)];
  }

 private:
  std::vector<Underside> tools_;  ///< by shape; empty ones where the tool is not rising
};

/// The heights of some sweeps, named by their indices in a list.
class SweepHeights {
 public:
  /// `low`, `high`: the heights between which bottoms are wanted, mm. `close`: where bounds of a
  /// bottom without a closed form are no farther apart, their middle is good enough.
  SweepHeights(const SweepTable& sweeps, const SweepUndersides& tools, double low, double high,
               double close = 0)
      : sweeps_(sweeps), tools_(tools), low_(low), high_(high), close_(close) {}
  /// Requires: is_upward() of all.
  void assign(std::span<const std::uint32_t> sweeps);

  /// The index behind the slanted moves that are of one pack with this one; the next index where it
  /// is of none.
  std::uint32_t run_end(std::uint32_t index) const {
    return run_of_[index] == kNoRun ? index + 1 : runs_[run_of_[index]].end;
  }
  /// No bottom() of them within r of (x, y) is less; may be infinite if the true one is at least
  /// `below`. Requires: run_end() is not the next index.
  double run_lower(std::uint32_t index, double x, double y, double r, double below) const;

  /// Records of all sweeps by index, as kernels take them, where all are straight moves of balls;
  /// else empty.
  std::span<const LineRecord> balls() const { return balls_; }

  /// bottom() is a closed form or one root; others are searched, which takes 10 to 100 times as
  /// long.
  bool is_quick(std::uint32_t index) const { return rows_[index].form < Form::helix; }
  /// The least height at (x, y) with distance(sweep, .) <= 0; infinite where there is none, or none
  /// below `high`, and perhaps where it is not below `below`; any height below `low` where it lies
  /// there. Up to 1e-9 mm; of sweeps that are found by distances, up to their error, or half of
  /// `close`.
  double bottom(std::uint32_t index, double x, double y,
                double below = std::numeric_limits<double>::infinity()) const;
  /// Bounds of bottom() over all places within r of (x, y); `upper` may be infinite where `lower`
  /// is not below `below`.
  Underside::Bounds bounds(std::uint32_t index, double x, double y, double r,
                           double below = std::numeric_limits<double>::infinity()) const;

 private:
  // rising_slant, rising_helix: of tools that are not convex, and arcs too long for segments.
  enum class Form : std::uint8_t {
    horizontal,
    slant,
    bored,
    helix,
    rising_slant,
    rising_helix,
    segments,
    other
  };
  struct Row {
    Form form = Form::other;
    std::uint32_t sweep = 0;
    const Underside* tool = nullptr;
    double x = 0, y = 0, z = 0;        // slant: lower end of the tip's path; z: height of that, of
                                       // a horizontal path, or of a helix's end
    double ux = 1, uy = 0;             // slant: direction in plan
    double length = 0, slope = 0;      // slant: in plan, mm
    std::size_t first = 0, count = 0;  // helix, segments
  };
  struct Run {
    std::uint32_t end = 0;    // index behind its last sweep
    Row chord;                // what its moves are beside
    double plan = 0, up = 0;  // mm: how far they leave it
  };
  static constexpr std::uint32_t kNoRun = ~std::uint32_t{0};
  void find_runs();
  Row row_of(std::uint32_t sweep);
  void set_slant(Row& row, const Vec3& start, const Vec3& end) const;
  void set_arc(Row& row, const ToolPath& arc);
  void set_segments(Row& row, const ToolPath& path);
  double rho(const Row& row, double x, double y) const;
  Underside::Bounds segment_bounds(const Row& row, double x, double y, double r,
                                   double below) const;
  double bored_bottom(const Row& row, double x, double y, double radius) const;
  const ToolPath& path(const Row& row) const;
  static Underside::Slant seen(const Row& row, double x, double y);
  double search(std::uint32_t sweep, double x, double y, const Underside::Bounds& within) const;

  const SweepTable& sweeps_;
  const SweepUndersides& tools_;
  double low_, high_, close_;
  std::vector<Row> rows_;
  std::vector<LineRecord> segments_;  // straight ones of arcs (height_segments.h)
  std::vector<LineRecord> balls_;
  std::vector<Run> runs_;
  std::vector<std::uint32_t> run_of_;  // by index
};

}  // namespace mrsim
