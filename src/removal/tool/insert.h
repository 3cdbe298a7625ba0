// Turning inserts as convex polygons about the programmed point.
//
// Frame: x = X (radius), y = Z. The nominal tool is external, right hand: it feeds towards -Z from
// outside (+X). Its main cutting edge makes the lead angle with the feed, so it leaves the nose
// along (sin k, -cos k), and the insert lies on the far side of it. Left hand mirrors Z, inside
// work mirrors X. Tip orientation (cutting edge position) says where the theoretical tip lies as
// seen from the nose centre: 1 (+X,+Z), 2 (+X,-Z), 3 (-X,-Z), 4 (-X,+Z), 5 +Z, 6 +X, 7 -Z, 8 -X, 9
// the centre itself; so 3 is external right hand, 2 a boring bar, 8 a neutral tool or groover.
#pragma once

#include "core/numbers/vec.h"
#include <mrsim/types.h>

#include <vector>

namespace mrsim {

/// Convex core polygon of an insert, counter-clockwise in (x = X, y = Z), and its thickness.
struct InsertOutline {
  std::vector<Vec2> core;  ///< about the programmed point; one point for a round insert
  double round = 0;        ///< nose radius, mm
  bool inside = false;     ///< works on the inside (boring): never reaches beyond the spindle axis
};

/// make_tool_shape() for a turning insert.
InsertOutline make_insert(const Tool& tool);

}  // namespace mrsim
