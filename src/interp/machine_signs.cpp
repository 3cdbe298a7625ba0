#include "interp/machine_signs.h"

#include "interp/characters.h"
#include "interp/tool_comment.h"

#include <fmt/format.h>

namespace mrsim {
namespace {

void note_first(std::string& where, std::string_view what, int line) {
  if (where.empty()) where = fmt::format("{} in line {}", what, line);
}

// Words of FANUC that are a lathe's unless something moves in Y: increments U W, cycles of system
// A, the limit of the speed.
bool turning_words(const std::string& c) {
  const bool dwell = has_word(c, "G4") || has_word(c, "G04");
  if (!dwell && (has_axis(c, 'U') || has_axis(c, 'W'))) return true;
  if ((has_word(c, "G73") || has_word(c, "G76")) && has_axis(c, 'P') && has_axis(c, 'Q'))
    return true;
  if (has_word(c, "G50") && has_axis(c, 'S')) return true;
  return has_word(c, "G92") && has_axis(c, 'Z') && has_axis(c, 'F');
}

// T0101: station and offset, and no M6 beside it.
bool turret_word(const std::string& c) {
  for (std::size_t i = c.find('T'); i != std::string::npos; i = c.find('T', i + 1)) {
    if (i > 0 && (is_letter(c[i - 1]) || c[i - 1] == '_')) continue;
    std::size_t end = i + 1;
    while (end < c.size() && is_digit(c[end])) ++end;
    if (end - i != 5) continue;
    const std::string_view station(c.data() + i + 1, 2), offset(c.data() + i + 3, 2);
    if (station[0] == '0' || station == offset || offset == "00") return true;
  }
  return false;
}

}  // namespace

void MachineSigns::fanuc_line(const std::string& c, int n) {
  for (const std::string_view g : {"G70", "G71", "G72", "G75"})
    if (has_word(c, g)) note_first(lathe_, g, n);
  if (turning_words(c)) note_first(turning_, "a turning word", n);
  if (turret_word(c)) note_first(turret_, "a T word of station and offset", n);
  if (has_word(c, "M6") || has_word(c, "M06")) changes_ = true;
}

void MachineSigns::line(const LineScan& s, int n, Dialect dialect) {
  const std::string& c = s.code;
  if (c.find('G') != std::string::npos) {
    if (has_word(c, "G96") || has_word(c, "G961")) note_first(lathe_, "G96", n);
    if (has_word(c, "G18")) note_first(turning_, "G18", n);
  }
  if (dialect == Dialect::fanuc) fanuc_line(c, n);
  if (c.find("LIMS") != std::string::npos) note_first(lathe_, "LIMS", n);
  if (c.find("DIAM") != std::string::npos && (has_word(c, "DIAMON") || has(c, "DIAM90")))
    note_first(lathe_, "DIAMON", n);
  if (has(c, "CYCLE95") || has(c, "CYCLE951") || has(c, "CYCLE93") || has(c, "CYCLE97"))
    note_first(lathe_, "a turning cycle", n);
  const bool frame =
      c.find("TRANS") != std::string::npos || c.find("ROT ") != std::string::npos ||
      c.find("SCALE") != std::string::npos || c.find("WORKPIECE") != std::string::npos ||
      c.find("MSG(") != std::string::npos || has_word(c, "G58") || has_word(c, "G59");
  if (!frame && has_axis(c, 'Y')) note_first(mill_, "a motion with Y", n);
  if (!frame && has_axis(c, 'J')) note_first(mill_, "an arc with J", n);
  if (s.comment.empty()) return;
  const ToolHint hint = read_tool_comment(s.comment);
  if (!hint.type) return;
  note_first(is_turning(*hint.type) ? turning_tool_ : milling_tool_,
             fmt::format("\"{}\"", hint.text.substr(0, 60)), n);
}

void MachineSigns::judge(const InterpOptions& options, Recognition& out) const {
  if (out.dialect == Dialect::codesys) {
    out.machine = MachineKind::mill;
    out.machine_reason = "CODESYS has no diameters";
    return;
  }
  bool turning = false, milling = false;
  for (const Tool& tool : options.table.tools) (is_turning(tool.type) ? turning : milling) = true;
  const bool turret = out.dialect == Dialect::fanuc && !turret_.empty() && !changes_ &&
                      milling_tool_.empty() && !milling;
  if (!mill_.empty() && !lathe_.empty()) {
    out.machine_reason = fmt::format("{} speaks for a mill, {} for a lathe", mill_, lathe_);
  } else if (!lathe_.empty()) {
    out.machine = MachineKind::lathe;
    out.machine_reason = lathe_;
  } else if (!mill_.empty()) {
    out.machine = MachineKind::mill;
    out.machine_reason = mill_;
  } else if (!turning_.empty() || !turning_tool_.empty() || turret || (turning && !milling)) {
    out.machine = MachineKind::lathe;
    const std::string why = !turning_.empty()        ? turning_
                            : !turning_tool_.empty() ? "turning tool " + turning_tool_
                            : turret                 ? turret_
                                                     : "a turning tool in the tool table";
    out.machine_reason = why + ", and no motion with Y";
  } else if (!milling_tool_.empty() || (milling && !turning)) {
    out.machine = MachineKind::mill;
    out.machine_reason = milling_tool_.empty() ? "a milling tool in the tool table"
                                               : "milling tool " + milling_tool_;
  } else {
    out.machine_reason = "no Y motion, G96, LIMS, DIAMON or G18, no known tool";
  }
}

}  // namespace mrsim
