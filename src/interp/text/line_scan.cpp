#include "interp/text/line_scan.h"

#include "interp/text/characters.h"

#include <algorithm>
#include <iterator>
#include <string>

namespace mrsim {
namespace {

constexpr std::size_t kLongestProgramName = 32;

/// Whether brackets about a parameter of an ISO control follow: "X(P1+2)".
bool holds_parameter(std::string_view code, std::string_view rest) {
  if (code.empty() || !is_letter(code.back())) return false;
  if (code.size() > 1 && is_name(code[code.size() - 2])) return false;
  const std::string_view inside = rest.substr(0, rest.find(')'));
  for (std::size_t i = 1; i + 1 < inside.size(); ++i)
    if (upper(inside[i]) == 'P' && is_digit(inside[i + 1]) && !is_name(inside[i - 1])) return true;
  return false;
}

/// Whether text in square brackets computes something, as "#2+1" and "SIN[#1]" do: it reads a
/// variable and has no words but those of expressions. "SETUP #1" has one.
bool computes(std::string_view text) {
  constexpr std::string_view kOperators[] = {"AND", "OR", "XOR", "MOD", "EQ",
                                             "NE",  "GT", "GE",  "LT",  "LE"};
  bool reads = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char next = i + 1 < text.size() ? text[i + 1] : '\0';
    reads = reads || (text[i] == '#' && (is_digit(next) || next == '<' || next == '['));
    if (text[i] == '<') i = std::min(text.find('>', i), text.size());
    if (i >= text.size() || !is_letter(text[i])) continue;
    const std::size_t from = i;
    while (i + 1 < text.size() && is_letter(text[i + 1])) ++i;
    const std::string word = upper_case(text.substr(from, i + 1 - from));
    const std::size_t behind = text.find_first_not_of(" \t", i + 1);
    if (behind != text.npos && text[behind] == '[') continue;
    if (std::ranges::find(kOperators, word) == std::end(kOperators)) return false;
  }
  return reads;
}

// Whether a bracket behind this code belongs to a call or a value: "SIN(", "R1=(". Behind a number
// or a blank it begins a comment: "X10(SLOT)", "X10 (SLOT)".
bool takes_bracket(std::string_view code) {
  if (code.size() < 2 || is_digit(code.back())) return false;
  return code.back() == '=' || (is_name(code.back()) && is_letter(code[code.size() - 2]));
}

}  // namespace

bool looks_like_block(std::string_view text) {
  bool any = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == ' ' || text[i] == ';' || text[i] == '\t') continue;
    if (!is_letter(text[i]) || i + 1 >= text.size() || !starts_number(text[i + 1])) return false;
    while (i + 1 < text.size() && starts_number(text[i + 1])) ++i;
    any = true;
  }
  return any;
}

bool names_okuma_program(std::string_view line, std::size_t at) {
  if (at + 1 >= line.size() || upper(line[at]) != 'O' || !is_letter(line[at + 1])) return false;
  std::size_t end = at;
  while (end < line.size() && (is_letter(line[end]) || is_digit(line[end]))) ++end;
  const std::size_t rest = line.find_first_not_of(" \t\r", end);
  return rest == line.npos || line[rest] == '(';
}

std::string_view bracketed_name(std::string_view line, std::size_t at) {
  const std::size_t close = at < line.size() && line[at] == '<' ? line.find('>', at) : line.npos;
  if (close == line.npos || close < at + 2 || close > at + kLongestProgramName + 1) return {};
  const std::string_view name = line.substr(at + 1, close - at - 1);
  for (const char c : name)
    if (!is_name(c) && c != '-' && c != '+' && c != '.') return {};
  return name;
}

bool calls_lap(std::string_view code) {
  for (const std::string_view g : {"G85 N", "G86 N", "G87 N"}) {
    const std::size_t at = code.find(g);
    const std::size_t name = at + g.size();
    if (at != code.npos && name < code.size() && is_letter(code[name])) return true;
  }
  return false;
}

bool is_remark(std::string_view line, std::size_t from) {
  const std::size_t end = line.find_last_not_of(" \t\r");
  if (end == line.npos || end <= from || line[from] != '[' || line[end] != ']') return false;
  // "[#2+1]" has lost its address.
  return line.find_first_not_of(" \t") == from && !computes(line.substr(from + 1, end - from - 1));
}

void scan_line(std::string_view line, LineScan& out) {
  out.code.clear();
  out.comment = {};
  out.comment_kind = '\0';
  out.ends_block = false;
  const std::size_t first = line.find_first_not_of(" \t");
  if (first != line.npos && is_remark(line, first)) {
    out.comment = line.substr(first + 1, line.rfind(']') - first - 1);
    out.comment_kind = '[';
    return;
  }
  int depth = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == '/' && depth == 0 && line.substr(i).starts_with("//")) {
      out.comment = line.substr(i + 2);
      out.comment_kind = '/';
      return;
    }
    if (c == ';' && depth == 0) {
      const std::string_view rest = line.substr(i + 1);
      if (rest.find_first_not_of(" \t;") == std::string_view::npos) {
        out.ends_block = !out.code.empty();
        return;
      }
      if (looks_like_block(rest) && !out.code.empty()) {
        out.ends_block = true;
        out.code += ' ';
        continue;
      }
      if (out.comment.empty()) out.comment = rest;
      out.comment_kind = ';';
      return;
    }
    if (c == '(' && depth == 0 && !takes_bracket(out.code) &&
        !holds_parameter(out.code, line.substr(i))) {
      const std::size_t close = line.find(')', i);
      if (close == std::string_view::npos) return;
      out.comment = line.substr(i + 1, close - i - 1);
      out.comment_kind = '(';
      i = close;
      continue;
    }
    if (c == '(') ++depth;
    if (c == ')' && depth > 0) --depth;
    out.code += upper(c);
  }
}

bool names_program(std::string_view line, std::size_t at) {
  std::size_t i = at + 1;
  while (i < line.size() && is_digit(line[i])) ++i;
  if (i == at + 1) return false;
  i = line.find_first_not_of(" \t\r", i);
  return i == std::string_view::npos || line[i] == '(' || line[i] == ';';
}

bool read_plain(std::string_view line, PlainLine& out) {
  out = {};
  for (std::size_t i = 0; i < line.size();) {
    const std::size_t from = i;
    const char c = line[i++];
    if (c == ' ' || c == '\t') continue;
    const std::size_t digits = i;
    while (i < line.size() && starts_number(line[i])) ++i;
    const std::string_view number = line.substr(digits, i - digits);
    if (number.empty()) return false;
    if (c == 'G') {
      const bool apart = from == 0 || line[from - 1] == ' ' || line[from - 1] == '\t';
      const bool known = number.size() == 1 || (number.size() == 2 && number[0] == '0');
      if (!apart || !known || number.back() < '0' || number.back() > '3') return false;
      (number.back() < '2' ? out.line : out.arc) = true;
    } else if (c == 'Y' || c == 'J') {
      out.second = true;
    } else if (c == 'Z' || c == 'K') {
      out.third = true;
    } else if (c == 'R') {
      out.radius = true;
    } else if (!(c == 'X' || c == 'I' || c == 'F' || c == 'S' || (c == 'N' && from == 0))) {
      return false;
    }
  }
  return true;
}

bool has(std::string_view text, std::string_view token) {
  for (std::size_t i = text.find(token); i != std::string_view::npos; i = text.find(token, i + 1))
    if (i == 0 || !(is_letter(text[i - 1]) || text[i - 1] == '_')) return true;
  return false;
}

bool has_whole_word(std::string_view comment, std::string_view word) {
  for (std::size_t i = comment.find(word); i != comment.npos; i = comment.find(word, i + 1)) {
    const std::size_t end = i + word.size();
    if ((i == 0 || !is_letter(comment[i - 1])) &&
        (end >= comment.size() || !is_letter(comment[end])))
      return true;
  }
  return false;
}

bool has_word(std::string_view text, std::string_view word) {
  for (std::size_t i = text.find(word); i != std::string_view::npos; i = text.find(word, i + 1)) {
    const std::size_t end = i + word.size();
    if (i > 0 && is_letter(text[i - 1])) continue;
    if (end >= text.size() || !(is_digit(text[end]) || text[end] == '.')) return true;
  }
  return false;
}

bool has_axis(std::string_view text, char axis) {
  for (std::size_t i = text.find(axis); i != std::string_view::npos; i = text.find(axis, i + 1)) {
    if (i > 0 && (is_letter(text[i - 1]) || text[i - 1] == '_')) continue;
    std::size_t n = i + 1;
    while (n < text.size() && text[n] == ' ') ++n;
    if (n >= text.size()) continue;
    const char next = text[n];
    if (starts_number(next) || next == '=' || next == '#' || next == '[' || next == '(')
      return true;
    if (next == 'P' && n + 1 < text.size() && is_digit(text[n + 1]) && n == i + 1) return true;
  }
  return false;
}

}  // namespace mrsim
