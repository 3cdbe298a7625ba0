// What sweeps remove of a square in plan that walls pass, where a sample says all or nothing: along
// lines across the walls the places where they stand are found by bisection (docs/history.md,
// Heights).
#pragma once

#include "core/numbers/vec.h"
#include "removal/sweep/sweep_heights.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace mrsim {

class WallLines {
 public:
  struct Fineness {
    int parts = 1;          ///< of a line that are looked at whatever its ends say
    double shortest = 0.5;  ///< share of a line that is halved no more
  };
  /// `low`, `high`: of the stock, mm. The heights are kept by reference.
  WallLines(const SweepHeights& heights, double low, double high, const Fineness& fineness)
      : heights_(heights), low_(low), high_(high), fineness_(fineness) {}

  /// What each sweep of a list removes of a square with sides `side` mm: means of its height, mm,
  /// valid until the next call. `list`: indices of the heights, ascending. A straight wall across
  /// the square is met to half of the shortest share of its side; some 10 to 20 lowest bottoms and
  /// 4 to 10 staircases.
  std::span<const double> depths(const Vec2& center, const Vec2& side,
                                 std::span<const std::uint32_t> list);

 private:
  /// A stretch of a line on which nothing changes much.
  struct Stretch {
    double from = 0, to = 0;  // of the line
    double depth = 0;         // at its start, mm
  };
  double depth(const Vec2& at) const;
  double depth_on_line(double t) const { return depth(start_ + t * along_); }
  void walk_line(const Vec2& start, const Vec2& along);
  void divide(double from, double depth, double to, double depth_there);
  void extend(double from, double depth, double to, double depth_there);
  void finish_stretch();

  const SweepHeights& heights_;
  double low_, high_;
  Fineness fineness_;
  std::span<const std::uint32_t> list_;
  Vec2 start_, along_;
  Stretch stretch_;
  std::vector<double> depths_;
};

}  // namespace mrsim
