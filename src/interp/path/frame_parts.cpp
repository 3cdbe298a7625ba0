#include "interp/path/frame_parts.h"

#include "core/numbers/rounding.h"
#include "core/numbers/trig.h"
#include "core/numbers/units.h"
#include "interp/text/characters.h"

#include <cmath>

namespace mrsim {
namespace {

constexpr double kLeastScale = 1e-100, kLargestTurn = 1e9;

// The value as a program would write it, with nine digits behind the point.
double written(double value) { return std::round(value * 1e9) / 1e9; }

// The angles of a rotation Rz Ry Rx, degrees.
Vec3 turns_of(const std::array<Vec3, 3>& axis) {
  const double level = std::sqrt(axis[0].x * axis[0].x + axis[0].y * axis[0].y);
  Vec3 turns;
  turns.y = atan2(-axis[0].z, level);
  if (level > kTurnRounding) {
    turns.z = atan2(axis[0].y, axis[0].x);
    turns.x = atan2(axis[1].z, axis[2].z);
  } else {  // X points up or down, so a turn about it is one about Z
    turns.z = atan2(-axis[1].x, axis[1].y);
  }
  return {written(degrees(turns.x)), written(degrees(turns.y)), written(degrees(turns.z))};
}

double sum(const Vec3& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); }

}  // namespace

int axis_named(std::string_view name) {
  return name.size() == 1 && upper(name[0]) >= 'X' && upper(name[0]) <= 'Z' ? upper(name[0]) - 'X'
                                                                            : -1;
}

Frame frame_of(const FrameParts& parts) {
  Frame frame = shift_frame(parts.shift);
  for (const int axis : {2, 1, 0})
    if (component(parts.turns, axis) != 0)
      frame = compose(frame, rotation_frame(axis, component(parts.turns, axis)));
  Vec3 factors = parts.scale;
  for (int i = 0; i < 3; ++i)
    if (parts.mirrored.has(i)) component(factors, i) = -component(factors, i);
  return factors == Vec3{1, 1, 1} ? frame : compose(frame, scale_frame(factors));
}

// A left-handed frame may mirror any axis. The one that leaves the smallest turns is chosen.
std::optional<FrameParts> parts_of(const Frame& frame) {
  FrameParts parts;
  parts.shift = frame.shift;
  if (frame.plain) return parts;
  std::array<Vec3, 3> axis = frame.axis;
  for (std::size_t i = 0; i < 3; ++i) {
    const double factor = length(axis[i]);
    if (!(factor > kLeastScale && factor < 1 / kLeastScale)) return std::nullopt;
    component(parts.scale, static_cast<int>(i)) = written(factor);
    axis[i] = (1 / factor) * axis[i];
  }
  for (std::size_t i = 0; i < 3; ++i)
    if (std::abs(dot(axis[i], axis[(i + 1) % 3])) > kTurnRounding) return std::nullopt;
  if (determinant(frame) > 0) {
    parts.turns = turns_of(axis);
    return parts;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    std::array<Vec3, 3> other = axis;
    other[i] = -1 * other[i];
    const Vec3 turns = turns_of(other);
    if (!parts.mirrored.empty() && sum(turns) >= sum(parts.turns)) continue;
    parts.turns = turns;
    parts.mirrored = AxisSet(static_cast<int>(i));
  }
  return parts;
}

std::optional<double> frame_part(const Frame& frame, int axis, std::string_view part) {
  if (axis < 0) return std::nullopt;
  if (part == "TR") return component(frame.shift, axis);
  const std::optional<FrameParts> parts = parts_of(frame);
  if (!parts) return std::nullopt;
  if (part == "RT") return component(parts->turns, axis);
  if (part == "SC") return component(parts->scale, axis);
  if (part == "MI") return parts->mirrored.has(axis) ? 1 : 0;
  return std::nullopt;
}

bool set_frame_part(Frame& frame, int axis, std::string_view part, double value) {
  if (axis < 0) return false;
  if (part == "TR") {
    component(frame.shift, axis) = value;
    return true;
  }
  std::optional<FrameParts> parts = parts_of(frame);
  if (!parts) return false;
  if (part == "RT" && std::abs(value) <= kLargestTurn) {
    component(parts->turns, axis) = value;
  } else if (part == "SC" && value != 0) {
    component(parts->scale, axis) = value;
  } else if (part == "MI") {
    parts->mirrored -= AxisSet(axis);
    if (value != 0) parts->mirrored.add(axis);
  } else {
    return false;
  }
  frame = frame_of(*parts);
  return true;
}

}  // namespace mrsim
