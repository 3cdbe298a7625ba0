// A frame by its parts, as SINUMERIK counts them: shift, turns about Z, the new Y and the new X,
// scale, mirror images, the innermost last.
#pragma once

#include "core/numbers/axis_set.h"
#include "interp/path/frames.h"

#include <optional>
#include <string_view>

namespace mrsim {

struct FrameParts {
  Vec3 shift;
  Vec3 turns;  ///< degrees, about X, Y, Z
  Vec3 scale{1, 1, 1};
  AxisSet mirrored;
};

/// 0 to 2 for X, Y, Z; -1 for another name.
int axis_named(std::string_view name);

/// The frame that has these parts.
Frame frame_of(const FrameParts& parts);
/// The parts of a frame. Nothing where the frame is sheared.
std::optional<FrameParts> parts_of(const Frame& frame);

/// One part of one axis: TR the shift, RT the turn, SC the scale, MI 1 where it is mirrored.
/// Nothing: the frame has no such part.
std::optional<double> frame_part(const Frame& frame, int axis, std::string_view part);
/// Sets such a part. False: the frame has no such part, or it cannot have that value.
bool set_frame_part(Frame& frame, int axis, std::string_view part, double value);

}  // namespace mrsim
