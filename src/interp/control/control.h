// What the parts of a control share: the program, the block being read, the state in force. Each
// part (frames, tools, arcs ...) is a class of its own that derives from ControlPart and names what
// it needs. Guarantees: a rejected block leaves no trace in the state. Private to src/interp.
#pragma once

#include "interp/control/block_words.h"
#include "interp/control/set_lengths.h"
#include "interp/control/state.h"
#include "interp/text/reporter.h"
#include <mrsim/options.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace mrsim {

/// A tool that T named and M6 has not yet changed to.
struct PendingTool {
  bool active = false;
  std::string id;
  Motion at;  ///< only its place counts
  bool beside_motion = false;
};

/// What T and M6 have done so far.
struct ToolState {
  PendingTool pending;
  std::string current;  ///< id in the spindle
  double written = -1;  ///< the last T; below 0 = none, or a name
  Motion place;         ///< of its T word
  int index = -1;       ///< into Program::tools, -1 = not used yet
  bool chosen = false;
  bool direct_change = false;  ///< a mill without M6: T changes at once
  bool failed = false;
  bool came_unnamed = false;  ///< an M6 stood before any T word
  bool assumed = false;       ///< T alone, without M6, and no other tool since
  bool below = false;         ///< a turning tool that works at X below 0, see MotionEmitter
};

struct Control {
  Control(const InterpOptions& options_in, Program& program_in, Reporter& reporter_in)
      : options(options_in),
        program(program_in),
        reporter(reporter_in),
        dialect(program_in.dialect) {}

  /// Where the machine's coordinates lie in the stock's, and the work offsets that follow from it.
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
  /// From machine coordinates to the stock's, where they are known; else 0.
  Vec3 machine_shift;
  bool machine_known = false;
  std::optional<Vec3> stored_places[2];      ///< by G28.1 and G30.1, in the stock's coordinates
  std::map<std::string, double> work_turns;  ///< about Z, degrees, by the name of the offset
  std::vector<OffsetRegister> registers;     ///< of the tool table, changed by G10
  /// Wears that the program sets where no register holds the radius: the tool's own stands.
  std::map<std::string, double> bare_wears;
  SetLengths lengths;
  std::size_t cuts = 0;                       ///< lines and arcs that were given on
  std::map<long, double> told_noses;          ///< mm, by the number of a lathe's offset
  std::map<std::string, double> kept_values;  ///< SINUMERIK's markers and outputs: $AC_MARKER[1]
  int register_changes = 0;                   ///< how often the program has set one
  bool skips_data = false;      ///< blocks up to G11 set what is not read: lives, parameters
  bool paused = false;          ///< M0, or a tool changed by hand, and no motion since
  bool untilted_plane = false;  ///< G68.2 without a tilt is in force
  int unread_end = 0;  ///< a refused mode is in force: the word that ends it, see UnreadModes

  /// One name for the offsets that have several, without blanks: G154 P1 and G110 of Haas are
  /// G54.1 P1.
  std::string offset_name(std::string_view written) const;
  /// The register of that name, made where there is none; it counts as changed.
  OffsetRegister& change_register(const std::string& name);
  /// Its wear, which makes no register of that name.
  double& change_wear(const std::string& name);
  double bare_wear(const std::string& name) const;

  /// Copies of the state before this block, made by the parts that change it.
  std::optional<Frames> saved_frames;
  std::optional<ToolState> saved_tool;
};

bool is_circular(Code c);
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
  /// mm of a length of 1 and of a feed of 1.
  double scale() const { return modal_.inch ? 25.4 : 1.0; }
  double feed_scale() const { return modal_.inch_feed ? 25.4 : 1.0; }
  Code current_motion() const {
    return block_.motion != Code::unknown ? block_.motion : modal_.motion;
  }
  /// The axes of the plane in force.
  Basis basis() const {
    return modal_.plane == 3 ? normal_basis(modal_.normal) : plane_basis(modal_.plane);
  }
  /// These axes in the stock's coordinates, unit length; left-handed under a mirror.
  Basis stock_basis() const;
  /// mm of a length of 1 in `word`.
  double length_unit(const Word& word) const;
  /// What the word says in degrees.
  double angle_value(const Word& word) const;
  /// What the word says in mm; X of a lathe as a radius.
  double axis_value(int axis, const Word& word, bool incremental) const;

  /// Where the angle of a line stands: ANG= or ,A; on FANUC lathes A as well.
  Address angle_address() const {
    const bool plain = lathe() && is(Dialect::fanuc) && current_motion() == Code::line;
    return plain && !find(Address::ang) ? letter('A') : Address::ang;
  }

  /// A line that runs against its angle, A-30 for A150: FANUC reads the slope alone (warned of
  /// once).
  bool angle_of_slope(const Word& angle);

  const Word* find(Address a) const { return block_.find(a); }
  const Word* take(Address a) { return block_.take(a); }
  const Word* take(char c) { return block_.take(letter(c)); }
  const Word* peek(char c) const { return block_.find(letter(c)); }
  std::string text_of(const Word& word) const { return block_.text_of(word); }

  /// mm per revolution of the block's F, or of E where a FANUC lathe has it instead.
  std::optional<double> thread_lead();

  /// After the contour of a cycle was read: makes the block of the cycle the current one again.
  void put_back_block(const BlockPlace& place) {
    block_.put_back(place);
    reporter_.set_place(place.file, place.line, place.call, {});
  }
  /// False, and reported: the block calls or ends the program, too, behind a cycle with a contour.
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
