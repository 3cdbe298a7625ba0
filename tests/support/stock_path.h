// A tool's path, and the stock of a run that gives none, around it.
#pragma once

#include "core/units.h"
#include "core/vec.h"
#include "removal/part/default_stock.h"

#include <vector>

namespace mrsim::testing {

class StockPath {
 public:
  StockPath& rapid(Vec3 to) { return add(MotionKind::rapid, to); }
  StockPath& cut(Vec3 to) { return add(MotionKind::line, to); }
  // Half a turn about the Y axis, upwards or down, or a quarter up.
  StockPath& arc(Vec3 to, Vec3 center, double turns) {
    add(MotionKind::arc, to);
    Motion& m = motions_.back();
    m.center = center;
    m.axis = {0, 1, 0};
    m.radius = length(m.start - center);
    m.sweep = turns * kTwoPi;
    return *this;
  }
  Box3 box(double zero = 0) const {
    Tool tool;
    tool.diameter = 4;
    return default_stock(motions_, std::vector<Tool>{tool}, false, zero).box;
  }
  double top(double zero = 0) const { return box(zero).hi.z; }
  StockShape bar(ToolType type = ToolType::turning, double zero = 0) const {
    Tool tool;
    tool.type = type;
    tool.diameter = 12;
    if (type == ToolType::turning) tool.lead_angle = radians(95);
    return default_stock(motions_, std::vector<Tool>{tool}, true, zero);
  }

 private:
  StockPath& add(MotionKind kind, Vec3 to) {
    Motion m;
    m.kind = kind;
    m.start = at_;
    m.end = at_ = to;
    m.tool = 0;
    motions_.push_back(m);
    return *this;
  }
  Vec3 at_{0, 0, 20};
  std::vector<Motion> motions_;
};

}  // namespace mrsim::testing
