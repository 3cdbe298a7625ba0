// What the parts of a control share: the program, the block being read, the state in force. Each
// part (frames, tools, arcs ...) is a class of its own that derives from ControlPart and names what
// it needs. Guarantees: a rejected block leaves no trace in the state. Private to src/interp.
#pragma once

#include "interp/control/block_words.h"
#include "interp/control/set_lengths.h"
#include "interp/control/state.h"
#include "interp/path/frames.h"
#include "interp/text/reporter.h"
#include <mrsim/options.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace mrsim {

/// A tool that T has named, and to which M6 has not changed yet.
struct PendingTool {
  bool active = false;
  std::string id;
  Motion at;  ///< only its place counts
  bool beside_motion = false;
  bool leaves = false;  ///< T0100 of a lathe
};

/// What T and M6 have done so far.
struct ToolState {
  PendingTool pending;
  std::string current;  ///< id in the spindle
  std::string shown;    ///< id of its data: current, or "1 (line 11)", see CalledAgain
  double written = -1;  ///< the last T; below 0 = none, or a name
  Motion place;         ///< where its T word stands
  int index = -1;       ///< into Program::tools, -1 = not used yet
  bool chosen = false;
  bool direct_change = false;  ///< a mill without M6: T changes at once
  bool failed = false;
  bool came_unnamed = false;  ///< an M6 stood before any T word
  bool assumed = false;       ///< a T word without M6 was the last to name a tool
  bool below = false;         ///< a turning tool cuts at X below 0, see MotionEmitter
};

struct Control {
  Control(const InterpOptions& options_in, Program& program_in, Reporter& reporter_in)
      : options(options_in),
        program(program_in),
        reporter(reporter_in),
        dialect(program_in.dialect) {}

  /// Finds where the machine's coordinates lie in those of the stock, and moves the work offsets.
  void shift_machine();

  const InterpOptions& options;
  Program& program;
  Reporter& reporter;
  Dialect dialect;

  BlockWords block;
  Modal modal;
  Position position;
  Frames frames;
  ToolState tool;
  Word edge_word;                ///< the last D
  std::vector<WorkOffset> work;  ///< of the tool table, changed by G10
  /// Added to machine coordinates, gives those of the stock, where machine_known; else 0.
  Vec3 machine_shift;
  bool machine_known = false;
  std::optional<Vec3> stored_places[2];      ///< set by G28.1 and G30.1, in the stock's coordinates
  Vec3 intermediate;                         ///< of the last G28 and G30, as programmed
  AxisSet has_intermediate;                  ///< its axes
  std::map<std::string, double> work_turns;  ///< turns of work offsets about Z, degrees, by name
  std::vector<OffsetRegister> registers;     ///< of the tool table, changed by G10
  /// Wears of numbers without a register, in which case the radius is that of the tool.
  std::map<std::string, double> bare_wears;
  SetLengths lengths;
  std::size_t cuts = 0;               ///< how many lines and arcs have been emitted
  std::map<long, double> told_noses;  ///< radius of the nose, mm, by the number of a lathe's offset
  std::map<long, int> told_tips;      ///< orientation of the tip, 1 to 8, by the offset or tool
  std::map<std::string, double> kept_values;  ///< SINUMERIK's markers and outputs: $AC_MARKER[1]
  int register_changes = 0;                   ///< how often the program has set a register
  bool skips_data = false;      ///< blocks up to G11 set tool lives or parameters, not read
  bool paused = false;          ///< no motion since M0, or since a tool was changed by hand
  bool untilted_plane = false;  ///< G68.2 without a tilt is in force
  int unread_end = 0;           ///< the word that ends the refused mode in force, see UnreadModes
  int upright_end = 0;          ///< the word that ends a mode that is read while no axis turns
  bool tilted = false;          ///< a rotary axis has left 0, which is an error

  /// The one name, without blanks, of an offset that has several: G154 P1 and G110 of Haas are the
  /// offset G54.1P1.
  std::string offset_name(std::string_view written) const;
  /// The register of that name, made if there is none. It counts as changed by the program.
  OffsetRegister& change_register(const std::string& name);
  /// The wear of that name; a number without a register gets one in bare_wears.
  double& change_wear(const std::string& name);
  double bare_wear(const std::string& name) const;

  /// Copies of the state before this block, made by the parts that change it.
  std::optional<Frames> saved_frames;
  std::optional<ToolState> saved_tool;
};

/// Whether the motion is an arc: G2, G3 and their kin.
bool is_circular(Code c);
/// Whether the motion cuts or taps a thread.
bool is_thread(Code c);

class ControlPart {
 protected:
  explicit ControlPart(Control& control)
      : control_(control),
        options_(control.options),
        program_(control.program),
        reporter_(control.reporter),
        block_(control.block),
        modal_(control.modal),
        position_(control.position),
        frames_(control.frames) {}

  bool is(Dialect d) const { return control_.dialect == d; }
  bool lathe() const { return program_.machine == MachineKind::lathe; }
  /// How many mm a length of 1 and a feed of 1 are.
  double scale() const { return modal_.inch ? 25.4 : 1.0; }
  double feed_scale() const { return modal_.inch_feed ? 25.4 : 1.0; }
  Code current_motion() const {
    return block_.motion != Code::unknown ? block_.motion : modal_.motion;
  }
  /// The axes of the plane in force.
  Basis basis() const {
    return modal_.plane == kPlaneOfNormal ? normal_basis(modal_.normal) : plane_basis(modal_.plane);
  }
  /// The factor by which the frames in force scale the plane; 0: unequally.
  double plane_factor() const { return plane_scale(frames_.total, basis().u, basis().v); }
  /// The axes of basis() in the stock's coordinates, of length 1; left-handed under a mirror.
  Basis stock_basis() const;
  /// FANUC: whether a variable or an expression gives the word its value.
  bool is_computed(const Word& word) const {
    return text_of(word).find_first_of("#[") != std::string::npos;
  }
  /// Tells that a value without a decimal point, or a computed one, counts least increments.
  void note_increments(const Word& word);
  /// How many mm a length of 1 in `word` is.
  double length_unit(const Word& word) const;
  /// The angle of the word, degrees.
  double angle_value(const Word& word) const;
  /// The length of the word in mm; X of a lathe as a radius.
  double axis_value(int axis, const Word& word, bool incremental) const;

  /// The address of a line's angle: ANG= or ,A; on FANUC lathes also A.
  Address angle_address() const {
    const bool plain = lathe() && is(Dialect::fanuc) && current_motion() == Code::line;
    return plain && !find(Address::ang) ? letter('A') : Address::ang;
  }

  /// Whether a line may run against its angle, as A-30 for A150: FANUC reads only the slope. A
  /// warning says so once.
  bool angle_of_slope(const Word& angle);

  const Word* find(Address a) const { return block_.find(a); }
  const Word* take(Address a) { return block_.take(a); }
  const Word* take(char c) { return block_.take(letter(c)); }
  const Word* peek(char c) const { return block_.find(letter(c)); }
  std::string text_of(const Word& word) const { return block_.text_of(word); }

  /// The lead of a thread, mm per revolution: the block's F, or E where a FANUC lathe has it
  /// instead.
  std::optional<double> thread_lead();
  /// The F in force as a lead, as feeds and leads of FANUC's lathes have one F; 0: none.
  double feed_as_lead() const;
  /// Puts the F of a thread, in mm, in force as the feed where feeds and leads have one F.
  void keep_lead_as_feed(double lead);

  /// From here on nobody knows where these axes are. A lathe has no Y to lose.
  void forget_place(AxisSet axes) { position_.known -= lathe() ? axes - kAxisY : axes; }

  /// Makes the block of a cycle the current one again, after its contour was read.
  void put_back_block(const BlockPlace& place) {
    block_.put_back(place);
    reporter_.set_place(place.file, place.line, place.call, {});
  }
  /// Whether the block of a cycle with a contour goes on behind it. False: it also calls or ends
  /// the program, which is reported.
  bool goes_on(const Word& cycle);
  /// Reports and returns false.
  bool error(const char* code, const std::string& text, const Word& word);
  void warning(const char* code, const std::string& text, const Word& word);
  void note_once(const char* code, const std::string& text, const Word& word,
                 const std::string& key);

  Control& control_;
  const InterpOptions& options_;
  Program& program_;
  Reporter& reporter_;
  BlockWords& block_;
  Modal& modal_;
  Position& position_;
  Frames& frames_;
};

}  // namespace mrsim
