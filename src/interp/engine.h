// The interpreter proper: one Engine reads one program. Private to src/interp; split over
// engine_*.cpp by subject.
#pragma once

#include "interp/arc.h"
#include "interp/compensation.h"
#include "interp/engine_types.h"
#include "interp/parser.h"
#include "interp/start_modes.h"
#include "interp/subprogram.h"
#include "interp/tool_comment.h"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace mrsim {

class Engine {
 public:
  /// The first `leader_lines` of the file lie before the tape mark and are not read.
  Engine(const InterpOptions& options, Program& program, int leader_lines, MotionSink& sink);
  void run();

 private:
  // engine.cpp: blocks
  bool read_block();
  void execute();
  bool index_words();
  bool legal_address(const Word& word);
  bool interpret_block();
  bool apply_code(const Word& word, const CodeEntry& entry);
  bool refuse_cycle(const Word& word, const CodeEntry& entry);
  CodeEntry lookup(const Word& word) const;
  bool claim_group(const Word& word, const CodeEntry& entry);
  bool report_unused();
  const Word* find(Address a) const {
    const Slot& slot = slots_[static_cast<std::size_t>(a)];
    return slot.epoch == epoch_ ? &block_.words[slot.index] : nullptr;
  }
  const Word* take(Address a) {
    Slot& slot = slots_[static_cast<std::size_t>(a)];
    if (slot.epoch != epoch_) return nullptr;
    slot.used = true;
    return &block_.words[slot.index];
  }
  const Word* take(char c) { return take(letter(c)); }
  const Word* peek(char c) const { return find(letter(c)); }
  std::string text_of(const Word& word) const;
  bool error(const char* code, const std::string& text, const Word& word);
  void warning(const char* code, const std::string& text, const Word& word);
  void note_once(const char* code, const std::string& text, const Word& word,
                 const std::string& key);
  bool is(Dialect d) const { return dialect_ == d; }
  bool lathe() const { return program_.machine == MachineKind::lathe; }
  double scale() const { return modal_.inch ? 25.4 : 1.0; }
  double feed_scale() const { return modal_.inch_feed ? 25.4 : 1.0; }
  Code current_motion() const {
    return block_motion_ != Code::unknown ? block_motion_ : modal_.motion;
  }

  // engine_modal.cpp: values that last, M words
  bool apply_modal_code(const Word& word, const CodeEntry& entry);
  bool apply_mode(Code code, const Word& word);
  bool apply_feed_mode(Code code, const Word& word);
  bool apply_comp_code(Code code, const Word& word);
  bool select_distance(Code code, const Word& word);
  bool select_plane(int plane, const Word& word);
  bool select_normal(const Word& word);
  bool apply_values();
  bool apply_feed();
  bool apply_speed();
  bool apply_edge();
  bool apply_length();
  bool apply_codesys_values();
  bool apply_m_words();
  bool apply_m_word(const Word& word);

  // engine_oneshot.cpp
  bool run_oneshot();
  bool dwell();
  bool reference();
  bool reference_sinumerik();
  bool set_position();
  bool position_jump();
  bool workpiece();
  bool set_workpiece(const std::string& type, const std::array<double, 12>& v, const Word& where);

  // engine_comp.cpp
  bool start_compensation(const Motion& motion, const Word& where);
  void check_comp_selection(Code before);
  void set_comp_radius();
  Vec2 tip_vector(const Tool& tool) const;
  Compensation compensation() const;

  // engine_frames.cpp
  bool run_frame();
  bool frame_in_range();
  bool frame_arguments(Vec3& values, unsigned& named, bool lengths);
  bool rotation_arguments(Frame& frame);
  bool sinumerik_frame(Vec3 values, unsigned named);
  bool fanuc_frame(const Word& word);
  bool fanuc_scaling(const Word& word, const Vec3& center);
  void set_mirror();
  bool codesys_frame();
  bool pole();
  bool select_work(const CodeEntry& entry, const Word& word);
  void set_work(const std::string& name);
  void save_frames();
  void rebuild_frame();
  Frame frame_now() const;

  // engine_axes.cpp
  bool target(Target& out, const Vec3& from);
  bool axis_word(Target& out, int axis, const Word& word, bool incremental_word);
  bool polar_target(Target& out);
  bool fanuc_polar_target(Target& out, const Vec3& from);
  bool angle_target(Target& out, const Vec3& from);
  double axis_value(int axis, const Word& word, bool incremental) const;
  double length_unit(const Word& word) const;
  double last_polar_angle(const Basis& b) const;
  bool named_along(const Target& out, const Vec3& direction) const;
  bool has_move() const;
  Basis basis() const;
  Basis stock_basis() const;

  // engine_motion.cpp
  bool move();
  bool line_move(const Target& to, const Frame& frame);
  bool hold_angle(const Word& ang);
  bool two_angle_lines(const Target& to, const Vec3& from, const Frame& frame);
  bool thread_values(const Target& to, const Vec3& from);
  const Word* motion_word(const Target& to) const;
  Motion motion_template(const Word& where, MotionKind kind);
  void begin_cut(const Word& where);
  void commit(const Target& to, const Frame& frame, Motion& motion);
  void emit(const Motion& motion);
  void emit_with(Motion motion, const CornerSpec& corner);
  void output(const Motion& motion) { sink_.motion(motion); }
  CornerSpec corner_spec();

  // engine_arc.cpp, engine_arc_space.cpp
  bool arc_move(const Vec3& from, const Frame& frame);
  bool arc_to_line(const char* code, const std::string& text, const ArcBlock& arc);
  bool center_words(const ArcBlock& arc, Vec2& center, bool& given);
  bool radius_arc(ArcBlock& arc, const Word& word);
  bool near_half_circle(const PlaneArc& arc, const Word& word);
  bool center_arc(ArcBlock& arc, Vec2 center);
  void hint_sign(const ArcBlock& arc, Vec2 center);
  bool check_center(ArcBlock& arc, PlaneArc& solved, bool& straight);
  std::string sign_hint(const ArcBlock& arc, Vec2 center) const;
  bool angle_arc(ArcBlock& arc, const Word& word, bool centered, Vec2 center);
  bool turned_arc(ArcBlock& arc, Vec2 center, double angle);
  bool codesys_angle_arc(ArcBlock& arc, const Word& t, bool centered, Vec2 center);
  bool add_turns(PlaneArc& arc);
  bool finish_arc(PlaneArc solved, ArcBlock& arc);
  bool via_point(const ArcBlock& arc, Vec3& via);
  bool three_point_arc(ArcBlock& arc);
  bool emit_spatial_arc(ArcBlock& arc, const SpatialArc& solved, double sweep);
  bool tangent_arc(ArcBlock& arc);

  // engine_tools.cpp
  bool apply_tool();
  void read_comments();
  void change_tool();
  bool resolve_tool(const std::string& id, Tool& out) const;
  void fill_from_hint(const ToolHint& hint, Tool& out) const;
  void require_tool(const Word& where, bool cuts);
  void tool_missing(const Word& where);
  const OffsetRegister* find_register(const std::string& name) const;

  // engine_calls.cpp
  bool run_flow();
  bool alone(const Word& call);
  bool call_subprogram(const SubprogramName& name, long repeats, const Word& word);
  bool fanuc_call(const Word& word);
  bool named_call(const Word& word);
  void missing_return();
  void end_of_tape();
  void end_activation();
  void stop();
  int call_site(int line);

  const InterpOptions& options_;
  Program& program_;
  MotionSink& sink_;
  Reporter reporter_;
  Dialect dialect_;
  int leader_lines_;
  Parser parser_;
  SubprogramIndex subprograms_;
  const CodeTable& codes_;

  std::vector<Activation> stack_;
  Block block_;
  std::array<Slot, static_cast<std::size_t>(Address::count)> slots_;
  std::uint32_t epoch_ = 0;
  std::uint64_t groups_ = 0;
  std::size_t executed_ = 0;
  std::size_t blocks_ = 0;  ///< those of them with words

  Modal modal_;
  Position position_;
  Frames frames_, saved_frames_;
  bool frames_changed_ = false;

  // This block's own.
  const Word* motion_code_ = nullptr;
  const Word* oneshot_ = nullptr;
  const Word* frame_code_ = nullptr;
  Code oneshot_code_{}, frame_op_{}, block_motion_{};
  bool suppress_ = false;
  bool comp_selected_ = false;
  bool tool_change_ = false;
  bool stop_after_ = false;
  bool return_after_ = false;
  bool m99_ = false;
  bool length_changed_ = false;
  const Word* call_word_ = nullptr;
  const Word* m98_ = nullptr;
  Word comp_word_, edge_word_;

  PendingAngle pending_angle_;
  bool in_cycle_ = false;  ///< of a modal cycle that is not read: points belong to it

  ToolState tool_;
  std::optional<ToolState> saved_tool_;  ///< before the T or M6 of this block
  std::map<std::string, ToolHint> hints_;
  ToolHint loose_hint_;  ///< of the comment before this block
  bool has_loose_hint_ = false;

  CornerStage corners_;
  CompensationStage compensation_;
  bool contour_idle_ = true;
  bool comp_started_ = false;
  bool comp_moved_ = false;
  double comp_radius_ = 0;
  Vec2 comp_tip_;
  std::string comp_key_;
  int comp_tool_ = -2;
  double last_length_ = 0;
  std::size_t cuts_ = 0;
  bool feed_warned_ = false;
};

bool is_circular(Code c);
bool is_thread(Code c);
/// "end mill 5 mm"
std::string tool_summary(const Tool& tool);

}  // namespace mrsim
