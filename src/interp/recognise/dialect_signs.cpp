#include "interp/recognise/dialect_signs.h"

#include "interp/language/bracket_statement.h"
#include "interp/text/characters.h"

#include <algorithm>
#include <initializer_list>

#include <fmt/format.h>

namespace mrsim {
namespace {

using Phrases = std::initializer_list<std::string_view>;

bool has_any_word(std::string_view c, Phrases words) {
  return std::any_of(words.begin(), words.end(),
                     [&](std::string_view word) { return has_word(c, word); });
}

std::size_t count_numbers(std::string_view c) {
  std::size_t n = 0;
  for (std::size_t i = 0; i + 1 < c.size(); ++i)
    if (c[i] == 'N' && is_digit(c[i + 1]) && (i == 0 || !is_name(c[i - 1]))) ++n;
  return n;
}

// Whether it is an O word of LinuxCNC: "O100 SUB", "O<POCKET> CALL [1]", "N10 O5 ENDIF".
bool is_o_word(std::string_view c) {
  std::size_t i = c.find_first_not_of(" \t");
  if (i != c.npos && c[i] == 'N') i = c.find_first_not_of("0123456789 ", i + 1);
  if (i == c.npos || c[i] != 'O' || i + 1 >= c.size()) return false;
  std::size_t end = i + 1;
  if (c[end] == '<') {
    end = c.find('>', end);
    if (end == c.npos) return false;
    ++end;
  } else {
    while (end < c.size() && (is_digit(c[end]) || c[end] == '#')) ++end;
    if (end == i + 1) return false;
  }
  const std::size_t at = c.find_first_not_of(" \t", end);
  if (at == c.npos) return false;
  const std::string_view rest = c.substr(at);
  for (const std::string_view word :
       {"SUB", "ENDSUB", "CALL", "RETURN", "IF", "ELSE", "ENDIF", "WHILE", "ENDWHILE", "DO",
        "REPEAT", "ENDREPEAT", "BREAK", "CONTINUE"})
    if (rest.starts_with(word)) return true;
  return false;
}

// Whether it is the header of a program of Fagor's 8055: "%PART,MX,".
bool is_fagor_header(std::string_view raw) {
  if (raw.size() < 4 || raw[0] != '%') return false;
  const std::size_t name = raw.find(','), end = raw.find(',', name + 1);
  if (name == raw.npos || end == raw.npos || end == name + 1) return false;
  return raw.substr(name + 1, end - name - 1).find_first_not_of("OMXHEV") == raw.npos;
}

// Whether an expression in brackets stands behind a letter, which SINUMERIK does not have:
// "X[#1+2]".
bool has_bracket_value(std::string_view c) {
  for (std::size_t i = 0; i + 1 < c.size(); ++i)
    if (c[i + 1] == '[' && std::string_view("XYZIJKUVWF").find(c[i]) != c.npos &&
        (i == 0 || !is_name(c[i - 1])))
      return true;
  return false;
}

bool has_any_axis(std::string_view c, std::string_view axes) {
  return std::any_of(axes.begin(), axes.end(), [&](char axis) { return has_axis(c, axis); });
}

// Whether D is a length, "D3.5": registers have whole numbers.
bool has_broken_d(std::string_view c) {
  for (std::size_t i = c.find('D'); i != c.npos; i = c.find('D', i + 1)) {
    const std::size_t end = c.find_first_not_of("0123456789", i + 1);
    if ((i == 0 || !is_letter(c[i - 1])) && end != c.npos && end > i + 1 && c[end] == '.')
      return end + 1 < c.size() && is_digit(c[end + 1]);
  }
  return false;
}

// Whether G20 is a jump of CODESYS, "G20 L20 K$A$", and not the unit.
bool is_codesys_jump(std::string_view c) {
  return has_word(c, "G20") && c.find('L') != c.npos && !has_any_axis(c, "XYZFST");
}

// Whether there are words for tools, the spindle, lengths, drilling cycles or feeds, which the
// decoder of a PLC does not have.
bool speaks_of_tools(std::string_view c, bool center) {
  if (has_any_word(c, {"M6", "M06", "G43", "G49", "G80", "G28", "G94", "G95"})) return true;
  if (has_axis(c, 'S') && has_any_word(c, {"M3", "M03", "M4", "M04"})) return true;
  return has_axis(c, 'T') && !center;
}

// Whether a variable of Okuma's OSP is set: "VC1=0", "N10 VC12 = VC1+2".
bool sets_common_variable(std::string_view c) {
  std::size_t i = c.find("VC");
  if (i == c.npos || (i > 0 && is_name(c[i - 1])) || !is_digit(c[std::min(i + 2, c.size() - 1)]))
    return false;
  i = c.find_first_not_of("0123456789", i + 2);
  if (i != c.npos) i = c.find_first_not_of(' ', i);
  return i != c.npos && c[i] == '=';
}

}  // namespace

void DialectSigns::add(Dialect dialect, int points, std::string_view sign, int line) {
  Entry& e = entries_[slot(dialect)];
  if (std::find(e.signs.begin(), e.signs.end(), sign) != e.signs.end()) return;
  e.signs.emplace_back(sign);
  e.points += points;
  if (points <= e.strongest) return;
  e.strongest = points;
  e.reason = line > 0 ? fmt::format("{} in line {}", sign, line) : std::string(sign);
}

Dialect DialectSigns::best() const {
  Dialect winner = Dialect::iso;
  for (const Dialect d : {Dialect::sinumerik, Dialect::fanuc, Dialect::codesys, Dialect::ngc})
    if (points(d) > points(winner)) winner = d;
  return winner;
}

// Files of many controls end in ".CNC", so the ending decides nothing where the text has words for
// tools.
int DialectSigns::points(Dialect d) const {
  const Entry& entry = entries_[slot(d)];
  const bool name_alone = entry.signs.size() == 1 && cnc_name_;
  return d == Dialect::codesys && name_alone && tools_ ? 0 : entry.points;
}

bool DialectSigns::certain() const {
  const Dialect d = best();
  if (d == Dialect::sinumerik && !moved_) return false;
  for (const Dialect o :
       {Dialect::sinumerik, Dialect::fanuc, Dialect::codesys, Dialect::iso, Dialect::ngc})
    if (o != d && points(d) < points(o) + 20) return false;
  return true;
}

void DialectSigns::name(const std::string& path) {
  const std::size_t dot = path.find_last_of('.');
  if (dot == std::string::npos) return;
  const std::string extension = upper_case(path.substr(dot));
  const auto sign = fmt::format("the file name ends in {}", extension);
  if (extension == ".MPF" || extension == ".SPF") add(Dialect::sinumerik, 12, sign, 0);
  cnc_name_ = extension == ".CNC";
  if (cnc_name_) add(Dialect::codesys, 2, sign, 0);
  if (extension == ".NGC") add(Dialect::ngc, 12, sign, 0);
  if (extension == ".TAP" || extension == ".GCODE") add(Dialect::ngc, 3, sign, 0);
  if (extension == ".PIM" || extension == ".PIT") add(Dialect::iso, 8, sign, 0);  // Fagor
  if (extension == ".MIN" || extension == ".EIA") add(Dialect::fanuc, 4, sign, 0);
}

void DialectSigns::line(const LineScan& scan, std::string_view raw, int number) {
  o_word_ = is_o_word(scan.code);
  weigh_sinumerik(scan, number);
  weigh_fanuc(scan, raw, number);
  weigh_codesys(scan, number);
  weigh_ngc(scan, raw, number);
  weigh_iso(scan, raw, number);
  if (!scan.comment.empty()) weigh_comment(scan, number);
}

// Whether R with a number is a radius, "G3 X30 R10". On SINUMERIK R10 is a variable: "R10=5", or in
// a value.
bool has_radius_word(const std::string& c) {
  for (std::size_t i = c.find('R'); i != c.npos; i = c.find('R', i + 1)) {
    if (i > 0 && c[i - 1] != ' ' && !is_digit(c[i - 1]) && c[i - 1] != '.') continue;
    if (i + 1 >= c.size() || !starts_number(c[i + 1])) continue;
    const std::size_t end = c.find_first_not_of("0123456789.+- ", i + 1);
    if (end == c.npos || is_letter(c[end])) return true;
  }
  return false;
}

void DialectSigns::weigh_sinumerik(const LineScan& s, int line) {
  constexpr auto d = Dialect::sinumerik;
  static constexpr std::string_view kSure[] = {
      "CR=",    "LIMS=",      "TRANS ", "ATRANS",  "AROT",   "CIP ",    "TURN=",  "I1=",  "DIAMON",
      "DIAMOF", "DIAM90",     "MSG(",   "AR=",     "RP=",    "RND=",    "CHF=",   "CHR=", "ANG=",
      "RNDM=",  "WORKPIECE(", "SUPA",   "AMIRROR", "ASCALE", "MIRROR ", "SCALE ", "ROT ", "G500",
      "GOTOF",  "GOTOB",      "CYCLE8", "T=\"",    "MCALL",  "TRAORI",  "EXTCALL"};
  static constexpr std::string_view kInside[] = {"=AC(", "=IC(", "%_N_"};
  for (const std::string_view sign : kSure)
    if (has(s.code, sign)) add(d, 10, sign, line);
  for (const std::string_view sign : kInside)
    if (s.code.find(sign) != std::string::npos) add(d, 10, sign, line);
  if (!o_word_ && has(s.code, "ENDIF")) add(d, 10, "ENDIF", line);
  if (has_any_word(s.code, {"G2", "G3", "G02", "G03"}) && has_radius_word(s.code))
    weigh_radius(line);
  const std::size_t equal = s.code.find('=');
  if (equal != std::string::npos && equal > 0 && is_name(s.code[equal - 1]) &&
      s.code.find('#') > equal)
    add(d, 4, "an assignment with =", line);
  if (s.comment_kind == ';' && !s.code.empty()) add(d, 3, "a comment after ;", line);
  if (s.comment_kind == ';' && s.code.empty()) add(d, 2, "a comment after ;", line);
  if (has_word(s.code, "M17")) add(d, 4, "M17", line);
  if (has_any_word(s.code, {"G4", "G04"}) && has_axis(s.code, 'F')) add(d, 4, "G4 F", line);
  if (has_any_word(s.code, {"G710", "G700"})) add(d, 8, "G710", line);
  if (has_any_word(s.code, {"G450", "G451"})) add(d, 8, "G450/G451", line);
  // A program that begins in ISO mode is FANUC's.
  if (!moved_ && has_word(s.code, "G291")) add(Dialect::fanuc, 60, "G291, the ISO mode", line);
  moved_ = moved_ || has_any_axis(s.code, "XYZ");
}

void DialectSigns::weigh_radius(int line) { add(Dialect::sinumerik, -10, "R as a radius", line); }

void DialectSigns::weigh_fanuc(const LineScan& s, std::string_view raw, int line) {
  constexpr auto d = Dialect::fanuc;
  const std::string& c = s.code;
  const std::size_t head = c.empty() || c[0] != 'N' ? 0 : c.find_first_not_of("0123456789 ", 1);
  const bool number = head < c.size() && head + 1 < c.size() && is_digit(c[head + 1]);
  const bool header = number && (c[head] == 'O' || (c[0] == ':' && names_program(c, 0)));
  if (header && !o_word_) add(d, 10, "a program number", line);
  if (raw.size() == 1 && raw[0] == '%') add(d, 3, "% alone", line);
  if (!bracketed_name(c, 0).empty()) add(d, 6, "the name of a program in < >", line);
  if (c.size() > 3 && c[0] == '$' && c.back() == '%') add(d, 10, "a program name of Okuma", line);
  if (s.ends_block) add(d, 3, "; as end of block", line);
  if (has_bracket_value(c)) add(d, 3, "an expression in [ ]", line);
  if (has(c, "M98")) add(d, 6, "M98", line);
  if (has_word(c, "M99")) add(d, 4, "M99", line);
  for (const std::string_view g : {"G43", "G49", "G28"})
    if (has_word(c, g)) add(d, 3, g, line);
  for (const std::string_view g :
       {"G54.1", "G68", "G69", "G51.1", "G50.1", "G187", "G154", "G43.4", "G68.2"})
    if (has_word(c, g)) add(d, 6, g, line);
  if (has_word(c, "G52") && has_any_axis(c, "XYZ")) add(d, 6, "G52", line);
  if (has_any_word(c, {"G12", "G13"}) && has_axis(c, 'I') && !has_any_axis(c, "ZDKL"))
    add(Dialect::iso, 12, "G12 or G13 of Mach", line);
  if (has_any_word(c, {"M97", "G65", "M198"}) && has_axis(c, 'P')) add(d, 8, "a call with P", line);
  if (has_any_word(c, {"G20", "G21"}) && !is_codesys_jump(c)) {
    add(d, 3, "G20/G21", line);
    add(Dialect::iso, 3, "G20/G21", line);
    add(Dialect::sinumerik, -6, "G20/G21", line);
  }
  if (s.comment_kind == ';') add(d, -6, "a comment after ;", line);
  if (has_word(c, "G16") && !has_axis(c, 'I') && !has_axis(c, 'J') && !has_axis(c, 'K'))
    add(d, 2, "G16 without a normal vector", line);
  if (c.find('#') != std::string::npos && c.find("#<") == std::string::npos && !o_word_ &&
      c.find('=') != std::string::npos && c.find(':') == std::string::npos)
    add(d, 6, "a # variable", line);
  const bool macro = has(c, "IF[") || has(c, "WHILE[") || has(c, "IF [") || has(c, "WHILE [");
  if (macro && !o_word_) add(d, 8, "a macro statement", line);
  for (std::size_t i = 1; i < c.size(); ++i)
    if (c[i] == 'G' && is_digit(c[i - 1])) add(d, 3, "G codes run together", line);
  weigh_fanuc_lathe(c, line);
  weigh_okuma(c, line);
}

bool names_okuma(const std::string& path) {
  const std::size_t dot = path.find_last_of('.');
  const std::string extension = dot == path.npos ? "" : upper_case(path.substr(dot));
  return extension == ".MIN" || extension == ".SSB";
}

bool is_okuma(const LineScan& s) {
  const std::string& c = s.code;
  const bool header = c.size() > 3 && c[0] == '$' && c.back() == '%';
  const bool named = c.starts_with("NAT") && c.size() > 3 && is_digit(c[3]);
  return header || named || calls_lap(c) || has(c, "CALL O") || sets_common_variable(c) ||
         has_whole_word(upper_case(s.comment), "OKUMA");
}

void DialectSigns::weigh_okuma(const std::string& c, int line) {
  constexpr auto d = Dialect::fanuc;
  if (has(c, "CALL O") || has(c, "MODIN O")) add(d, 12, "a call of Okuma's", line);
  if (sets_common_variable(c)) add(d, 12, "a variable of Okuma's", line);
  if (has_any_word(c, {"G15", "G56"}) && has_axis(c, 'H')) add(d, 8, "G15 H or G56 H", line);
}

void DialectSigns::weigh_fanuc_lathe(const std::string& c, int line) {
  constexpr auto d = Dialect::fanuc;
  const bool lathe_cycle =
      has_any_word(c, {"G70", "G71", "G72", "G73", "G76"}) && has_axis(c, 'P') && has_axis(c, 'Q');
  if (lathe_cycle) add(d, 8, "a turning cycle with P and Q", line);
  if (calls_lap(c)) add(d, 8, "a cycle of LAP", line);
  if (has_word(c, "G50") && has_axis(c, 'S')) add(d, 6, "G50 S", line);
  if (has_word(c, "G28") && (has_axis(c, 'U') || has_axis(c, 'W'))) add(d, 6, "G28 U W", line);
}

void DialectSigns::weigh_codesys(const LineScan& s, int line) {
  constexpr auto d = Dialect::codesys;
  const std::string& c = s.code;
  const bool named_arc = has_any_word(c, {"G2", "G3", "G02", "G03"});
  if (named_arc) arcs_ = true;
  if (has_any_word(c, {"G1", "G0", "G01", "G00"}) && count_numbers(c) < 2) arcs_ = false;
  const bool center = has_axis(c, 'I') || has_axis(c, 'J') || has_axis(c, 'K');
  tools_ = tools_ || speaks_of_tools(c, center);
  if (arcs_ && center && has_axis(c, 'T')) add(d, 12, "T as an opening angle", line);
  if (count_numbers(c) > 1) add(d, 6, "several N words in a line", line);
  if (has(c, "SUBPROGRAM") || has(c, "END_SUBPROGRAM")) add(d, 15, "SUBPROGRAM", line);
  if (c.find(": LREAL") != std::string::npos) add(d, 10, "LREAL", line);
  if (c.find('{') != std::string::npos) add(d, 6, "a call with { }", line);
  if (c.find('$') != std::string::npos && c.find("$P_") == std::string::npos &&
      std::count(c.begin(), c.end(), '$') > 1)
    add(d, 6, "a variable in $ $", line);
  if (has_word(c, "G16") && center) add(d, 10, "G16 with a normal vector", line);
  // FANUC's return level and feed mode also stand alone, but an arc does not follow them.
  const bool mode = has_any_word(c, {"G98", "G99"});
  if (named_arc && center && (mode || center_mode_ > 0))
    add(d, 5, "G98/G99 for the centre", mode ? line : center_mode_);
  if (!c.empty())
    center_mode_ = mode && c.find_first_not_of("0123456789NG ") == std::string::npos ? line : 0;
  for (const std::string_view feed : {"FF", "EF"}) {
    const std::size_t at = c.find(feed);
    if (has(c, feed) && at + 2 < c.size() && starts_number(c[at + 2])) add(d, 5, "FF/EF", line);
  }
  const std::size_t first = c.find(" E"),
                    second = first == std::string::npos ? first : c.find(" E", first + 2);
  if (second != std::string::npos && second + 2 < c.size() && starts_number(c[second + 2]))
    add(d, 8, "E twice", line);
  if (c.size() > 2 && c[0] == '%' && c[1] == ' ') add(d, 4, "a header with %", line);
  if (is_codesys_jump(c)) add(d, 10, "G20 L, a jump", line);
  const bool places = has_any_axis(c, "XYZIJKPR");
  if (has_any_word(c, {"G36", "G37"}) && has_axis(c, 'D') && !places)
    add(d, 10, "G36/G37 D, an assignment", line);
  if (has_any_word(c, {"G51", "G52"}) && !places) add(d, 8, "G51/G52 without axes", line);
  if (has_any_word(c, {"G41", "G42"}) && has_broken_d(c)) add(d, 5, "D as a radius", line);
}

void DialectSigns::weigh_ngc(const LineScan& s, std::string_view raw, int line) {
  constexpr auto d = Dialect::ngc;
  const std::string& c = s.code;
  if (o_word_) add(d, 15, "an O word with a name of LinuxCNC", line);
  if (c.find("#<") != std::string::npos) add(d, 15, "a named variable", line);
  if (has_bracket_value(c)) add(d, 3, "an expression in [ ]", line);
  if (c.find("**") != std::string::npos || has(c, "EXISTS["))
    add(d, 6, "an operator of LinuxCNC", line);
  for (const std::string_view g :
       {"G90.1", "G91.1", "G61.1", "G43.1", "G33.1", "G59.1", "G59.2", "G59.3", "G38.2", "G38.3",
        "G38.4", "G38.5", "G5.2", "G92.2", "G92.3", "G41.1", "G42.1"})
    if (has_word(c, g)) add(d, 6, g, line);
  if (has_word(c, "G64") && has_axis(c, 'P')) add(d, 6, "G64 P", line);
  if (c == "$H" || c == "$X") add(d, 6, "a command of Grbl", line);
  if (has_any_word(c, {"G7", "G8"}) && !has_axis(c, 'P')) add(d, 6, "G7/G8", line);
  if (has_word(c, "G10") &&
      (c.find("L20") != std::string::npos || c.find("L10") != std::string::npos ||
       c.find("L11") != std::string::npos))
    add(d, 2, "G10 L20", line);
  if (has_any_word(c, {"M62", "M63", "M64", "M65", "M66", "M67", "M68"}) &&
      (has_axis(c, 'P') || has_axis(c, 'E')))
    add(d, 4, "digital outputs", line);
  if (has_any_word(c, {"G20", "G21"}) && !is_codesys_jump(c)) add(d, 2, "G20/G21", line);
  for (const std::string_view g : {"G43", "G49", "G28"})
    if (has_word(c, g)) add(d, 2, g, line);
  if (raw.size() == 1 && raw[0] == '%') add(d, 2, "% alone", line);
  if (s.comment_kind == ';') add(d, 2, "a comment after ;", line);
  if (c.find('#') != std::string::npos && c.find('=') != std::string::npos)
    add(d, 5, "a # variable", line);
  const std::string head = upper_case(s.comment.substr(0, 10));
  if (s.comment_kind == '(')
    for (const std::string_view word : {"MSG,", "DEBUG,", "PRINT,", "PROBEOPEN", "LOG,", "LOGOPEN"})
      if (head.starts_with(word)) add(d, 6, "an active comment", line);
}

// A comment may name the post and the control.
void DialectSigns::weigh_comment(const LineScan& s, int line) {
  if (line > 60) return;
  const std::string comment = upper_case(s.comment.substr(0, 200));
  const auto weigh = [&](Dialect d, Phrases words) {
    for (const std::string_view word : words)
      if (has_whole_word(comment, word)) add(d, 8, fmt::format("\"{}\"", word), line);
  };
  weigh(Dialect::ngc,
        {"LINUXCNC",   "EMC",     "GRBL",      "MACH2",          "MACH3",          "MACH4",
         "MACH 3",     "MACH 4",  "ESTLCAM",   "CARBIDE CREATE", "CARBIDE MOTION", "CARBIDE3D",
         "CARBIDE 3D", "VECTRIC", "VCARVE",    "SHAPEOKO",       "EASEL",          "BCNC",
         "OPENBUILDS", "MAKERA",  "PATHPILOT", "TORMACH",        "CAMOTICS",       "SNAPMAKER",
         "KIRI",       "PYCAM",   "FLATCAM",   "GCODETOOLS",     "JSCUT"});
  weigh(Dialect::fanuc, {"FANUC", "HAAS", "MAZAK", "OKUMA", "DOOSAN", "FADAL"});
  weigh(Dialect::sinumerik, {"SINUMERIK", "SIEMENS"});
  weigh(Dialect::iso, {"PROLIGHT", "INTELITEK"});
  for (const std::string_view word : {"STOCKMIN:", "STOCK/BLOCK", "TOOL/MILL"})  // Carbide
    if (comment.find(word) != std::string::npos)
      add(Dialect::ngc, 8, fmt::format("\"{}\"", word), line);
  if (has_whole_word(comment, "FREECAD")) add(Dialect::ngc, 4, "\"FREECAD\"", line);
}

void DialectSigns::weigh_iso(const LineScan& s, std::string_view raw, int line) {
  for (const std::string_view sign : {"#HSC", "#MSG", "#SLOPE", "#RTCP", "#CS ", "#TLC"})
    if (s.code.find(sign) != std::string::npos)
      add(Dialect::iso, 12, "an instruction of Fagor's", line);
  const bool lower =
      std::any_of(raw.begin(), raw.end(), [](char c) { return c >= 'a' && c <= 'z'; });
  if (lower && s.comment.empty() && s.code.find('=') == std::string::npos && !o_word_)
    add(Dialect::iso, 1, "lower-case words", line);
  if (is_fagor_header(raw)) add(Dialect::iso, 15, "a program header of Fagor's", line);
  if (s.comment_kind == '(' && !bracket_statement(s.comment).empty())
    add(Dialect::iso, 10, "a statement in brackets", line);
}

}  // namespace mrsim
