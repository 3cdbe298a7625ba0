// Passes finished moves on: tool length, then corner rounding, radius compensation, and the sink.
// Private to src/interp.
#pragma once

#include "interp/moves/cut_end.h"
#include "interp/moves/length_switch.h"
#include "interp/moves/travel_check.h"
#include "interp/moves/undescribed_tool.h"
#include "interp/path/compensation.h"
#include "interp/text/motion_sink.h"
#include "interp/tools/compensation_words.h"

#include <limits>
#include <vector>

namespace mrsim {

class MotionEmitter : public ControlPart {
 public:
  MotionEmitter(Control& control, CompensationWords& compensation, MotionSink& sink);

  /// Emits a move with the corner words of its block.
  void emit(const Motion& motion);
  void emit(Motion motion, const CornerSpec& corner);
  /// Emits an event behind the motions so far, with place and tool of the block. While the contour
  /// of a cycle is read, there are no events.
  void event(Event event);
  /// Before a block: hands the sink's mark on behind what was held back.
  void mark();
  /// The tool stays for `seconds`; nothing happens where they are not above 0.
  void dwell(double seconds);
  /// Emits the event of another tool in the spindle, once for each change.
  void change_tool();
  /// The corner that RND, CHF or CHR of the block, else RNDM, asks for.
  CornerSpec corner_spec();
  void scale_corner(CornerSpec& spec);
  /// Emits what was held back, at the end of the program.
  void flush();
  /// The most motions of a contour that are kept.
  static constexpr std::size_t kMostCaptured = 1'000'000;
  /// From now on motions go to `contour`, with corners inserted and without compensation; null: to
  /// the sink again. Motions before this call go to the sink.
  void capture(std::vector<Motion>* contour);
  bool captures() const { return captured_ != nullptr; }
  /// How many motions blocks have made so far, including those of contours that are kept.
  std::size_t made() const { return made_; }
  /// The tool goes to a place that only the machine knows.
  void leave_part() { cut_end_.leave(); }
  /// Whether the last motion was a cut that did not leave the part.
  bool ends_in_cut() const { return cut_end_.in_cut(); }
  /// How many lines and arcs have been emitted.
  std::size_t cuts() const { return control_.cuts; }
  /// The largest coordinate at which a line or an arc ends, mm.
  double farthest_cut() const { return farthest_cut_; }
  /// The lowest speed of a lathe's spindle in a cut under G96, rev/min, without its limit;
  /// infinite: there was no such cut.
  double slowest_turn() const { return slowest_turn_; }

 private:
  PathMove path_move(const Motion& motion, const CornerSpec& corner) const;
  void note_cut(Motion& motion);
  void warn_void_corner(const CornerSpec& corner);
  void note_zero();
  double length_number() const;
  void check_length();
  void check_length_mode(const Motion& motion);
  void turn_to_plus(Motion& motion);
  bool may_stand_below() const;
  void refuse_undescribed_tool(const Motion& motion);
  void refuse_live_tool(const Motion& motion);
  void warn_unknown_start(const Motion& motion);
  void give(const PathMove& move);
  void give_events(std::size_t order);
  void send(const Motion& motion, AxisSet checked_axes);
  void turned_corner(const Word*& round, const Word*& leg);

  CompensationWords& words_;
  MotionSink& sink_;
  TravelCheck travel_;
  CornerStage corners_;
  CompensationStage compensation_;
  std::vector<Motion>* captured_ = nullptr;
  double farthest_cut_ = 0, slowest_turn_ = std::numeric_limits<double>::infinity();
  std::size_t made_ = 0;
  CornerStage captured_corners_;
  /// An event or a mark behind the first `moves` of the moves that were held back.
  struct HeldEvent {
    std::size_t moves = 0;
    Event event;
    int mark = 0;
  };
  std::vector<HeldEvent> events_;
  std::size_t held_moves_ = 0;
  bool tool_told_ = false;
  std::string told_tool_;
  bool idle_ = true;
  CutEnd cut_end_;
  double last_length_ = 0;
  UndescribedTool undescribed_;
  LengthSwitch length_switch_;
  int unknown_starts_ = 0;  ///< cuts in a row that end where an axis is unknown
};

}  // namespace mrsim
