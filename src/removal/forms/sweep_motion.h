// A motion as seen by a milling tool: path, extent, and its coefficients in plan.
#pragma once

#include "core/numbers/vec.h"
#include "removal/tool/tool.h"

namespace mrsim {

inline constexpr double kNoTravel = 1e-11;  ///< mm: less rise or travel than this is none

/// Rotation into the frame of a tilted tool: rows are its axes.
struct ToolFrame {
  Vec3 x, y, z;
  Vec3 in(const Vec3& p) const { return {dot(x, p), dot(y, p), dot(z, p)}; }
  Vec3 out(const Vec3& p) const { return p.x * x + p.y * y + p.z * z; }
};

/// A motion in the frame of its tool.
struct LocalMotion {
  bool arc = false;
  Vec3 start, end;
  Vec3 center, u, v, rise;  ///< arc; rise per radian
  double sweep = 0;         ///< radians, positive
};

/// Up and down on the Z axis, as lathes drill.
bool runs_on_axis(const Motion& m);

/// The motion in the frame of its tool; null: the stock's own.
LocalMotion localized(const Motion& m, const ToolFrame* frame);

/// A box around the positions of the tip, in the frame of the tool.
Box3 path_bounds(const LocalMotion& l);
/// No position of the tip is lower, in the frame of the tool; mm.
double lowest_tip(const LocalMotion& l);

/// A box around what the tool sweeps, in the stock's coordinates.
Box3 sweep_bounds(const Profile& tool, const LocalMotion& l, const ToolFrame* frame);
/// Bounds of what the tool sweeps on a path within this box of the tool's frame.
Box3 sweep_bounds(const Profile& tool, Box3 path, const ToolFrame* frame);

/// Fills LineSlot::x .. dy, or ArcSlot::x .. sine (removal/field/record_slots.h).
void line_in_plan(const Vec3& a, const Vec3& b, double* c);
void arc_in_plan(const LocalMotion& l, double* c);

/// A cutter that reaches up removes nothing with the higher turns of a helix that the lowest does
/// not. Turns the path so that it falls, and keeps its last turn.
void keep_lowest_turn(LocalMotion& l);

}  // namespace mrsim
