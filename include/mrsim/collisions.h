/// mrsim: where a part of the tool runs into material that it does not cut.
///
/// Checked are the cutter on rapids, and shank and holder on rapids and cuts, each against the
/// material that is there at that moment: the stock less what the earlier motions cut, and less
/// what the motion itself cuts. A rapid is taken as the straight line from start to end. Motions of
/// assumed start are not checked. docs/collisions.md explains the method and its limits.
#pragma once

#include <mrsim/types.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace mrsim {

enum class ToolPart : std::uint8_t { cutter, shank, holder };

/// The deepest place of one line of the program and one part of its tool.
struct Collision {
  std::size_t motion = 0;  ///< index into Program::motions: the deepest one of the line
  ToolPart part = ToolPart::cutter;
  double depth = 0;         ///< mm from `place` to the surface of the material at that moment
  double volume = 0;        ///< mm^3 of that material that the part meets on the deepest motion
  Vec3 place;               ///< mm, on or in the tool
  std::size_t motions = 1;  ///< of this line that collide with this part
};

struct CollisionReport {
  std::vector<Collision> lines;  ///< the deepest CollisionOptions::lines, in the program's order
  std::size_t more = 0;          ///< lines beyond these
  /// Lines on which rapids that withdraw an insert from its cut scrape thin material beside it, and
  /// do nothing worse (docs/collisions.md, Withdrawals). Not among `lines`.
  struct Withdrawals {
    std::size_t lines = 0;
    std::size_t motion = 0;  ///< index into Program::motions: the deepest one
    double depth = 0;        ///< mm, of that one
  };
  Withdrawals withdrawals;
  /// Tools that move in rapids only and have no valid shape: not checked. Indices into the tools.
  std::vector<int> shapeless;
};

}  // namespace mrsim
