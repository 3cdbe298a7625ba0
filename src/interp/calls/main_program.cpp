#include "interp/calls/main_program.h"

#include "interp/calls/subprogram.h"
#include "interp/text/characters.h"
#include "interp/text/line_scan.h"
#include "interp/text/source.h"

#include <charconv>
#include <string_view>

namespace mrsim {
namespace {

constexpr std::size_t kLongest = 20000;  // characters of a line in which a call is looked for
constexpr int kLines = 20000;            // lines in which a subprogram before its caller must end

/// Whether the line calls the program: "M98P1000", "M98 P51000" (five times), "G65 P1000".
bool calls(std::string_view code, long number) {
  if (!has_word(code, "M98") && !has_word(code, "G65")) return false;
  const std::size_t p = code.find('P');
  if (p == code.npos) return false;
  const std::size_t from = code.find_first_not_of(' ', p + 1);
  if (from == code.npos) return false;
  long called = -1;
  std::from_chars(code.data() + from, code.data() + code.size(), called);
  return called == number || (called > 9999 && called % 10000 == number);
}

}  // namespace

std::optional<MainProgram> program_that_calls_the_first(const std::string& file) {
  LineSource source(file);
  std::string_view line;
  LineScan scan;
  std::string first;
  long number = -1;
  bool returns = false, calling = false;
  MainProgram current;
  for (std::uint64_t offset = 0; source.next(line); offset = source.next_offset()) {
    const std::string name = section_name(line, Dialect::fanuc);
    if (!name.empty()) {
      if (first.empty()) {
        if (name.size() < 2 || !is_digit(name[1])) return {};
        std::from_chars(name.data() + 1, name.data() + name.size(), number);
        first = name;
      } else if (!returns) {
        return {};
      }
      current = {name, first, offset, source.line_number() - 1};
      calling = false;
    }
    if (line.size() > kLongest) continue;
    scan_line(line, scan);
    if (first.empty() && scan.code.find_first_not_of("% \t\r") != scan.code.npos) return {};
    if (first.empty() || scan.code.starts_with('/')) continue;
    const bool ends =
        has_word(scan.code, "M30") || has_word(scan.code, "M2") || has_word(scan.code, "M02");
    if (!returns) {
      const bool changes_tool = has_word(scan.code, "M6") || has_word(scan.code, "M06");
      if (ends || changes_tool || source.line_number() > kLines) return {};
      returns = has_word(scan.code, "M99");
    } else if (current.name != first) {
      calling = calling || calls(scan.code, number);
      if (calling && ends) return current;
    }
  }
  return {};
}

}  // namespace mrsim
