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

/// Whether the block calls the program of SINUMERIK: "N10 NAME", "NAME P2", "CALL \"NAME\"".
bool calls_name(std::string_view code, std::string_view name) {
  const auto skip = [&](std::string_view any) {
    code.remove_prefix(std::min(code.find_first_not_of(any), code.size()));
  };
  skip(" \t");
  if (code.size() > 1 && code[0] == 'N' && is_digit(code[1])) {
    code.remove_prefix(1);
    skip("0123456789");
    skip(" \t");
  }
  bool called = false;
  for (const std::string_view word : {"MCALL ", "EXTCALL ", "CALL "}) {
    if (!code.starts_with(word)) continue;
    called = true;
    code.remove_prefix(word.size());
  }
  const bool is_word = name.size() < 2 || (is_digit(name[1]) && name[0] != 'L');  // "T5" of a block
  if (is_word && !called) return false;
  skip(" \t\"");
  if (!code.starts_with(name)) return false;
  code.remove_prefix(name.size());
  if (!code.empty() && is_name(code[0])) return false;
  skip(" \t");
  return !code.starts_with('=') && !code.starts_with(':');
}

/// Whether the line calls the program: by its number, as "M98 <NAME>" or as "CALL ONAME" of Okuma.
bool calls(std::string_view code, std::string_view name, Dialect dialect) {
  if (dialect == Dialect::sinumerik) return calls_name(code, name);
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

bool ends_program(std::string_view code) {
  return has_word(code, "M30") || has_word(code, "M2") || has_word(code, "M02");
}

/// Whether the block ends a subprogram.
bool ends_subprogram(std::string_view code, Dialect dialect) {
  if (dialect == Dialect::sinumerik) return has_word(code, "M17") || has_whole_word(code, "RET");
  return has_word(code, "M99") || has_whole_word(code, "RTS");
}

/// Whether the block shows that its program, the first of the file, is no subprogram. A tool change
/// shows it on FANUC alone, where a main program may end with M99, to run again.
bool shows_main_program(std::string_view code, Dialect dialect) {
  const bool changes_tool = has_word(code, "M6") || has_word(code, "M06");
  return ends_program(code) || (changes_tool && dialect == Dialect::fanuc);
}

std::optional<MainProgram> program_that_calls_the_first(LineSource& source, Dialect dialect) {
  std::string_view line;
  LineScan scan;
  std::string first;
  bool returns = false, calling = false, main = false;
  MainProgram current;
  for (std::uint64_t offset = 0; source.next(line); offset = source.next_offset()) {
    const std::string name = section_name(line, dialect);
    if (!name.empty()) {
      if (first.empty())
        first = name;
      else if (!returns)
        return {};
      current = {name, "it calls " + first + ", which stands before it and returns", offset,
                 source.line_number() - 1};
      calling = false;
      main = dialect == Dialect::fanuc || names_main_program(line);
    }
    if (line.size() > kLongest) continue;
    scan_line(line, scan);
    if (first.empty() && scan.code.find_first_not_of("% \t\r") != scan.code.npos) return {};
    if (first.empty() || scan.code.starts_with('/')) continue;
    if (!returns) {
      if (shows_main_program(scan.code, dialect) || source.line_number() > kLines) return {};
      returns = ends_subprogram(scan.code, dialect);
    } else if (main && current.name != first) {
      calling = calling || calls(scan.code, first, dialect);
      if (calling && ends_program(scan.code)) return current;
    }
  }
  return {};
}

/// The first "%_N_PART_MPF" of a file that begins with another header. Comments and blank lines may
/// stand before that.
std::optional<MainProgram> first_of_archive(LineSource& source) {
  std::string_view line;
  bool inside = false;
  for (std::uint64_t offset = 0; source.next(line); offset = source.next_offset()) {
    const std::string name = section_name(line, Dialect::sinumerik);
    const std::size_t text = line.find_first_not_of(" \t\r");
    if (name.empty() && !inside && text != line.npos && line[text] != ';') return {};
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
  if (dialect != Dialect::fanuc && dialect != Dialect::sinumerik) return {};
  if (dialect == Dialect::sinumerik) {
    LineSource archive(file);
    if (auto main = first_of_archive(archive)) return main;
  }
  LineSource source(file);
  return program_that_calls_the_first(source, dialect);
}

}  // namespace mrsim
