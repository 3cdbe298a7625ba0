#include "interp/recognise/machine_signs.h"

#include "interp/comments/tool_comment.h"
#include "interp/text/characters.h"

#include <fmt/format.h>

namespace mrsim {
namespace {

void note_first(std::string& where, std::string_view what, int line) {
  if (where.empty()) where = fmt::format("{} in line {}", what, line);
}

bool moves(const std::string& c) {
  for (const std::string_view g : {"G0", "G00", "G1", "G01", "G2", "G02", "G3", "G03"})
    if (has_word(c, g)) return true;
  return false;
}

// Whether there are words of FANUC that mean a lathe unless something moves in Y: increments U W,
// cycles of system A, the limit of the speed.
bool turning_words(const std::string& c) {
  const bool dwell = has_word(c, "G4") || has_word(c, "G04");
  if (!dwell && (has_axis(c, 'U') || has_axis(c, 'W'))) return true;
  if ((has_word(c, "G73") || has_word(c, "G76")) && has_axis(c, 'P') && has_axis(c, 'Q'))
    return true;
  if (has_word(c, "G50") && has_axis(c, 'S')) return true;
  if (has_word(c, "G94") && !moves(c) && has_axis(c, 'X') && has_axis(c, 'Z')) return true;
  return has_word(c, "G92") && has_axis(c, 'Z') && has_axis(c, 'F');
}

// G70 to G75 of a lathe have their own words. Without words, G70 and G71 are the units of Mach and
// Vectric. G74 of a mill taps, but not with only an R.
bool turning_cycle(const std::string& c, std::string_view g) {
  if (!has_word(c, g)) return false;
  if (g == "G74") return has_axis(c, 'R') && c.find_first_of("XYZF") == c.npos;
  if (has_axis(c, 'P') && has_axis(c, 'Q')) return true;
  const bool increments = has_axis(c, 'U') || has_axis(c, 'W') || has_axis(c, 'D');
  return g != "G70" && (increments || g == "G75") && has_axis(c, 'R');
}

// Whether T names station and offset, T0101 or T010101 of Okuma, without an M6 beside it.
bool turret_word(const std::string& c) {
  for (std::size_t i = c.find('T'); i != std::string::npos; i = c.find('T', i + 1)) {
    if (i > 0 && (is_letter(c[i - 1]) || c[i - 1] == '_')) continue;
    std::size_t end = i + 1;
    while (end < c.size() && is_digit(c[end])) ++end;
    if (end - i != 5 && end - i != 7) continue;
    const std::string_view station(c.data() + i + 1, 2), offset(c.data() + i + 3, 2);
    if (end - i == 7) {
      if (station == offset && offset == std::string_view(c.data() + i + 5, 2)) return true;
      continue;
    }
    if (station[0] == '0' || station == offset || offset == "00") return true;
  }
  return false;
}

// T101 of Haas' lathes is station and offset. Without other signs it may be a tool of that number.
bool short_turret_word(const std::string& c) {
  for (char n = '1'; n <= '9'; ++n)
    if (has_word(c, std::string({'T', n, '0', n}))) return true;
  return false;
}

// SINUMERIK's milling cycles. Live tools of a lathe also run them, beside turning words.
bool milling_cycle(const std::string& c) {
  for (const char* cycle :
       {"POCKET1", "POCKET2", "POCKET3", "POCKET4", "SLOT1",   "SLOT2",    "LONGHOLE",
        "CYCLE60", "CYCLE61", "CYCLE63", "CYCLE64", "CYCLE70", "CYCLE71",  "CYCLE72",
        "CYCLE76", "CYCLE77", "CYCLE78", "CYCLE79", "CYCLE90", "CYCLE899", "CYCLE832"})
    if (has_word(c, cycle)) return true;
  return false;
}

// Whether J is a word of a lathe: the number of a thread's starts (G86, G87 of Fagor), the run-out
// of a thread (G92 of GSK), a choice of its cycles (G71 P Q J K); or an argument of a macro.
bool turns_with_j(const std::string& c) {
  if (has_word(c, "G65") || has_word(c, "G66")) return true;
  if (has_word(c, "G92") && has_axis(c, 'Z')) return has_axis(c, 'F') || has_axis(c, 'I');
  for (const std::string_view g : {"G70", "G71", "G72", "G73"})
    if (turning_cycle(c, g)) return true;
  return (has_word(c, "G86") || has_word(c, "G87")) && has_axis(c, 'Q') && has_axis(c, 'B');
}

// Drills and taps also stand in the turrets of lathes, so they prove nothing.
bool drills(const ToolHint& hint) {
  return hint.type == ToolType::drill || hint.trade == ToolTrade::tap ||
         hint.trade == ToolTrade::hole;
}

// Whether each Y is a number that is 0.
bool stays_at_y0(std::string_view c) {
  for (std::size_t i = c.find('Y'); i != c.npos; i = c.find('Y', i + 1)) {
    if (i > 0 && is_letter(c[i - 1])) continue;
    const std::size_t number = c.find_first_not_of(" +-", i + 1);
    if (number == c.npos || (c[number] != '0' && c[number] != '.')) return false;
    const std::size_t end = c.find_first_not_of("0.", number);
    if (end != c.npos && (is_digit(c[end]) || c[end] == '[' || c[end] == '#')) return false;
  }
  return true;
}

// Whether Y or J is no motion: it belongs to a frame, to data, or to a thread of LinuxCNC.
bool sets_data(const std::string& c) {
  for (const std::string_view word : {"TRANS", "ROT ", "SCALE", "MIRROR", "WORKPIECE", "MSG("})
    if (c.find(word) != std::string::npos) return true;
  for (const std::string_view g : {"G58", "G59", "G10", "G76"})
    if (has_word(c, g)) return true;
  return false;
}

}  // namespace

void MachineSigns::fanuc_line(const std::string& c, int n) {
  for (const std::string_view g : {"G70", "G71", "G72", "G74", "G75"})
    if (turning_cycle(c, g)) note_first(fanuc_lathe_, g, n);
  if (calls_lap(c)) note_first(fanuc_lathe_, "a cycle of LAP", n);
  if (turning_words(c)) note_first(fanuc_turning_, "a turning word", n);
  if (has_axis(c, 'C')) note_first(rotary_, "C", n);
  if (turret_word(c)) note_first(turret_, "a T word of station and offset", n);
  if (short_turret_word(c)) note_first(short_turret_, "a T word of station and offset", n);
}

void MachineSigns::weak_signs(const std::string& c, int n) {
  if (has_word(c, "M6") || has_word(c, "M06")) note_first(change_, "M6", n);
  if (c.find('G') == std::string::npos) return;
  if (has_word(c, "G43")) note_first(length_, "G43", n);
  if (has_word(c, "G17")) note_first(plane_, "G17", n);
  if (has_word(c, "G95")) note_first(per_revolution_, "G95", n);
  if (has_word(c, "G18")) note_first(turning_, "G18", n);
  turns_ = turns_ || has_word(c, "G97");
  if (has_word(c, "G96") || has_word(c, "G961")) note_first(lathe_, "G96", n);
  const bool alone = (has_word(c, "G7") || has_word(c, "G8")) && !has_axis(c, 'P');
  if (alone) note_first(ngc_lathe_, "G7 or G8", n);
}

// Y of polar and cylindrical interpolation on a lathe is no axis of the machine.
bool MachineSigns::is_transformed(const std::string& c) {
  if (has_word(c, "TRANSMIT") || has_word(c, "TRACYL") || has_word(c, "G12.1") ||
      has_word(c, "G112") || has_word(c, "G107") || has_word(c, "G7.1"))
    transformed_ = !has(c, "C0");
  if (has_word(c, "TRAFOOF") || has_word(c, "G13.1") || has_word(c, "G113")) transformed_ = false;
  return transformed_;
}

void MachineSigns::line(const LineScan& s, int n) {
  const std::string& c = s.code;
  weak_signs(c, n);
  fanuc_line(c, n);
  if (has(c, "LIMS")) note_first(lathe_, "LIMS", n);
  if (c.find("DIAM") != std::string::npos && (has_word(c, "DIAMON") || has(c, "DIAM90")))
    note_first(lathe_, "DIAMON", n);
  for (const char* cycle : {"CYCLE93", "CYCLE930", "CYCLE94", "CYCLE940", "CYCLE95", "CYCLE951",
                            "CYCLE952", "CYCLE96", "CYCLE97", "CYCLE98", "CYCLE99"})
    if (has_word(c, cycle)) note_first(lathe_, "a turning cycle", n);
  if (milling_cycle(c)) note_first(milling_cycle_, "a milling cycle", n);
  const bool data = is_transformed(c) || sets_data(c);
  if (!data && has_axis(c, 'Y') && mill_.empty())
    note_first(stays_at_y0(c) ? level_ : mill_, "a motion with Y", n);
  if (!data && has_axis(c, 'J') && !turns_with_j(c)) note_first(mill_, "an arc with J", n);
  if (s.comment.empty()) return;
  const ToolHint hint = read_tool_comment(s.comment);
  if (!hint.type) return;
  note_first(is_turning(*hint.type) ? turning_tool_ : milling_tool_,
             fmt::format("\"{}\"", hint.text.substr(0, 60)), n);
  if (!is_turning(*hint.type) && !drills(hint)) mills_ = true;
}

// Why it is a mill although nothing moves in Y; empty: no sign says so.
std::string MachineSigns::weak_mill(bool tool_in_table, bool commented) const {
  if (tool_in_table) return "a milling tool in the tool table";
  if (!milling_cycle_.empty()) return milling_cycle_;
  const std::string& own = !length_.empty() ? length_ : !change_.empty() ? change_ : plane_;
  if (own.empty()) return "";
  if (commented) return fmt::format("milling tool {}, and {}", milling_tool_, own);
  const bool two = !length_.empty() && (!change_.empty() || !plane_.empty());
  return two ? fmt::format("{} and {}", length_, !change_.empty() ? change_ : plane_) : "";
}

// T0101 of FANUC's lathes, empty where it may be a mill's. A milling tool in a turret is a live
// tool if there are turning tools or an axis C.
std::string MachineSigns::turret() const {
  const bool live = !turning_tool_.empty() || !rotary_.empty();
  if (!change_.empty() || !(milling_tool_.empty() || live || (turns_ && !mills_))) return "";
  return turret_.empty() && !turning_tool_.empty() ? short_turret_ : turret_;
}

// Why it is a lathe if nothing moves in Y; empty: no sign says so. `table`: the tool table has
// turning tools alone.
std::string MachineSigns::weak_lathe(bool fanuc, const std::string& turret_sign, bool table) const {
  if (fanuc && !fanuc_turning_.empty()) return fanuc_turning_;
  if (!turning_.empty()) return turning_;
  if (!turret_sign.empty()) return turret_sign;
  if (milling_tool_.empty() && !turning_tool_.empty() && !per_revolution_.empty())
    return fmt::format("turning tool {}, {}", turning_tool_, per_revolution_);
  return table ? "a turning tool in the tool table" : "";
}

void MachineSigns::judge(const InterpOptions& options, Recognition& out) const {
  if (out.dialect == Dialect::codesys) {
    out.machine = MachineKind::mill;
    out.machine_reason = "CODESYS has no diameters";
    return;
  }
  bool turning = false, milling = false;
  for (const Tool& tool : options.table.tools) (is_turning(tool.type) ? turning : milling) = true;
  const bool fanuc = out.dialect == Dialect::fanuc;
  const bool ngc = out.dialect == Dialect::ngc;  // X is a radius on LinuxCNC until G7
  const std::string& own = ngc ? ngc_lathe_ : fanuc ? fanuc_lathe_ : lathe_;
  const std::string& lathe = lathe_.empty() || (ngc && !own.empty()) ? own : lathe_;
  const std::string turret_sign = fanuc && !milling ? turret() : "";
  const std::string weak = weak_lathe(fanuc, turret_sign, turning && !milling);
  const std::string mill = weak_mill(milling && !turning, !milling_tool_.empty());
  const bool sure = !lathe.empty() && !(ngc && lathe.starts_with("G96"));
  const std::string& across = mill_.empty() && !sure ? level_ : mill_;
  const std::string against = sure ? lathe : mill_.empty() ? turret_sign : "";
  if (!across.empty() && !against.empty()) {
    out.machine_reason = fmt::format("{} speaks for a mill, {} for a lathe", across, against);
  } else if (!across.empty()) {
    out.machine = MachineKind::mill;
    out.machine_reason = level_.empty() ? across : level_;
  } else if (!lathe.empty()) {
    out.machine = MachineKind::lathe;
    out.machine_reason = lathe;
  } else if (!weak.empty()) {
    out.machine = MachineKind::lathe;
    out.machine_reason = weak + ", and no motion with Y";
  } else if (!mill.empty()) {
    out.machine = MachineKind::mill;
    out.machine_reason = mill;
  } else if (ngc) {
    out.machine = MachineKind::mill;
    out.machine_reason = "LinuxCNC reads X as a length until G7";
  } else {
    const std::string& comment = milling_tool_.empty() ? turning_tool_ : milling_tool_;
    out.machine_reason = "no Y motion, G96, LIMS, DIAMON or G18, no known tool";
    if (!comment.empty()) out.machine_reason += fmt::format("; only the comment {}", comment);
  }
}

}  // namespace mrsim
