// The stock of a run that gives none.
#include "removal/part/default_stock.h"

#include <vector>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

class Path {
 public:
  Path& rapid(Vec3 to) { return add(MotionKind::rapid, to); }
  Path& cut(Vec3 to) { return add(MotionKind::line, to); }
  double top() const {
    Tool tool;
    tool.diameter = 4;
    return default_stock(motions_, std::vector<Tool>{tool}, false).box.hi.z;
  }

 private:
  Path& add(MotionKind kind, Vec3 to) {
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

TEST(DefaultStock, EndsAtTheHighestCutBelowTheFirstPlunge) {
  EXPECT_EQ(Path()
                .rapid({0, 0, 5})
                .cut({0, 0, -1})
                .cut({50, 0, -1})
                .cut({50, 0, -3})
                .cut({0, 0, -3})
                .top(),
            -1);
  // A ramp from the approach down: its upper end is in the air.
  EXPECT_EQ(Path().rapid({0, 0, 5}).cut({9, 0, -1}).cut({50, 0, -1}).cut({50, 9, -4}).top(), -1);
  // Rapids down to each level: the first cut is one.
  EXPECT_EQ(Path().rapid({0, 0, -1}).cut({50, 0, -1}).rapid({0, 0, -3}).cut({50, 0, -3}).top(), -1);
}

TEST(DefaultStock, HolesAloneEndWhereTheFeedBegins) {
  EXPECT_EQ(Path().rapid({0, 0, 2}).cut({0, 0, -12}).rapid({0, 0, 2}).top(), 2);
}

}  // namespace
}  // namespace mrsim
