#include "interp/recognise/foreign_programs.h"

#include "core/text/text_io.h"
#include "interp/text/characters.h"
#include <mrsim/types.h>

#include <algorithm>
#include <initializer_list>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr int kHeadLines = 400;  // conversational programs name their control early
constexpr int kTitleLines = 30;  // where comments name the machine

bool ends_with(const std::string& path, std::initializer_list<std::string_view> extensions) {
  const std::size_t dot = path.find_last_of('.');
  const std::string extension = dot == path.npos ? "" : upper_case(path.substr(dot));
  return std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
}

// The text of a block without its number.
std::string_view body(std::string_view code) {
  std::size_t i = code.find_first_not_of(" \t0123456789");
  return i == code.npos ? std::string_view() : code.substr(i);
}

bool any_of(std::string_view text, std::initializer_list<std::string_view> signs) {
  return std::any_of(signs.begin(), signs.end(),
                     [&](std::string_view sign) { return text.find(sign) != text.npos; });
}

bool begins_any(std::string_view text, std::initializer_list<std::string_view> heads) {
  return std::any_of(heads.begin(), heads.end(),
                     [&](std::string_view head) { return text.starts_with(head); });
}

// Cycles of Fagor's lathe control 8055 T: G66, G68 and G69 X Z C S E cut along blocks S to E; G81
// and G82 have X Z Q R C.
bool fagor_turning(std::string_view code) {
  const std::string line(code);
  const auto all = [&](std::string_view letters) {
    return std::all_of(letters.begin(), letters.end(), [&](char c) { return has_axis(line, c); });
  };
  if (has_word(line, "G66") || has_word(line, "G68") || has_word(line, "G69")) return all("XZCSE");
  return (has_word(line, "G81") || has_word(line, "G82")) && all("XZQRC");
}

// The format of a file for drills, plotters and routers that has no G code; or null.
const char* named_format(const std::string& path, std::string_view raw) {
  const std::string text = upper_case(raw.substr(0, 64));
  const std::string_view line(text.data(), text.find_last_not_of(" \t\r") + 1);
  if (begins_any(line, {"%FSLA", "%FSTA", "%MOMM*", "%MOIN*"})) return "a Gerber file";
  if (ends_with(path, {".SBP"}) || begins_any(line, {"JZ,", "MZ,", "J2,", "M2,", "J3,", "M3,"}))
    return "a ShopBot program";
  if (begins_any(line, {"IN;", "PU;", "PD;", "SP1;", ";:H A"})) return "a plotter's file (HPGL)";
  if (any_of(line, {";;^IN;", "!MC1", "!MC0", "!PZ", "!VZ"})) return "a Roland program (RML)";
  if (begins_any(line, {"IMF_PBL", "FASTABS ", "MOVEABS "})) return "an isel program (NCP)";
  const bool is_wood = line == "[H" || begins_any(line, {"H DX=", "BEGIN MAINDATA"}) ||
                       any_of(line, {"\\WERKSTCK\\", "BEGIN ID CID3"});
  return is_wood ? "a woodworking program (woodWOP, bSolid, Xilog)" : nullptr;
}

// Whether the block ends in "*". Brackets may stand behind the code.
bool ends_in_star(std::string_view code, std::string_view raw) {
  const std::size_t last = raw.find_last_not_of(" \t\r");
  const std::string_view whole = code.substr(0, code.find_last_not_of(" \t\r") + 1);
  return last != raw.npos && raw[last] == '*' && whole.size() > 1 && whole.back() == '*' &&
         (whole[0] == '%' || whole[0] == 'N');
}

// The control that this line alone proves, or null.
const char* named_control(const std::string& path, std::string_view code, std::string_view raw) {
  const std::string_view text = body(code);
  if (begins_any(text, {"BEGIN PGM ", "TOOL CALL ", "TOOL DEF ", "CYCL DEF ", "BLK FORM "}))
    return "a Heidenhain conversational program";
  const std::string_view whole = code.substr(0, code.find_last_not_of(" \t\r") + 1);
  if (any_of(code, {" E_HEAD("}) || text.starts_with("E_HEAD("))
    return "a ShopMill program (steps of work)";
  if (any_of(code, {" F_HEAD("}) || text.starts_with("F_HEAD("))
    return "a ShopTurn program (steps of work)";
  if (begins_any(text, {"PROGRAMMKOPF", "PROGRAM HEAD", "ROHTEIL", "FERTIGTEIL", "BEARBEITUNG"}))
    return "a DIN PLUS program of Heidenhain's CNC PILOT";
  if (begins_any(text, {"UNO.", "UNO ", "UNIT MAT"}) ||
      any_of(code, {"MAZATROL", "INITIAL-Z", "ATC MODE"}) ||
      ends_with(path, {".PBG", ".PBD", ".MAZ"}))
    return "a Mazatrol program";
  if (ends_with(path, {".IGF"}) || text == "IGF" || text.starts_with("IGF "))
    return "an Okuma IGF program";
  if (fagor_turning(code)) return "a Fagor lathe's program with turning cycles";
  if (whole.size() == 2 && whole[0] == '$' && is_digit(whole[1]))
    return "a program of several paths ($1, $2), as of Swiss-type lathes (Citizen, Star)";
  if (begins_any(text, {"WHILE [", "WHILE["}) && !any_of(code, {"DO"}))
    return "a program of Eding CNC (WHILE without DO)";
  if (begins_any(text, {"$IF ", "$FOR ", "$WHILE ", "#VAR", "V.P.", "V.S."}))
    return "a program of Fagor's 8070 with its own statements ($IF, #VAR, V.P.)";
  if (whole.size() > 4 && whole.starts_with("%PM") && is_digit(whole[3]))
    return "a program of Philips' and MAHO's controls (%PM)";
  if (any_of(raw, {"@MACRO"})) return "a Syntec macro";
  if (ends_with(path, {".SIMPL"})) return "a DATRON SimPL program";
  if (begins_any(text, {"LOADTL/", "GOTO/", "FROM/", "PARTNO/", "FEDRAT/"}))
    return "an APT cutter location file";
  return named_format(path, raw);
}

}  // namespace

void ForeignPrograms::refuse(const std::string& what, int number, std::string_view raw) const {
  Diagnostic diagnostic;
  diagnostic.code = "control-unsupported";
  diagnostic.text = fmt::format(
      "this is {}, which mrsim does not read: post the program for SINUMERIK, FANUC, LinuxCNC, ISO "
      "or CODESYS (or say --dialect, if it is one of them)",
      what);
  diagnostic.place = {path_, number, 1};
  diagnostic.source_line = to_utf8(raw.substr(0, 200));
  throw PlacedError(diagnostic);
}

void ForeignPrograms::weigh_printer(const std::string& code, int number, std::string_view raw) {
  for (const std::string_view word : {"M104", "M109", "M140", "M190"})
    if (has_word(code, word)) heats_ = true;
  const bool moves = has_word(code, "G1") || has_word(code, "G0") || has_word(code, "G92");
  if (moves && has_axis(code, 'E')) extrudes_ = true;
  if (heats_ && extrudes_)
    refuse("the program of a 3-D printer (it heats and extrudes)", number, raw);
}

// S of M300 is the place of a pen's servo. But M300 is a tone where it has a length P, or where a
// spindle turns.
void ForeignPrograms::weigh_plotter(const std::string& code, int number, std::string_view raw) {
  for (const std::string_view word : {"M3", "M03", "M4", "M04"})
    if (has_word(code, word)) turns_spindle_ = true;
  if (code.find('Z') != std::string::npos) has_z_ = true;
  if (!has_word(code, "M300") || !has_axis(code, 'S') || has_axis(code, 'P')) return;
  if (++pen_moves_ != 2) return;
  pen_line_ = number;
  pen_text_ = raw;
}

// NUM: G77 calls and G79 jumps to N words; the head is "%12"; G52 beside a motion is a place in
// machine coordinates.
void ForeignPrograms::weigh_num(const std::string& code, int number, std::string_view raw) {
  const std::size_t last = code.find_last_not_of(" \t\r");
  if (code.size() > 1 && code[0] == '%' && code.find_first_not_of("0123456789", 1) > last)
    numbered_ = true;
  const bool moves = has_word(code, "G0") || has_word(code, "G00") || has_word(code, "G1");
  if (any_of(code, {"G77 N", "G77N", "G79 N", "G79N"}) ||
      (numbered_ && moves && has_word(code, "G52")))
    refuse("a program of NUM's control", number, raw);
}

// Huazhong's HNC: the head is "%12"; G80, G81 and G82 X Z F are cycles of turning, facing and
// threading; G71 to G73 have contour and allowances in one block.
void ForeignPrograms::weigh_hnc(const std::string& code, int number, std::string_view raw) {
  const auto any = [&](std::initializer_list<std::string_view> words) {
    return std::any_of(words.begin(), words.end(),
                       [&](std::string_view word) { return has_word(code, word); });
  };
  if (!numbered_ || !has_axis(code, 'X') || !has_axis(code, 'Z') || has_axis(code, 'Y')) return;
  const bool pass = any({"G80", "G81", "G82"}) && has_axis(code, 'F') && !has_axis(code, 'R') &&
                    !any({"G0", "G00", "G1", "G01"});
  const bool rough = any({"G71", "G72", "G73"}) && has_axis(code, 'P') && has_axis(code, 'Q');
  if (pass || rough) refuse("a turning program of Huazhong's control (HNC)", number, raw);
}

// Laser: S is its power, M3, M4 and M5 switch it, and nothing moves in Z.
void ForeignPrograms::weigh_laser(const LineScan& s, int number) {
  const std::string& c = s.code;
  if (upper_case(s.comment).find("LASER") != std::string::npos ||
      upper_case(s.comment).find("LIGHTBURN") != std::string::npos)
    named_laser_ = true;
  if (c.find('Z') != std::string::npos || c.find('K') != std::string::npos) has_z_ = true;
  if (has_axis(c, 'Y')) has_y_ = true;
  for (const std::string_view word : {"M6", "M06", "M98", "G65", "G43", "G96"})
    if (has_word(c, word)) no_laser_ = true;
  if (has_axis(c, 'T') || has(c, "CALL") || c.find('(') != std::string::npos) no_laser_ = true;
  const bool starts =
      has_word(c, "M3") || has_word(c, "M03") || has_word(c, "M4") || has_word(c, "M04");
  const bool power = has_axis(c, 'S');
  if (starts && !beam_on_) {
    beam_on_ = true;
    ++switches_;
    if (laser_line_ == 0) laser_line_ = number;
  }
  if (has_word(c, "M5") || has_word(c, "M05")) beam_on_ = false;
  if (power) has_power_ = true;
  if (power && !starts && (has_axis(c, 'X') || has_axis(c, 'Y'))) ++powered_moves_;
}

// Sliding headstock: Z moves the bar towards the tools, so that plus cuts deeper.
void ForeignPrograms::weigh_sliding_head(const LineScan& s, int number, std::string_view raw) {
  const std::string comment = upper_case(s.comment);
  if (any_of(comment,
             {"CINCOM", "CITIZEN", "SWISS LATHE", "SWISS-TYPE", "SWISS TYPE", "SLIDING HEAD",
              "STAR SB", "STAR SR", "STAR SV", "STAR SW", "STAR ECAS", "TSUGAMI B", "TSUGAMI SS"}))
    refuse("a Swiss-type lathe's program (its headstock moves, so Z runs the other way)", number,
           raw);
}

// Heidenhain's DIN/ISO as its editor shows it: without stars, "%NAME G71" is the head, and G30 with
// the tool's axis is a corner of the blank.
void ForeignPrograms::weigh_heidenhain(const LineScan& s, int number, std::string_view raw) {
  if (number <= kHeadLines && !o_number_ && ends_in_star(s.code, raw))
    refuse("a Heidenhain DIN/ISO program (blocks that end in *)", number, raw);
  const std::string_view head =
      std::string_view(s.code).substr(0, s.code.find_last_not_of(" \t\r") + 1);
  if (head.starts_with('%'))
    unit_in_head_ = head.size() > 4 && (head.ends_with(" G70") || head.ends_with(" G71"));
  const bool axis = has_word(s.code, "G17") || has_word(s.code, "G18") || has_word(s.code, "G19");
  if (unit_in_head_ && axis && has_word(s.code, "G30"))
    refuse("a Heidenhain DIN/ISO program (G30 is its blank)", number, raw);
}

// Old SINUMERIK: the head is "%MPF 90"; "@371" or "(TEXT)", which later ones do not have.
void ForeignPrograms::weigh_old_sinumerik(const LineScan& s, int number, std::string_view raw) {
  if (s.code.starts_with("%MPF") || s.code.starts_with("%SPF"))
    old_sinumerik_ = s.code.find_first_not_of("0123456789 ", 4) == s.code.npos;
  const std::size_t at = s.code.find('@');
  const bool command = at != s.code.npos && at + 1 < s.code.size() && is_digit(s.code[at + 1]);
  if (old_sinumerik_ && (command || s.comment_kind == '('))
    refuse("a program of SINUMERIK 810, 850 or 840C", number, raw);
}

void ForeignPrograms::line(std::string_view raw, const LineScan& scan, int number) {
  if (scan.code.size() > 1 && scan.code[0] == 'O' && is_digit(scan.code[1])) o_number_ = true;
  weigh_heidenhain(scan, number, raw);
  // M48 is the head of a drill file. Behind the first words of a program it allows overrides.
  if (scan.code == "M48" && !coded_) refuse("an Excellon drill file", number, raw);
  coded_ = coded_ || !scan.code.empty();
  if (number <= kHeadLines)
    if (const char* what = named_control(path_, scan.code, raw)) refuse(what, number, raw);
  if (number <= kTitleLines && !scan.comment.empty()) weigh_sliding_head(scan, number, raw);
  if (number <= kHeadLines) weigh_old_sinumerik(scan, number, raw);
  if (!scan.code.empty() && number <= kHeadLines) weigh_num(scan.code, number, raw);
  if (!scan.code.empty() && number <= kHeadLines) weigh_hnc(scan.code, number, raw);
  if (!scan.code.empty() && number <= 2000) weigh_printer(scan.code, number, raw);
  if (!scan.code.empty() && number <= 2000) weigh_plotter(scan.code, number, raw);
  if (!settled()) weigh_laser(scan, number);
}

void ForeignPrograms::finish() const {
  if (pen_line_ > 0 && !(turns_spindle_ && has_z_))
    refuse("a pen plotter's program (M300 S moves its pen)", pen_line_, pen_text_);
  const bool switched = laser_line_ > 0 && has_power_ && has_y_;
  if (settled() || !switched) return;
  if (powered_moves_ >= 2 || switches_ >= 2 || named_laser_)
    refuse("a laser's program (S is its power, and nothing moves in Z)", laser_line_, "");
}

}  // namespace mrsim
