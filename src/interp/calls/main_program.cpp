#include "interp/calls/main_program.h"

#include "interp/calls/subprogram.h"
#include "interp/text/characters.h"
#include "interp/text/line_scan.h"
#include "interp/text/source.h"

#include <algorithm>
#include <charconv>
#include <string_view>

namespace mrsim {
namespace {

constexpr std::size_t kLongest = 20000;  // characters of a line in which a call is looked for
constexpr int kLines = 20000;            // lines in which a subprogram before its caller must end

/// Whether the line calls O1000: "M98P1000", "M98 P51000" (five times), "G65 P1000".
bool calls_number(std::string_view code, std::string_view name) {
  const std::size_t p = code.find('P');
  if (p == code.npos || name.size() < 2 || !is_digit(name[1])) return false;
  const std::size_t from = code.find_first_not_of(' ', p + 1);
  if (from == code.npos) return false;
  long called = -1, number = -1;
  std::from_chars(code.data() + from, code.data() + code.size(), called);
  std::from_chars(name.data() + 1, name.data() + name.size(), number);
  return called == number || (called > 9999 && called % 10000 == number);
}

/// Whether the line calls the program: by its number, as "M98 <NAME>" or as "CALL ONAME" of Okuma.
bool calls(std::string_view code, std::string_view name) {
  if (has_word(code, "M98") || has_word(code, "G65"))
    return calls_number(code, name) || bracketed_name(code, code.find('<')) == name;
  for (const std::string_view word : {"CALL", "MODIN"}) {
    const std::size_t at = code.find(word);
    if (at == code.npos) continue;
    std::string_view called = code.substr(at + word.size());
    called.remove_prefix(std::min(called.find_first_not_of(' '), called.size()));
    const auto end = std::find_if(called.begin(), called.end(), [](char c) { return !is_name(c); });
    if (section_name({called.begin(), end}, Dialect::fanuc) == name) return true;
  }
  return false;
}

/// Whether the block ends a subprogram.
bool ends_subprogram(std::string_view code) {
  return has_word(code, "M99") || has_whole_word(code, "RTS");
}

std::optional<MainProgram> program_that_calls_the_first(LineSource& source) {
  std::string_view line;
  LineScan scan;
  std::string first;
  bool returns = false, calling = false;
  MainProgram current;
  for (std::uint64_t offset = 0; source.next(line); offset = source.next_offset()) {
    const std::string name = section_name(line, Dialect::fanuc);
    if (!name.empty()) {
      if (first.empty())
        first = name;
      else if (!returns)
        return {};
      current = {name, "it calls " + first + ", which stands before it and returns", offset,
                 source.line_number() - 1};
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
      returns = ends_subprogram(scan.code);
    } else if (current.name != first) {
      calling = calling || calls(scan.code, first);
      if (calling && ends) return current;
    }
  }
  return {};
}

/// The first "%_N_PART_MPF", if another header or block does not stand before it.
std::optional<MainProgram> first_of_archive(LineSource& source) {
  std::string_view line;
  bool inside = false;
  for (std::uint64_t offset = 0; source.next(line); offset = source.next_offset()) {
    const std::string name = section_name(line, Dialect::sinumerik);
    const bool blank = line.find_first_not_of(" \t\r") == line.npos;
    if (name.empty() && !inside && !blank) return {};
    if (name.empty()) continue;
    if (names_main_program(line)) {
      if (!inside) return {};
      return MainProgram{name, "it is the first _MPF of the file", offset,
                         source.line_number() - 1};
    }
    inside = true;
  }
  return {};
}

}  // namespace

std::optional<MainProgram> main_program_behind(const std::string& file, Dialect dialect) {
  LineSource source(file);
  if (dialect == Dialect::fanuc) return program_that_calls_the_first(source);
  if (dialect == Dialect::sinumerik) return first_of_archive(source);
  return {};
}

}  // namespace mrsim
