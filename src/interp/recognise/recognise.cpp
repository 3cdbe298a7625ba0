#include "interp/recognise/recognise.h"

#include "core/process/error.h"
#include "interp/recognise/dialect_signs.h"
#include "interp/recognise/foreign_programs.h"
#include "interp/recognise/machine_signs.h"
#include "interp/text/characters.h"
#include "interp/text/line_scan.h"
#include "interp/text/source.h"

#include <algorithm>
#include <cstdint>
#include <string_view>

#include <fmt/format.h>

namespace mrsim {
namespace {

// Files that are no programs are recognised by their first bytes: the user gets one sentence
// instead of a hundred errors about characters.
constexpr std::size_t kFileHead = 512;  // bytes that are enough to recognise the kind of a file

constexpr std::size_t kStlHeader = 80, kStlTriangle = 50;

struct Kind {
  std::string_view start, name;
};
using namespace std::string_view_literals;
constexpr Kind kKinds[] = {{"\x20\x42\x44\x56\0\0\0\0"sv, "an OpenVDB file"},
                           {"\x89PNG"sv, "a picture (PNG)"},
                           {"\xFF\xD8\xFF"sv, "a picture (JPEG)"},
                           {"%PDF-"sv, "a PDF document"},
                           {"PK\x03\x04"sv, "a ZIP archive, as 3MF and FreeCAD's files are"},
                           {"\x1F\x8B"sv, "compressed by gzip"},
                           {"glTF"sv, "a mesh (GLB)"},
                           {"ply\n"sv, "a mesh (PLY)"},
                           {"ply\r"sv, "a mesh (PLY)"},
                           {"OFF\n"sv, "a mesh (OFF)"},
                           {"OFF\r"sv, "a mesh (OFF)"},
                           {"ISO-10303-21"sv, "a solid (STEP)"},
                           {"\x7F"
                            "ELF"sv,
                            "a program of this computer"},
                           {"<?xml"sv, "an XML file"},
                           {"<!DOCTYPE"sv, "an HTML page"},
                           {"<!doctype"sv, "an HTML page"},
                           {"<html"sv, "an HTML page"},
                           {"<svg"sv, "a drawing (SVG)"}};

// A binary STL file is 80 bytes, the number of triangles, and the triangles.
bool is_binary_stl(std::string_view head, std::uint64_t size) {
  if (head.size() < kStlHeader + 4) return false;
  std::uint64_t triangles = 0;
  for (int k = 3; k >= 0; --k)
    triangles = 256 * triangles +
                static_cast<unsigned char>(head[kStlHeader + static_cast<std::size_t>(k)]);
  return triangles > 0 && size == kStlHeader + 4 + kStlTriangle * triangles;
}

bool is_text_stl(std::string_view head) {
  return head.starts_with("solid") && head.find("facet") != head.npos;
}

// JSON begins with `{"name": ...`. A brace alone may be CODESYS'.
bool is_json(std::string_view head) {
  const std::size_t brace = head.find_first_not_of(" \t\r\n");
  if (brace == head.npos || (head[brace] != '{' && head[brace] != '[')) return false;
  const std::size_t next = head.find_first_not_of(" \t\r\n{[", brace + 1);
  if (next == head.npos || head[next] != '"') return false;
  const std::size_t end = head.find('"', next + 1);
  return end != head.npos && end + 1 < head.size() &&
         (head[end + 1] == ':' || head[end + 1] == ' ');
}

// DXF begins with a group code and a name: "  0", "SECTION".
bool is_dxf(std::string_view head) {
  const std::size_t zero = head.find_first_not_of(" \t");
  if (zero == head.npos || head[zero] != '0') return false;
  const std::size_t name = head.find_first_not_of(" \t\r\n", zero + 1);
  return name != head.npos && name > zero + 1 && head.substr(name).starts_with("SECTION");
}

// The kind of a file by its beginning ("a mesh (STL)"); empty where it may be a program. `size`:
// bytes of the whole file, 0 where that is not known.
std::string_view kind_of_file(std::string_view head, std::uint64_t size) {
  for (const Kind& kind : kKinds)
    if (head.starts_with(kind.start)) return kind.name;
  if (is_binary_stl(head, size) || is_text_stl(head)) return "a mesh (STL)";
  if (is_json(head)) return "a JSON file";
  if (is_dxf(head)) return "a drawing (DXF)";
  return {};
}

constexpr int kDialectLines =
    20000;                        // enough to recognise a control; the machine may need the rest
constexpr int kOkumaLines = 300;  // lines in which Okuma's programs show their control
constexpr std::size_t kLongestScan = 4000;  // bytes: more of a line is not scanned

/// Text before the first % of a tape is no program. Counts its lines, if content follows the mark.
class Leader {
 public:
  static constexpr int kLines = 100;  ///< the mark is looked for in so many lines

  void line(std::string_view raw, const LineScan& s, int n) {
    if (n > kLines || done_) return;
    if (mark_ == 0 && !raw.empty() && raw[0] == '%') {
      mark_ = n;
    } else if (mark_ > 0) {
      lines_ = mark_ - 1;
      done_ = true;
    } else {
      // A block begins with a word. Text that contains one is still text, and so is the program's
      // number before its mark.
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

/// Reads the text and collects what is known.
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
  /// Looks at a line. False: the rest of the text cannot change the answer.
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

/// Whether the file begins with UTF-16 text, with or without its mark.
bool is_utf16(std::string_view head) {
  if (head.starts_with("\xFF\xFE") || head.starts_with("\xFE\xFF")) return true;
  const std::size_t pairs = std::min<std::size_t>(head.size() / 2, 8);
  std::size_t little = 0, big = 0;
  for (std::size_t i = 0; i < pairs; ++i) {
    const bool first = head[2 * i] != '\0', second = head[2 * i + 1] != '\0';
    little += first && !second ? 1U : 0U;
    big += second && !first ? 1U : 0U;
  }
  return pairs > 1 && (little == pairs || big == pairs);
}

}  // namespace

Recognition recognise(const std::string& path, const InterpOptions& options) {
  Reader reader(path, options);
  LineSource source(path);
  if (is_utf16(source.ahead(kFileHead)))
    throw Error("file-encoding",
                fmt::format("{} is UTF-16 text: save it as UTF-8 or plain ASCII", path));
  if (const std::string_view kind = kind_of_file(source.ahead(kFileHead), source.size());
      !kind.empty())
    throw Error("file-not-program",
                fmt::format("{} is {}, no NC program: parts and stocks are given with --stock, "
                            "--nominal or to mrsim render",
                            path, kind));
  std::string_view raw;
  while (source.next(raw)) {
    const int n = source.line_number();
    if (!reader.line(raw, n)) break;
  }
  return reader.answer();
}

}  // namespace mrsim
