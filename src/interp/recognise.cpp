#include "interp/recognise.h"

#include "core/error.h"
#include "interp/characters.h"
#include "interp/line_scan.h"
#include "interp/machine_signs.h"
#include "interp/source.h"

#include <algorithm>
#include <array>
#include <vector>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr int kDialectLines = 20000;  // enough to tell a control; the machine may need the rest
constexpr std::size_t kLongestScan = 4000;  // bytes of a line

std::size_t slot(Dialect d) { return static_cast<std::size_t>(d); }

/// Points for each dialect, and the strongest sign of each.
class Evidence {
 public:
  /// Each sign counts once: a thousand comments say no more than one.
  void add(Dialect dialect, int points, std::string_view sign, int line) {
    Entry& e = entries_[slot(dialect)];
    if (std::find(e.signs.begin(), e.signs.end(), sign) != e.signs.end()) return;
    e.signs.emplace_back(sign);
    e.points += points;
    if (points <= e.strongest) return;
    e.strongest = points;
    e.reason = line > 0 ? fmt::format("{} in line {}", sign, line) : std::string(sign);
  }
  Dialect best() const {
    static constexpr Dialect kOrder[] = {Dialect::sinumerik, Dialect::fanuc, Dialect::codesys};
    Dialect winner = Dialect::iso;
    for (const Dialect d : kOrder)
      if (points(d) > points(winner)) winner = d;
    return winner;
  }
  int points(Dialect d) const { return entries_[slot(d)].points; }
  const std::string& reason(Dialect d) const { return entries_[slot(d)].reason; }
  bool certain() const {
    const Dialect d = best();
    for (const Dialect o : {Dialect::sinumerik, Dialect::fanuc, Dialect::codesys, Dialect::iso})
      if (o != d && points(d) < points(o) + 20) return false;
    return true;
  }

 private:
  struct Entry {
    int points = 0, strongest = 0;
    std::string reason;
    std::vector<std::string> signs;
  };
  std::array<Entry, 5> entries_;
};

void weigh_sinumerik(const LineScan& s, int line, Evidence& e) {
  constexpr auto d = Dialect::sinumerik;
  static constexpr std::string_view kSure[] = {
      "CR=",   "=AC(",       "=IC(",  "LIMS=",   "TRANS ", "ATRANS",  "AROT",
      "CIP ",  "TURN=",      "I1=",   "DIAMON",  "DIAMOF", "DIAM90",  "MSG(",
      "%_N_",  "AR=",        "RP=",   "RND=",    "CHF=",   "CHR=",    "ANG=",
      "RNDM=", "WORKPIECE(", "SUPA",  "AMIRROR", "ASCALE", "MIRROR ", "SCALE ",
      "ROT ",  "G500",       "GOTOF", "GOTOB",   "ENDIF",  "CYCLE8",  "T=\""};
  for (const std::string_view sign : kSure)
    if (s.code.find(sign) != std::string::npos) e.add(d, 10, sign, line);
  const std::size_t equal = s.code.find('=');
  if (equal != std::string::npos && equal > 0 && is_name(s.code[equal - 1]) && s.code[0] != '#')
    e.add(d, 4, "an assignment with =", line);
  if (s.comment_kind == ';' && !s.code.empty()) e.add(d, 3, "a comment after ;", line);
  if (s.comment_kind == ';' && s.code.empty()) e.add(d, 2, "a comment after ;", line);
  if (has_word(s.code, "M17")) e.add(d, 4, "M17", line);
  if (has_word(s.code, "G710") || has_word(s.code, "G700")) e.add(d, 8, "G710", line);
  if (has_word(s.code, "G450") || has_word(s.code, "G451")) e.add(d, 8, "G450/G451", line);
}

void weigh_fanuc(const LineScan& s, std::string_view raw, int line, Evidence& e) {
  constexpr auto d = Dialect::fanuc;
  const std::string& c = s.code;
  const bool number = c.size() > 1 && is_digit(c[1]);
  if (number && (c[0] == 'O' || c[0] == ':')) e.add(d, 10, "a program number", line);
  if (raw.size() == 1 && raw[0] == '%') e.add(d, 3, "% alone", line);
  if (s.ends_block) e.add(d, 3, "; as end of block", line);
  if (has(c, "M98")) e.add(d, 6, "M98", line);
  if (has_word(c, "M99")) e.add(d, 4, "M99", line);
  for (const std::string_view g :
       {"G43", "G49", "G54.1", "G68", "G69", "G51.1", "G50.1", "G52", "G28"})
    if (has_word(c, g)) e.add(d, g == "G43" || g == "G28" || g == "G49" ? 3 : 6, g, line);
  if (has_word(c, "G20") || has_word(c, "G21")) {
    e.add(d, 3, "G20/G21", line);
    e.add(Dialect::iso, 3, "G20/G21", line);
    e.add(Dialect::sinumerik, -6, "G20/G21", line);
  }
  if (s.comment_kind == ';') e.add(d, -6, "a comment after ;", line);
  if (has_word(c, "G16") && !has_axis(c, 'I') && !has_axis(c, 'J') && !has_axis(c, 'K'))
    e.add(d, 2, "G16 without a normal vector", line);
  if (c.find('#') != std::string::npos && c.find('=') != std::string::npos &&
      c.find(':') == std::string::npos)
    e.add(d, 6, "a # variable", line);
  if (c.find("IF[") != std::string::npos || c.find("WHILE[") != std::string::npos)
    e.add(d, 8, "a macro statement", line);
  std::size_t run = 0;
  for (std::size_t i = 1; i < c.size(); ++i)
    if (c[i] == 'G' && is_digit(c[i - 1])) ++run;
  if (run > 0) e.add(d, 3, "G codes run together", line);
}

std::size_t count_numbers(std::string_view c) {
  std::size_t n = 0;
  for (std::size_t i = 0; i + 1 < c.size(); ++i)
    if (c[i] == 'N' && is_digit(c[i + 1]) && (i == 0 || !is_name(c[i - 1]))) ++n;
  return n;
}

void weigh_codesys(const LineScan& s, int line, bool& arcs, Evidence& e) {
  constexpr auto d = Dialect::codesys;
  const std::string& c = s.code;
  const bool named_arc =
      has_word(c, "G2") || has_word(c, "G3") || has_word(c, "G02") || has_word(c, "G03");
  if (named_arc) arcs = true;
  if (has_word(c, "G1") || has_word(c, "G0") || has_word(c, "G01") || has_word(c, "G00")) {
    if (count_numbers(c) < 2) arcs = false;
  }
  const bool center = has_axis(c, 'I') || has_axis(c, 'J') || has_axis(c, 'K');
  if (arcs && center && has_axis(c, 'T')) e.add(d, 12, "T as an opening angle", line);
  if (count_numbers(c) > 1) e.add(d, 6, "several N words in a line", line);
  if (has(c, "SUBPROGRAM") || has(c, "END_SUBPROGRAM")) e.add(d, 15, "SUBPROGRAM", line);
  if (c.find(": LREAL") != std::string::npos) e.add(d, 10, "LREAL", line);
  if (c.find('{') != std::string::npos) e.add(d, 6, "a call with { }", line);
  if (c.find('$') != std::string::npos && c.find("$P_") == std::string::npos &&
      std::count(c.begin(), c.end(), '$') > 1)
    e.add(d, 6, "a variable in $ $", line);
  if (has_word(c, "G16") && center) e.add(d, 10, "G16 with a normal vector", line);
  const bool cycle = has_axis(c, 'R') || has_axis(c, 'Z') || has(c, "G8") || has(c, "G7");
  const bool feeds = has_axis(c, 'F') || has_axis(c, 'S');
  if ((has_word(c, "G98") || has_word(c, "G99")) && !cycle && (!feeds || (named_arc && center)))
    e.add(d, 5, "G98/G99 for the centre", line);
  if (has(c, "FF") || has(c, "EF")) e.add(d, 5, "FF/EF", line);
  const std::size_t first = c.find(" E"),
                    second = first == std::string::npos ? first : c.find(" E", first + 2);
  if (second != std::string::npos && second + 2 < c.size() && starts_number(c[second + 2]))
    e.add(d, 8, "E twice", line);
  if (c.size() > 2 && c[0] == '%' && c[1] == ' ') e.add(d, 4, "a header with %", line);
}

void weigh_iso(const LineScan& s, std::string_view raw, int line, Evidence& e) {
  bool lower = false;
  for (const char c : raw)
    if (c >= 'a' && c <= 'z') lower = true;
  if (lower && s.comment.empty() && s.code.find('=') == std::string::npos)
    e.add(Dialect::iso, 1, "lower-case words", line);
}

/// Text before the first % of a tape is no program: how many lines, once content follows the mark.
class Leader {
 public:
  static constexpr int kLines = 100;  ///< no mark is looked for behind them

  void line(std::string_view raw, const LineScan& s, int n) {
    if (n > kLines || done_) return;
    if (mark_ == 0 && !raw.empty() && raw[0] == '%') {
      mark_ = n;
    } else if (mark_ > 0) {
      lines_ = mark_ - 1;
      done_ = true;
    } else {
      // A block begins with a word; text in which one occurs is still text.
      const std::size_t at = s.code.find_first_not_of(" \t/");
      if (at != std::string::npos && at + 1 < s.code.size() &&
          std::string_view("GMNOTXYZ:").find(s.code[at]) < 9 && is_digit(s.code[at + 1]))
        done_ = true;
    }
  }
  int lines() const { return lines_; }

 private:
  int mark_ = 0, lines_ = 0;
  bool done_ = false;
};

void judge_dialect(const Evidence& e, Recognition& out) {
  out.dialect = e.best();
  out.dialect_reason = e.reason(out.dialect);
  if (out.dialect_reason.empty()) out.dialect_reason = "nothing points to another control";
}

void weigh_name(const std::string& path, Evidence& e) {
  const std::size_t dot = path.find_last_of('.');
  if (dot == std::string::npos) return;
  const std::string extension = upper_case(path.substr(dot));
  if (extension == ".MPF" || extension == ".SPF")
    e.add(Dialect::sinumerik, 12, fmt::format("the file name ends in {}", extension), 0);
  if (extension == ".CNC") e.add(Dialect::codesys, 2, "the file name ends in .CNC", 0);
}

}  // namespace

Recognition recognise(const std::string& path, const InterpOptions& options) {
  Recognition out;
  Evidence evidence;
  MachineSigns machine;
  weigh_name(path, evidence);
  LineSource source(path);
  LineScan scan;
  std::string_view raw;
  bool arcs = false;
  Leader leader;
  const bool wants_machine = options.machine == MachineKind::automatic;
  while (source.next(raw)) {
    const int n = source.line_number();
    if (n == 1 && (raw.starts_with("\xFF\xFE") || raw.starts_with("\xFE\xFF")))
      throw Error("file-encoding",
                  fmt::format("{} is UTF-16 text: save it as UTF-8 or plain ASCII", path));
    const bool wants_dialect =
        options.dialect == Dialect::automatic && n <= kDialectLines && !evidence.certain();
    if (!out.empty && !wants_dialect && n > 200 && (!wants_machine || machine.settled())) break;
    if (raw.find_first_not_of(" \t\r") == std::string_view::npos) continue;
    PlainLine plain;
    if (n > Leader::kLines && raw.size() <= kLongestScan && read_plain(raw, plain) &&
        (!plain.second || !wants_machine || machine.knows_mill())) {
      out.empty = false;
      if (plain.arc) arcs = true;
      if (plain.line) arcs = false;
      continue;
    }
    scan_line(raw.substr(0, kLongestScan), scan);
    leader.line(raw, scan, n);
    if (!scan.code.empty() || !scan.comment.empty()) out.empty = false;
    if (wants_dialect) {
      weigh_sinumerik(scan, n, evidence);
      weigh_fanuc(scan, raw, n, evidence);
      weigh_codesys(scan, n, arcs, evidence);
      weigh_iso(scan, raw, n, evidence);
    }
    if (wants_machine)
      machine.line(scan, n,
                   options.dialect == Dialect::automatic ? evidence.best() : options.dialect);
  }
  out.dialect = options.dialect;
  out.dialect_reason = "as told";
  if (options.dialect == Dialect::automatic) judge_dialect(evidence, out);
  if (out.dialect == Dialect::fanuc || out.dialect == Dialect::iso)
    out.leader_lines = leader.lines();
  out.machine = options.machine;
  out.machine_reason = "as told";
  if (wants_machine) machine.judge(options, out);
  return out;
}

}  // namespace mrsim
