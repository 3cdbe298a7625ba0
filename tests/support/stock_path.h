// A tool's path, and the stock of a run that gives none, around it.
#pragma once

#include "core/numbers/units.h"
#include "removal/part/default_stock.h"
#include "support/path_builder.h"

#include <string>
#include <vector>

namespace mrsim::testing {

class StockPath : public PathBuilder<StockPath> {
 public:
  StockPath() : PathBuilder({0, 0, 20}) {}
  Box3 box(double zero = 0) const {
    Tool tool;
    tool.diameter = 4;
    return default_stock(motions, std::vector<Tool>{tool}, false, zero).shape.box;
  }
  double top(double zero = 0) const { return box(zero).hi.z; }
  StockShape bar(ToolType type = ToolType::turning, double zero = 0) const {
    return assumed_bar(type, zero).shape;
  }
  std::string guesses(ToolType type = ToolType::turning) const {
    return assumed_bar(type, 0).guesses;
  }

 private:
  AssumedStock assumed_bar(ToolType type, double zero) const {
    Tool tool;
    tool.type = type;
    tool.diameter = 12;
    if (type == ToolType::turning) tool.lead_angle = radians(95);
    return default_stock(motions, std::vector<Tool>{tool}, true, zero);
  }
};

}  // namespace mrsim::testing
