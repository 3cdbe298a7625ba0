// The history of a stock whose sweeps all leave heights (removal/sweep/sweep_heights.h): in a
// column of the stock a sweep removes what lies between its bottom and the lowest bottom before it.
// So the history of a column is the staircase of its record lows, and heights are exact; only in
// plan is anything sampled (docs/history.md, Heights).
#pragma once

#include "removal/history/cut_extent.h"
#include "removal/history/cut_sink.h"
#include "removal/history/wall_lines.h"
#include "removal/part/part_field.h"
#include "removal/simd/sweep_kernels.h"
#include "removal/sweep/sweep_heights.h"

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace mrsim {

/// Whether all sweeps are upward and the stock is the same at all heights.
bool has_height_history(const PartField& field);

/// The stock in plan as squares of columns.
class HeightGrid {
 public:
  static constexpr int kTile = 16;  ///< columns on a side of a tile

  /// Columns of at most `voxel` mm that fill the stock's box.
  HeightGrid(const Box3& stock, double voxel);
  /// The columns of a lattice below the stock; tiles begin at multiples of kTile voxels.
  HeightGrid(const Box3& stock, const CutLattice& lattice);

  std::size_t tiles() const { return static_cast<std::size_t>(tiles_[0]) * tiles_[1]; }
  /// Lattice coordinates of the first column of a tile. Requires: made for a lattice.
  std::array<std::int32_t, 2> origin(std::size_t tile) const;
  /// Lower corner of a tile, mm.
  Vec2 corner(std::size_t tile) const;
  Vec2 column() const { return column_; }  ///< sides, mm
  Vec2 end() const { return end_; }        ///< of the stock
  /// The sweeps that may come to each tile, ascending.
  std::vector<std::vector<std::uint32_t>> sweeps_of_tiles(const SweepTable& sweeps) const;

 private:
  std::array<int, 2> tiles_{};
  std::array<std::int32_t, 2> first_{};
  Vec2 low_, end_, column_;
};

/// What each sweep removes of one tile; on one thread.
class HeightWalker {
 public:
  /// `frames`: by motion, where extents are wanted. `close`: as SweepHeights has it, mm.
  HeightWalker(const PartField& field, const SweepUndersides& tools,
               std::span<const CutFrame> frames = {}, double close = 0);
  /// Adds mm^3 to `removed`, in the order of the list. `sweeps`: ascending.
  void walk(const HeightGrid& grid, std::size_t tile, std::span<const std::uint32_t> sweeps,
            std::span<double> removed);
  /// Takes the staircase of a column, from its top, with the column's lower corner.
  using Steps = std::function<void(const Vec2& corner, std::uint32_t index, double bottom)>;
  /// Hands on the staircase of each column of a tile, by its middle alone.
  void walk_steps(const HeightGrid& grid, std::size_t tile, std::span<const std::uint32_t> sweeps,
                  const Steps& steps);
  /// Extents of the last walk, in the order of its list.
  const std::vector<CutExtent>& extents() const { return extents_; }

 private:
  static constexpr int kFiner = 3;      // halvings of a column where a wall passes
  static constexpr int kLinesFrom = 2;  // halvings from which on walls are met by lines
  static constexpr std::size_t kLevels = 6 + kFiner;

  using List = std::vector<std::uint32_t>;  // indices into the list of sweeps
  struct Square {
    Vec2 center, side;
    int columns = 1;  // on a side; 0 within a column
    int finer = 0;    // halvings of a column
  };
  void visit(const Square& square, std::size_t tier, bool even);
  struct Found {
    bool cuts = false;   // some sweep cuts
    bool even = false;   // heights do not differ much
    bool walls = false;  // a wall of a sweep may pass
    bool quick = true;   // no sweep is searched
  };
  Found narrow(const Square& square, std::size_t tier);
  template <class Step>
  void for_each_step(const Square& square, const List& list, const Step& step) const;
  void cut(const Square& square, const List& list);
  void cut_walls(const Square& square, const List& list);
  struct Parts;
  Parts parts_of(const Square& square) const;
  bool is_even(double least, double most) const;
  void cut_parts(const Square& square, std::size_t tier);
  void cut_part(const Square& part, const List& list, std::size_t tier, bool is_even_part);
  void step(const Square& column, std::uint32_t index, double bottom, double low);
  void begin(const HeightGrid& grid, std::size_t tile, std::span<const std::uint32_t> sweeps);
  void extend(std::uint32_t index, const Square& square, double bottom, double top);
  PlanBand band_across(const CutFrame& frame, const Square& square, const Vec3& p) const;
  double stock_share(const Square& square) const;

  const PartField& field_;
  SweepHeights heights_;
  double low_, high_;
  Vec2 end_;
  int finest_ = kFiner;
  const Steps* steps_ = nullptr;
  std::span<double> removed_;
  std::span<const CutFrame> frames_;
  std::span<const std::uint32_t> sweeps_;
  std::vector<CutExtent> extents_;
  WallLines lines_;
  std::array<List, kLevels + 1> lists_;
  std::array<List, PlanPoints::kCount> part_lists_;
};

}  // namespace mrsim
