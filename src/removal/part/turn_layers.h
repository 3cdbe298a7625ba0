// A turned stock layer by layer: on each plane z of the lattice the part depends on rho alone, so
// that one table of intervals of rho, with the few sweeps that can be nearest in each, serves all
// voxels around the axis (docs/removal.md).
#pragma once

#include "removal/columns/turn_tree.h"
#include "removal/part/part_field.h"

#include <cstdint>
#include <span>
#include <vector>

namespace mrsim {

class TurnLayers {
 public:
  /// From the end of the interval before it, or the axis, to rho = `end`, mm.
  struct Interval {
    double end = 0;
    std::uint32_t first = 0, count = 0;  ///< of the layer's members; mixed only
    ExactField::Region region = ExactField::Region::air;
    bool in_stock = false;  ///< deep in the stock: its surface decides nothing here
  };
  struct Layer {
    std::vector<Interval> intervals;  ///< ascending; beyond the last one is air
    std::vector<FacingMember> members;
    TurnSides sides;  ///< of the members
  };

  /// Takes only the turning sweeps of the field, so the table is right where no other sweep
  /// reaches. Requires: a stock that is turned. Cost: some hundred microseconds a layer; memory: a
  /// few KB, less than a thousandth of the voxels of a layer.
  TurnLayers(const PartField& field, double voxel, double band, int threads);

  /// The layer of lattice coordinate k.
  const Layer& at(std::int32_t k) const;

 private:
  class Builder;
  std::int32_t first_ = 0;
  std::vector<Layer> layers_;
  Layer none_;
};

}  // namespace mrsim
