// Moves as tests write them.
#pragma once

#include "core/numbers/vec.h"
#include <mrsim/types.h>

#include <cmath>

namespace mrsim::testing {

/// A straight cut by tool 0, made by line `number` of the program.
inline Motion line(Vec3 a, Vec3 b, int number = 1) {
  Motion m;
  m.kind = MotionKind::line;
  m.start = a;
  m.end = b;
  m.tool = 0;
  m.line = number;
  return m;
}

/// Rotation of v about a unit axis (Rodrigues), with libm.
inline Vec3 turned(const Vec3& v, const Vec3& axis, double angle) {
  return std::cos(angle) * v + std::sin(angle) * cross(axis, v) +
         (1 - std::cos(angle)) * dot(axis, v) * axis;
}

/// A cut along an arc by tool 0: sweep in radians about the axis, rise along it in mm.
inline Motion arc(Vec3 start, Vec3 center, Vec3 axis, double sweep, double rise = 0) {
  Motion m;
  m.kind = MotionKind::arc;
  m.start = start;
  m.center = center;
  m.axis = axis;
  m.sweep = sweep;
  m.rise = rise;
  m.radius = length(start - center);
  m.end = center + turned(start - center, axis, sweep) + rise * axis;
  m.tool = 0;
  m.line = 1;
  return m;
}

}  // namespace mrsim::testing
