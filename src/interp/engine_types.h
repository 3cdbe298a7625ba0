// Small values that the engine works with. Private to src/interp.
#pragma once

#include "interp/contour.h"
#include "interp/source.h"
#include "interp/state.h"

#include <memory>
#include <string>

namespace mrsim {

/// A program being read: the main one, or a subprogram under way.
struct Activation {
  std::unique_ptr<LineSource> source;
  std::string_view line;
  std::size_t position = 0;
  bool has_line = false;
  bool started = false;  ///< a block was executed
  int file = 0;
  int call = -1;
  int repeats = 0;  ///< further runs after this one
  std::uint64_t begin = 0;
  int begin_line = 0;
  std::string name;
};

/// Word of a block by address; epochs make clearing free.
struct Slot {
  std::uint32_t epoch = 0;
  std::uint16_t index = 0;
  bool used = false;
};

/// Where a move goes, in the frame in force.
struct Target {
  Vec3 programmed;
  unsigned named = 0;     ///< axes with a word
  unsigned absolute = 0;  ///< ... of which absolute
  const Word* first = nullptr;
};

/// The first of two blocks ANG=: it waits for the second.
struct PendingAngle {
  bool active = false;
  double angle = 0;
  Motion motion;
  CornerSpec corner;
};

/// A tool that T named and M6 has not yet changed to.
struct PendingTool {
  bool active = false;
  std::string id;
  Motion at;  ///< only its place counts
};

/// What T and M6 have done so far.
struct ToolState {
  PendingTool pending;
  std::string current;  ///< id in the spindle
  Motion place;         ///< of its T word
  int index = -1;       ///< into Program::tools, -1 = not used yet
  bool chosen = false;
  bool direct_change = false;  ///< a mill without M6: T changes at once
  bool failed = false;
};

/// A circular block while it is being worked out.
struct ArcBlock {
  Target to;
  Vec3 from;
  Frame frame;
  Basis basis;  ///< of the plane, in the frame in force
  bool ccw = false;
  Vec2 start, end;
  const Word* where = nullptr;
  bool closing = false;  ///< a line of a hair's breadth closes to the programmed end
};

}  // namespace mrsim
