#include "interp/moves/undescribed_tool.h"

#include "core/numbers/motions.h"

#include <algorithm>
#include <cmath>

namespace mrsim {
namespace {

constexpr double kAtAxis = 0.05;  // mm: a drill that runs out by less still drills on the axis
constexpr double kFreed = 0.02;   // mm: bars leave the wall of their bore by more
constexpr double kPlunge = 1;     // mm: faces are cut above this depth, grooves below it
constexpr double kFaceStep = 3;   // mm: the deepest pass of a face that is cut below another one
constexpr double kLinks = 10;     // mm: the longest way to a face that tools go with the feed
constexpr double kSamePlace = 1e-6;

}  // namespace

UndescribedTool::Kind UndescribedTool::told_by(const Motion& motion, double face, bool faces) {
  if (motion.tool != tool_) faced_ = false;
  tool_ = motion.tool;
  const bool feeds = is_cut(motion);
  const bool drill = drills(motion, feeds), bar = bores(motion, feeds, face);
  const bool blade = plunges(motion, feeds, face) && !faces;
  rapid_ = motion.kind == MotionKind::rapid;
  if (drill) return {"goes in and out along the axis, as a drill does", "drill:d=10", "BAR STOP"};
  if (bar)
    return {"leaves its cut towards the axis, as a bar that bores does", "boring:insert=CCMT,r=0.4",
            "BORING BAR", true};
  if (blade)
    return {"plunges and goes straight back, as a blade does", "grooving:w=3", "GROOVE 3MM"};
  return {};
}

// The tool goes in along the axis with the feed, and back.
bool UndescribedTool::drills(const Motion& motion, bool feeds) {
  const double away = motion.end.z - motion.start.z;
  const bool axial = std::abs(motion.start.x) < kAtAxis && std::abs(motion.end.x) < kAtAxis;
  const bool told = drilled_ && axial && away > 0;
  drilled_ = axial && away < -kAtAxis && motion.kind == MotionKind::line && feeds;
  return told;
}

// The tool leaves a cut along -Z by a rapid that is nearer to the axis. A way down to the face is
// no such cut. What feeds to the axis behind such a way faces the bar; behind a longer one it is at
// the bottom of its bore.
bool UndescribedTool::bores(const Motion& motion, bool feeds, double face) {
  const double away = motion.end.z - motion.start.z;
  const bool told = !feeds && away > kAtAxis && inmost_cut_ < kNothingCut &&
                    motion.start.x < inmost_cut_ + kFreed && motion.end.x > kAtAxis &&
                    motion.end.x < inmost_cut_ - kFreed;
  const bool to_face = motion.start.z < face + kLinks && motion.end.z > face - kSamePlace;
  const bool faces = feeds && motion.end.x < kAtAxis && cut_along_ < kLinks;
  const bool leaves = !feeds && (away > 0 || motion.end.x > inmost_cut_);
  if (faces || leaves) {
    inmost_cut_ = kNothingCut;
    cut_along_ = 0;
  } else if (feeds && away < -kAtAxis && !to_face) {
    inmost_cut_ = std::min({inmost_cut_, motion.start.x, motion.end.x});
    cut_along_ -= away;
  }
  return told;
}

// The tool feeds along X from where a rapid has led, perhaps in strokes, and goes back at the same
// Z.
bool UndescribedTool::plunges(const Motion& motion, bool feeds, double face) {
  const double along = motion.end.x - motion.start.x;
  if (motion.kind == MotionKind::arc || std::abs(motion.end.z - motion.start.z) > kSamePlace ||
      motion.assumed_start) {
    // A tool that leaves towards plus Z has cut a face: a blade would meet the wall of its groove.
    if (plunging_ && !feeds && motion.end.z > motion.start.z) faces_on(motion.start.z, face);
    plunging_ = false;
    return false;
  }
  const double deep = plunged_to_ - plunged_from_;
  if (plunging_ && along * deep < 0) {
    const bool out = (motion.end.x - plunged_from_) * deep <= kSamePlace;
    if (out) plunging_ = false;
    return out && std::abs(deep) > kPlunge && !faces_on(motion.end.z, face);
  }
  if (!feeds || !(plunging_ || rapid_)) {
    plunging_ = false;
    return false;
  }
  if (!plunging_) plunged_from_ = plunged_to_ = motion.start.x;
  plunging_ = true;
  const double deepest = std::abs(plunged_to_ - plunged_from_);
  if (std::abs(motion.end.x - plunged_from_) > deepest) plunged_to_ = motion.end.x;
  return false;
}

// A pass at the face, or one step below a pass that went as far towards the axis.
bool UndescribedTool::faces_on(double z, double face) {
  const bool below = faced_ && z > faced_z_ - kFaceStep - kSamePlace &&
                     plunged_to_ > faced_to_ - kSamePlace && plunged_to_ < plunged_from_;
  if (z < face - kPlunge && !below) return false;
  faced_ = true;
  faced_z_ = z;
  faced_to_ = plunged_to_;
  return true;
}

}  // namespace mrsim
