#include "setup/toml_text.h"

#include "core/process/memory_limit.h"
#include "core/text/text_io.h"
#include "setup/spec_text.h"
#include <mrsim/types.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr int kMostParts = 16;

// Behind the string that begins at `at`, or behind its quote where it does not end.
std::size_t behind_string(std::string_view text, std::size_t at) {
  const char quote = text[at];
  const std::string_view rest = text.substr(at);
  const bool is_long = rest.size() > 2 && rest[1] == quote && rest[2] == quote;
  const std::string_view mark = rest.substr(0, is_long ? 3 : 1);
  for (std::size_t i = mark.size(); i < rest.size(); ++i) {
    if (!is_long && rest[i] == '\n') break;
    if (quote == '"' && rest[i] == '\\')
      ++i;
    else if (rest.substr(i).starts_with(mark))
      return at + i + mark.size();
  }
  return at + 1;
}

bool is_between_parts(char c) { return c == ' ' || c == '\t'; }

bool is_part(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' ||
         c == '-';
}

void require_flat_keys(std::string_view text) {
  std::size_t line_start = 0;
  toml::source_index line = 1;
  int dots = 0;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (c == '"' || c == '\'') {
      const std::size_t end = behind_string(text, i);
      for (; i < end; ++i)
        if (text[i] == '\n') ++line, line_start = i + 1;
      continue;
    }
    if (c == '#') {
      while (i < text.size() && text[i] != '\n') ++i;
      continue;
    }
    dots = c == '.' ? dots + 1 : is_part(c) || is_between_parts(c) ? dots : 0;
    if (dots >= kMostParts)
      throw toml::parse_error(
          "a key has more than 16 parts",
          toml::source_position{line, static_cast<toml::source_index>(i - line_start + 1)});
    if (c == '\n') ++line, line_start = i + 1;
    ++i;
  }
}

}  // namespace

toml::table parse_toml(std::string_view text) {
  constexpr double kParsed = 28;  // bytes for each, measured: with the tools that they become
  constexpr std::size_t kSmall = 100'000;
  if (text.size() > kSmall) {
    const double bytes = double(text.size());
    require_memory(kParsed * bytes, "what a TOML file of " + size_text(bytes) + " says");
  }
  if (is_utf16(text))
    throw toml::parse_error("it is UTF-16 text: save it as UTF-8", toml::source_position{1, 1});
  require_flat_keys(text);
  return toml::parse(text);
}

std::optional<double> finite_number(const toml::node& node) {
  const std::optional<double> value = node.value<double>();
  return node.is_number() && value && std::isfinite(*value) ? value : std::nullopt;
}

void fail_at(const toml::source_position& at, std::string_view text, const std::string& name,
             const char* code, const std::string& what) {
  constexpr std::size_t kShown = 500;  // bytes of a line
  for (std::size_t line = 1; line < at.line && text.find('\n') != text.npos; ++line)
    text.remove_prefix(text.find('\n') + 1);
  text = text.substr(0, text.find('\n'));
  if (text.ends_with('\r')) text.remove_suffix(1);
  Diagnostic diagnostic;
  diagnostic.code = code;
  diagnostic.text = what;
  diagnostic.place = {name, static_cast<int>(at.line), static_cast<int>(at.column)};
  diagnostic.source_line = to_utf8(text.substr(0, kShown));
  throw PlacedError(diagnostic);
}

bool is_program_word(std::string_view name) {
  return !name.empty() && !(name.front() >= 'a' && name.front() <= 'z');
}

bool is_work_offset(std::string_view name) {
  struct Range {
    std::string_view head;
    double low, high;
  };
  constexpr std::array<Range, 7> kRanges = {{{"G54.1P", 1, 300},
                                             {"G154P", 1, 300},
                                             {"G15H", 1, 200},
                                             {"E", 1, 48},
                                             {"G", 54, 59},
                                             {"G", 110, 129},
                                             {"G", 505, 599}}};
  std::string word;
  std::copy_if(name.begin(), name.end(), std::back_inserter(word), [](char c) { return c != ' '; });
  if (word == "EXT" || word == "G59.1" || word == "G59.2" || word == "G59.3") return true;
  return std::any_of(kRanges.begin(), kRanges.end(), [&](const Range& range) {
    if (!word.starts_with(range.head)) return false;
    const std::string number = word.substr(range.head.size());
    const bool is_whole = number.find_first_not_of("0123456789") == number.npos;
    const auto value = is_whole && number[0] != '0' ? parse_number(number) : std::nullopt;
    return value && *value >= range.low && *value <= range.high;
  });
}

std::string no_offset(std::string_view name) {
  return fmt::format(
      "\"{}\" is a work offset of no control: write it as the program selects it, in capitals: "
      "G54, G505, \"G54.1 P2\"",
      name);
}

}  // namespace mrsim
