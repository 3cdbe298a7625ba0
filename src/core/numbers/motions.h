// What all stages ask of a motion.
#pragma once

#include "core/numbers/vec.h"
#include <mrsim/types.h>

#include <cmath>
#include <cstddef>

namespace mrsim {

/// Whether the motion removes material: a line or an arc whose start is known.
inline bool is_cut(const Motion& m) { return m.kind != MotionKind::rapid && !m.assumed_start; }

/// Whether the motion has any length.
inline bool moves(const Motion& m) {
  return m.kind == MotionKind::arc ? m.sweep != 0 : !(m.start == m.end);
}

/// mm of the tool's way.
inline double length_of(const Motion& m) {
  if (m.kind != MotionKind::arc) return distance(m.start, m.end);
  const double round = m.sweep * m.radius;
  return std::sqrt(round * round + m.rise * m.rise);
}

/// Whether the motion leads straight up or down.
inline bool is_upright_line(const Motion& m) {
  return m.kind != MotionKind::arc && m.start.x == m.end.x && m.start.y == m.end.y;
}

/// Whether the motion keeps its height, on a horizontal line or arc of a tool along Z.
inline bool is_level(const Motion& m) {
  const bool is_flat = m.kind != MotionKind::arc || (m.rise == 0 && m.axis == m.tool_axis);
  return is_flat && m.tool_axis == Vec3{0, 0, 1} && m.start.z == m.end.z;
}

/// Where the motion stands in its program.
inline SourcePlace source_place(const Program& program, const Motion& m) {
  return {program.files[static_cast<std::size_t>(m.file)], m.line, m.column};
}

}  // namespace mrsim
