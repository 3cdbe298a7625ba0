// Random turning programs: several inserts, chains of short moves, passes run twice, arcs, and
// moves behind the spindle axis.
#pragma once

#include "sweep_support.h"

#include <vector>

namespace mrsim::testing {

inline Tool blade(double nose) {
  Tool t = insert("", nose, 0, 5);
  t.type = ToolType::grooving;
  return t;
}

inline std::vector<Tool> inserts() {
  return {insert("V", 0.4, 0, 5), insert("D", 0, 0, 5), insert("R", 1.5, 0, 5), blade(0.2),
          insert("C", 0.8, 2, 5)};
}

/// Moves of one to three of `inserts()` about `radius` from the axis, z from 0 to `length`.
inline std::vector<Motion> turning_moves(Random& r, int count, double radius, double length) {
  std::vector<Motion> list;
  const double steps[] = {0.002, 0.05, 0.4, 3};
  const int first = r.pick(5), tools = 1 + r.pick(3);
  while (static_cast<int>(list.size()) < count) {
    const double step = steps[r.pick(4)];
    const int tool = (first + r.pick(tools)) % 5;
    Vec3 at{radius * r(r.pick(4) == 0 ? -0.5 : 0.3, 1.1), 0, r(0, length)};
    Vec3 way{r(-1, 1), 0, r(-1, 1)};
    const std::size_t begin = list.size();
    for (int i = 3 + r.pick(60); i > 0; --i) {
      way = normalized(way + Vec3{r(-0.2, 0.2), 0, r(-0.2, 0.2)});
      const Vec3 to = at + step * way;
      Motion m = line(at, to);
      if (r.pick(12) == 0)
        m = arc(at, at + step * Vec3{r(-2, 2), 0, r(-2, 2)}, {0, 1, 0}, r(-6.2, 6.2));
      m.tool = tool;
      m.start.y = m.end.y = m.center.y = 0;
      list.push_back(m);
      at = m.end;
    }
    if (r.pick(3) > 0) continue;
    const std::vector<Motion> again(list.begin() + static_cast<std::ptrdiff_t>(begin), list.end());
    list.insert(list.end(), again.begin(), again.end());
  }
  return list;
}

}  // namespace mrsim::testing
