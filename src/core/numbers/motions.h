// What all stages ask of a motion.
#pragma once

#include <mrsim/types.h>

namespace mrsim {

/// Whether the motion removes material: a line or an arc whose start is known.
inline bool is_cut(const Motion& m) { return m.kind != MotionKind::rapid && !m.assumed_start; }

/// Whether the motion has any length.
inline bool moves(const Motion& m) {
  return m.kind == MotionKind::arc ? m.sweep != 0 : !(m.start == m.end);
}

/// Whether the motion leads straight up or down.
inline bool is_upright_line(const Motion& m) {
  return m.kind != MotionKind::arc && m.start.x == m.end.x && m.start.y == m.end.y;
}

}  // namespace mrsim
