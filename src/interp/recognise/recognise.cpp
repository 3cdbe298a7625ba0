#include "interp/recognise/recognise.h"

#include "core/error.h"
#include "interp/recognise/dialect_signs.h"
#include "interp/recognise/file_kind.h"
#include "interp/recognise/foreign_programs.h"
#include "interp/recognise/machine_signs.h"
#include "interp/text/characters.h"
#include "interp/text/line_scan.h"
#include "interp/text/source.h"

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr int kDialectLines = 20000;  // enough to tell a control; the machine may need the rest
constexpr int kOkumaLines = 300;      // where Okuma's programs say whose they are
constexpr std::size_t kLongestScan = 4000;  // bytes of a line

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
      // A block begins with a word; text in which one occurs is still text, and so is the number
      // of the program before its mark.
      const std::size_t at = s.code.find_first_not_of(" \t/");
      if (at != std::string::npos && at + 1 < s.code.size() &&
          std::string_view("GMNOTXYZ:").find(s.code[at]) < 9 && is_digit(s.code[at + 1]) &&
          (s.code[at] != 'O' ||
           s.code.find_first_not_of("0123456789 \t", at + 1) != std::string::npos))
        done_ = true;
    }
  }
  int lines() const { return lines_; }

 private:
  int mark_ = 0, lines_ = 0;
  bool done_ = false;
};

/// What is known while the text is read.
class Reader {
 public:
  Reader(const std::string& path, const InterpOptions& options)
      : options_(options),
        told_dialect_(options.dialect != Dialect::automatic),
        wants_machine_(options.machine == MachineKind::automatic),
        foreign_(path) {
    signs_.name(path);
    okuma_ = names_okuma(path);
  }
  /// False: the rest of the text can not change the answer.
  bool line(std::string_view raw, int number);
  Recognition answer() const;

 private:
  const InterpOptions& options_;
  bool told_dialect_, wants_machine_, empty_ = true;
  DialectSigns signs_;
  MachineSigns machine_;
  ForeignPrograms foreign_;
  Leader leader_;
  LineScan scan_;
  bool okuma_ = false;
};

bool Reader::line(std::string_view raw, int n) {
  const bool wants_dialect = !told_dialect_ && n <= kDialectLines && !signs_.certain();
  if (!empty_ && !wants_dialect && n > 200 && (!wants_machine_ || machine_.settled()) &&
      (told_dialect_ || foreign_.settled()))
    return false;
  const std::size_t first = raw.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return true;
  if (raw[first] == '%' || raw[first] == '$')  // "% " is a tape mark, no header
    raw = raw.substr(0, raw.find_last_not_of(" \t\r") + 1);
  PlainLine plain;
  if (n > Leader::kLines && raw.size() <= kLongestScan && read_plain(raw, plain) &&
      (!plain.second || !wants_machine_ || machine_.knows_mill())) {
    empty_ = false;
    signs_.plain(plain, n);
    foreign_.plain(plain);
    return true;
  }
  scan_line(raw.substr(0, kLongestScan), scan_);
  leader_.line(raw, scan_, n);
  if (n <= kOkumaLines && is_okuma(scan_)) okuma_ = true;
  if (!scan_.code.empty() || !scan_.comment.empty()) empty_ = false;
  if (!told_dialect_) foreign_.line(raw, scan_, n);
  if (wants_dialect) signs_.line(scan_, raw, n);
  if (wants_machine_) machine_.line(scan_, n);
  return true;
}

Recognition Reader::answer() const {
  Recognition out;
  out.empty = empty_;
  out.dialect = options_.dialect;
  out.dialect_reason = "as told";
  if (!told_dialect_) {
    foreign_.finish();
    out.dialect = signs_.best();
    out.dialect_reason = signs_.reason(out.dialect);
    if (out.dialect_reason.empty()) out.dialect_reason = "nothing points to another control";
  }
  if (out.dialect == Dialect::fanuc || out.dialect == Dialect::iso || out.dialect == Dialect::ngc)
    out.leader_lines = leader_.lines();
  out.okuma = okuma_ && out.dialect == Dialect::fanuc;
  out.machine = options_.machine;
  out.machine_reason = "as told";
  if (wants_machine_) machine_.judge(options_, out);
  return out;
}

}  // namespace

Recognition recognise(const std::string& path, const InterpOptions& options) {
  Reader reader(path, options);
  LineSource source(path);
  if (const std::string_view kind = kind_of_file(source.ahead(kFileHead), source.size());
      !kind.empty())
    throw Error("file-not-program",
                fmt::format("{} is {}, no NC program: parts and stocks are given with --stock, "
                            "--nominal or to mrsim render",
                            path, kind));
  std::string_view raw;
  while (source.next(raw)) {
    const int n = source.line_number();
    if (n == 1 && (raw.starts_with("\xFF\xFE") || raw.starts_with("\xFE\xFF")))
      throw Error("file-encoding",
                  fmt::format("{} is UTF-16 text: save it as UTF-8 or plain ASCII", path));
    if (!reader.line(raw, n)) break;
  }
  return reader.answer();
}

}  // namespace mrsim
