#include "setup/toml_text.h"

#include "core/process/memory_limit.h"

#include <cstddef>

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
  require_flat_keys(text);
  return toml::parse(text);
}

bool is_program_word(std::string_view name) {
  return !name.empty() && !(name.front() >= 'a' && name.front() <= 'z');
}

}  // namespace mrsim
