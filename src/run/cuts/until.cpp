#include "run/cuts/until.h"

#include "core/process/error.h"
#include "interp/text/source.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <optional>
#include <string_view>

#include <fmt/format.h>

namespace mrsim {
namespace {

[[noreturn]] void fail_invalid(const std::string& until) {
  throw Error("until-invalid",
              fmt::format("--until {}: a line of the program (12), of another file (O100:7), or a "
                          "motion (#5000) is wanted",
                          until),
              Error::Kind::usage);
}

std::optional<std::size_t> whole_number(std::string_view text) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value == 0) return std::nullopt;
  return value;
}

[[noreturn]] void fail_beyond(const std::string& until, const std::string& there_are) {
  throw Error("until-beyond", fmt::format("--until {}: there are {}", until, there_are),
              Error::Kind::usage);
}

// A line after the last motion ends the program normally. A line beyond the end of the file is an
// error.
void require_line(const Program& program, const std::string& until, int file, std::size_t line) {
  const std::string& path = program.files[static_cast<std::size_t>(file)];
  LineSource source(path);
  std::string_view text;
  while (source.next(text))
    if (static_cast<std::size_t>(source.line_number()) == line) return;
  fail_beyond(until, fmt::format("{} lines in {}", source.line_number(),
                                 std::filesystem::path(path).filename().string()));
}

// 100 of "O100", "O0100" and "0100".
std::optional<std::size_t> program_number(std::string_view name) {
  if (name.starts_with('O') || name.starts_with('o')) name.remove_prefix(1);
  return whole_number(name);
}

int file_named(const Program& program, const std::string& name) {
  const std::optional<std::size_t> number = program_number(name);
  std::string known;
  for (std::size_t i = 0; i < program.files.size(); ++i) {
    const std::filesystem::path path = program.files[i];
    if (name == path.filename() || name == path.stem() ||
        (number && number == program_number(path.stem().string())))
      return static_cast<int>(i);
    known += (known.empty() ? "" : ", ") + path.filename().string();
  }
  throw Error(
      "until-file",
      fmt::format("--until: no motion comes from a file \"{}\" (there are: {})", name, known),
      Error::Kind::usage);
}

// The last line of `file`, at or before `line`, at which a motion stands or from which it was
// called; 0 = none. A subprogram may stand in the file of its call, and a hole of a cycle stands at
// the cycle's line, called from that of its place.
int line_in(const Program& program, const Motion& motion, int file, std::size_t line) {
  int last = 0;
  const auto count = [&](int at_file, int at) {
    if (at_file == file && static_cast<std::size_t>(at) <= line) last = std::max(last, at);
  };
  count(motion.file, motion.line);
  for (int call = motion.call; call >= 0;) {
    const CallSite& site = program.calls[static_cast<std::size_t>(call)];
    count(site.file, site.line);
    call = site.outer;
  }
  return last;
}

std::size_t motions_until_line(const Program& program, int file, std::size_t line) {
  const std::vector<Motion>& motions = program.motions;
  int last = 0;  // the last line at or before `line` that moves
  for (const Motion& motion : motions) last = std::max(last, line_in(program, motion, file, line));
  if (last == 0) return 0;
  // Whether `last` makes or calls a motion: lines before it no longer count.
  const auto is_of_last = [&](const Motion& motion) {
    return line_in(program, motion, file, static_cast<std::size_t>(last)) == last;
  };
  std::size_t i = 0;
  while (!is_of_last(motions[i])) ++i;
  while (i < motions.size() && is_of_last(motions[i])) ++i;
  return i;
}

}  // namespace

std::size_t motions_until(const Program& program, const std::string& until) {
  if (until.starts_with('#')) {
    const std::optional<std::size_t> motion = whole_number(std::string_view(until).substr(1));
    if (!motion) fail_invalid(until);
    if (*motion > program.motions.size())
      fail_beyond(until, fmt::format("{} motions", program.motions.size()));
    return *motion;
  }
  const std::size_t colon = until.rfind(':');
  const std::optional<std::size_t> line =
      whole_number(std::string_view(until).substr(colon == until.npos ? 0 : colon + 1));
  if (!line || colon == 0) fail_invalid(until);
  const int file = colon == until.npos ? 0 : file_named(program, until.substr(0, colon));
  require_line(program, until, file, *line);
  return motions_until_line(program, file, *line);
}

}  // namespace mrsim
