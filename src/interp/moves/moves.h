// Makes the words of a block Motions: lines, rapids, threads, arcs, with feed, speed and tool.
// Moves the position. Private to src/interp.
#pragma once

#include "interp/frames/frame_words.h"
#include "interp/moves/arc_solver.h"
#include "interp/moves/motion_emitter.h"
#include "interp/moves/spline_words.h"
#include "interp/moves/thread_words.h"

namespace mrsim {

inline constexpr MotionKind kRapid = MotionKind::rapid, kLine = MotionKind::line;

class Moves : public ControlPart {
 public:
  Moves(Control& control, AxisWords& axes, FrameWords& frames, ToolChanger& tools,
        CompensationWords& compensation, MotionEmitter& out)
      : ControlPart(control),
        axes_(axes),
        frame_words_(frames),
        tools_(tools),
        compensation_(compensation),
        out_(out),
        arcs_(control, axes),
        splines_(control, axes),
        threads_(control) {}

  /// Carries out the move of the block. False: an error was reported.
  bool run();
  /// A rapid or line to `to`, whatever motion is in force. `lead`: of a tap, mm per revolution.
  /// `feed` 0: the one in force.
  void step(const Target& to, const Word& where, MotionKind kind, double lead = 0, double feed = 0);
  /// As step(), but radius compensation may begin or end with it. False: an error was reported.
  bool compensated_step(const Target& to, const Word& where, double feed,
                        MotionKind kind = MotionKind::line);
  /// Radius and point of the tool, for a cycle that offsets its contour by itself.
  Compensation of_tool() { return compensation_.of_tool(); }
  /// Emits an arc in the frame in force. `feed` 0: the one in force. False: an error was reported.
  bool solved_arc(const SolvedArc& arc, double feed = 0) {
    return emit_arc(arc, frame_words_.now(), feed);
  }
  /// Repeats a motion of a contour from where the tool is, shifted by `shift` (mm), with the feed
  /// in force. It keeps its place in the text.
  void follow(const Motion& like, const Vec3& shift, const Word& where);
  /// A rapid of `axes` to a place in machine coordinates; null: to a place that only the machine
  /// knows.
  void to_place(const Vec3* place, AxisSet axes, const Word& where);
  /// As to_place(), to a place in the stock's coordinates.
  void to_stored(const Vec3& place, AxisSet axes, const Word& where);
  /// `axes` have gone to a place that only the machine knows.
  void unknown(AxisSet axes, const Word& where);
  /// Z has perhaps gone up: it is unknown, unless the next cut goes on without it.
  void guess_retract(const Word& where);
  /// The tool stays where it is for `seconds`; nothing happens where they are not above 0.
  void dwell(double seconds) { out_.dwell(seconds); }
  /// The position becomes `to`, without a path.
  void jump(const Target& to);
  /// Whether the first of two blocks with ANG= is held until the second one is read.
  bool waits() const { return pending_angle_.active; }
  /// Reports what is still open at the end of the program.
  void finish();

 private:
  /// The first of two blocks ANG=: it waits for the second.
  struct PendingAngle {
    bool active = false;
    double angle = 0;
    Motion motion;
    CornerSpec corner;
  };

  bool machine_move();
  bool probe();
  bool refuse_without_motion();
  bool straight(const Vec3& from, const Frame& frame, const Word* ang);
  bool line(const Target& to, const Frame& frame);
  bool arc(const Vec3& from, const Frame& frame);
  bool spline(const Vec3& from, const Frame& frame);
  bool emit_arc(const SolvedArc& arc, const Frame& frame, double feed = 0);
  bool hold_angle(const Word& ang);
  bool two_angle_lines(const Target& to, const Vec3& from, const Frame& frame);
  /// The lead where the motion in force is a thread or a tap; else 0.
  double lead_in_force() const { return is_thread(current_motion()) ? modal_.lead : 0; }
  Motion motion_template(const Word& where, MotionKind kind, double lead = 0, double feed = 0);
  void begin_cut(const Word& where, bool has_feed);
  void compare_origins(const Word& where);
  void commit(const Target& to, const Frame& frame, Motion& motion);

  AxisWords& axes_;
  FrameWords& frame_words_;
  ToolChanger& tools_;
  CompensationWords& compensation_;
  MotionEmitter& out_;
  ArcSolver arcs_;
  SplineWords splines_;
  ThreadWords threads_;
  PendingAngle pending_angle_;
  std::string assumed_origin_;  ///< the first work offset without an entry that cut
  bool feed_warned_ = false;
  bool retract_guessed_ = false;  ///< M25 has perhaps retracted Z, see guess_retract()
};

}  // namespace mrsim
