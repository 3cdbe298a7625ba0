#include "interp/language/flow_scan.h"

#include "core/words/tool_number.h"
#include "interp/language/stray_words.h"
#include "interp/text/characters.h"
#include "interp/text/line_scan.h"

#include <algorithm>
#include <utility>

namespace mrsim {
namespace {

std::size_t skip_blanks(std::string_view line, std::size_t p) {
  while (p < line.size() && (line[p] == ' ' || line[p] == '\t' || line[p] == '\r')) ++p;
  return p;
}

char at(std::string_view line, std::size_t p) { return p < line.size() ? line[p] : '\0'; }

std::string digits_at(std::string_view line, std::size_t& p) {
  p = skip_blanks(line, p);
  const std::size_t from = p;
  while (is_digit(at(line, p))) ++p;
  return std::string(line.substr(from, p - from));
}

struct Keyword {
  std::string_view name;
  FlowWord word;
  FlowWord ends = FlowWord::none;  ///< the kind of loop that it ends
};

constexpr Keyword kOwords[] = {
    {"SUB", FlowWord::sub},
    {"ENDSUB", FlowWord::sub_end},
    {"RETURN", FlowWord::sub_return},
    {"CALL", FlowWord::call},
    {"IF", FlowWord::branch},
    {"ELSEIF", FlowWord::branch_else_if},
    {"ELSE", FlowWord::branch_else},
    {"ENDIF", FlowWord::branch_end},
    {"WHILE", FlowWord::loop_while},
    {"ENDWHILE", FlowWord::loop_end, FlowWord::loop_while},
    {"DO", FlowWord::loop_do},
    {"REPEAT", FlowWord::loop_repeat},
    {"ENDREPEAT", FlowWord::loop_end, FlowWord::loop_repeat},
    {"BREAK", FlowWord::loop_break},
    {"CONTINUE", FlowWord::loop_continue},
};

constexpr Keyword kMacroBranches[] = {
    {"IF", FlowWord::branch},
    {"ELSEIF", FlowWord::branch_else_if},
    {"ELSE", FlowWord::branch_else},
    {"ENDIF", FlowWord::branch_end},
};

constexpr Keyword kSinumerikWords[] = {
    {"IF", FlowWord::branch},
    {"ELSE", FlowWord::branch_else},
    {"ENDIF", FlowWord::branch_end},
    {"WHILE", FlowWord::loop_while},
    {"ENDWHILE", FlowWord::loop_end, FlowWord::loop_while},
    {"FOR", FlowWord::loop_for},
    {"ENDFOR", FlowWord::loop_end, FlowWord::loop_for},
    {"LOOP", FlowWord::loop_forever},
    {"ENDLOOP", FlowWord::loop_end, FlowWord::loop_forever},
    {"REPEAT", FlowWord::loop_repeat},
    {"UNTIL", FlowWord::loop_until, FlowWord::loop_repeat},
};

bool has_jump(std::string_view rest) {
  bool quoted = false;
  for (std::size_t i = 0; i < rest.size(); ++i) {
    if (rest[i] == '"') quoted = !quoted;
    if (quoted) continue;
    if (rest[i] == ';') return false;
    const bool starts = i == 0 || !is_name(rest[i - 1]);
    if (starts && upper(rest[i]) == 'G' && upper_case(rest.substr(i, 4)) == "GOTO") return true;
  }
  return false;
}

// A part of a structure at a place where no control looks for it.
FoundWord stray(std::size_t at) {
  FoundWord found;
  found.at = at;
  if (at != std::string_view::npos)
    found.fault =
        "this stands behind words, where the control does not look for it: write it into "
        "a block of its own";
  return found;
}

bool ends_here(std::string_view line, std::size_t p) {
  p = skip_blanks(line, p);
  return p >= line.size() || line[p] == ';';
}

}  // namespace

std::size_t end_of_block(std::string_view line, std::size_t p) {
  const std::size_t last = line.find_last_not_of(" \t\r");
  if (last == std::string_view::npos || line[last] != ';') return line.size();
  for (; p < line.size() && line[p] != ';'; ++p)
    if (line[p] == '(') {
      p = line.find(')', p);
      if (p == std::string_view::npos) return line.size();
    }
  return p;
}

std::size_t behind_comments(std::string_view line, std::size_t p) {
  for (p = skip_blanks(line, p); at(line, p) == '('; p = skip_blanks(line, p))
    p = std::min(line.find(')', p), line.size() - 1) + 1;
  return p;
}

bool ends_block(std::string_view line, std::size_t p) {
  p = behind_comments(line, p);
  return p >= line.size() || line[p] == ';';
}

std::size_t closing_bracket(std::string_view line, std::size_t open) {
  const char opening = line[open], closing = opening == '[' ? ']' : ')';
  int depth = 0;
  for (std::size_t i = open; i < line.size(); ++i) {
    if (line[i] == opening) ++depth;
    if (line[i] == closing && --depth == 0) return i;
  }
  return std::string_view::npos;
}

std::size_t behind_number(std::string_view line, std::size_t from, long& number) {
  number = -1;
  std::size_t p = skip_blanks(line, from);
  if (at(line, p) == '/') {
    ++p;
    if (is_digit(at(line, p))) ++p;
    p = skip_blanks(line, p);
  }
  if (upper(at(line, p)) != 'N') return p;
  std::size_t q = skip_blanks(line, p + 1);
  if (!is_digit(at(line, q))) return p;
  const std::string digits = digits_at(line, q);
  if (digits.size() <= 9) number = std::stol(digits);
  if (at(line, q) == '.') {  // block numbers of LinuxCNC may have fractions
    ++q;
    digits_at(line, q);
  }
  return skip_blanks(line, q);
}

std::string letters_at(std::string_view line, std::size_t& p) {
  p = skip_blanks(line, p);
  const std::size_t from = p;
  while (is_letter(at(line, p))) ++p;
  return upper_case(line.substr(from, std::min<std::size_t>(p - from, 16)));
}

bool oword_name(std::string_view line, std::size_t& p, std::string& name) {
  name.clear();
  if (upper(at(line, p)) != 'O') return false;
  std::size_t q = skip_blanks(line, p + 1);
  const char c = at(line, q);
  if (c == '<') {
    const std::size_t end = line.find('>', q);
    if (end == std::string_view::npos) return false;
    for (std::size_t i = q + 1; i < end; ++i)
      if (line[i] != ' ' && line[i] != '\t') name += upper(line[i]);
    q = end + 1;
  } else if (is_digit(c)) {
    const std::string digits = digits_at(line, q);
    name = without_leading_zeros(digits);
  } else if (c == '[') {
    const std::size_t end = closing_bracket(line, q);
    if (end == std::string_view::npos) return false;
    q = end + 1;
  } else if (c == '#') {
    ++q;
    while (at(line, q) == '#') ++q;
    const std::size_t end = at(line, q) == '<' ? line.find('>', q) : q;
    if (end == std::string_view::npos) return false;
    if (end > q) q = end + 1;
    while (is_digit(at(line, q))) ++q;
  } else {
    return false;
  }
  p = q;
  return true;
}

std::string oword_keyword(std::string_view line, std::size_t& p) {
  std::string word = letters_at(line, p);
  for (std::size_t q = p; !word.empty() && word.size() < 16;) {
    const std::string more = letters_at(line, q);
    if (more.empty()) break;
    word += more;
    p = q;
  }
  return word;
}

namespace {

// Whether a condition and a THEN with nothing behind it follow an IF or ELSEIF, as in a branch of
// several lines.
bool opens_lines(std::string_view line, std::size_t& p) {
  p = behind_comments(line, p);
  const std::size_t close = at(line, p) == '[' ? closing_bracket(line, p) : std::string_view::npos;
  if (close == std::string_view::npos) return false;
  p = behind_comments(line, close + 1);
  const std::string name = letters_at(line, p);
  return name.size() >= 2 && std::string_view("THEN").starts_with(name) && ends_block(line, p);
}

// Whether the name can only be a misspelt ELSEIF, ELSE or ENDIF: "ELSIF", "ELSEG1", "ENDIFG1".
bool resembles_branch(std::string_view name) {
  const bool abbreviates = name.size() >= 2 && std::string_view("ELSEIF").starts_with(name);
  return abbreviates || name.starts_with("ELS") || name == "ELIF" || name.starts_with("ENDI");
}

// Finds IF, ELSEIF, ELSE and ENDIF, also malformed ones, because a jump must not pass over them.
bool scan_branch(std::string_view line, const std::string& name, FoundWord& found) {
  std::size_t& p = found.behind;
  for (const Keyword& known : kMacroBranches) {
    if (known.name != name) continue;
    const bool asks = known.word == FlowWord::branch || known.word == FlowWord::branch_else_if;
    const bool whole = asks ? opens_lines(line, p) : ends_block(line, p);
    if (known.word != FlowWord::branch || whole) found.word = known.word;
    if (!whole && found.word != FlowWord::none)
      found.fault = asks
                        ? "ELSEIF needs [a condition] and THEN at the end of its block: write what "
                          "is to be done into blocks of their own below it"
                        : "words behind ELSE or ENDIF: write them into a block of their own";
    return true;
  }
  if (!resembles_branch(name)) return false;
  found.word = FlowWord::branch_else_if;
  found.fault =
      "this is neither ELSEIF nor ELSE nor ENDIF: write one of them, with nothing behind "
      "it but the condition and THEN of ELSEIF";
  return true;
}

FoundWord scan_macro_block(std::string_view line, std::size_t p) {
  const char c = upper(at(line, p));
  FoundWord found;
  found.at = p;
  if (c == 'O' || (c == ':' && names_program(line, p))) {
    ++p;
    found.name = digits_at(line, p);
    if (!found.name.empty()) found.word = FlowWord::section;
  } else if (c == 'W' || c == 'D' || c == 'E' || c == 'I') {
    std::string name = letters_at(line, p);
    found.behind = p;
    if (scan_branch(line, name, found)) return found;
    if (name.starts_with("WH") && name.size() <= 5) {
      p = behind_comments(line, p);
      const std::size_t close = at(line, p) == '[' ? closing_bracket(line, p) : p;
      if (close == std::string_view::npos || at(line, p) != '[') return found;
      p = behind_comments(line, close + 1);
      found.word = FlowWord::loop_while;
      name = letters_at(line, p);
    }
    if (name == "DO") {
      if (found.word == FlowWord::none) found.word = FlowWord::loop_do;
    } else if (name == "END" || name == "EN") {
      found.word = FlowWord::loop_end;
    } else {
      found.word = FlowWord::none;
    }
    found.name = digits_at(line, p);
    if (found.name.empty()) found.word = FlowWord::none;
  }
  found.behind = p;
  return found;
}

// The place behind all that may stand before the words of a block: comments, N words and "/2",
// whose level holds for the rest of the line. "//" begins a comment.
std::size_t behind_head(std::string_view line, std::size_t p, int& skip) {
  for (long number = -1;;) {
    p = behind_comments(line, p);
    const char next = at(line, p + 1);
    if (at(line, p) == '/' && next == '/') return p;
    if (at(line, p) == '/' && skip < 0) skip = is_digit(next) ? next - '0' : 0;
    const std::size_t behind = behind_number(line, p, number);
    if (behind == p) return p;
    p = behind;
  }
}

void scan_macro_line(std::string_view line, std::vector<FoundWord>& out) {
  int skip = -1;
  for (std::size_t from = 0; from < line.size(); from = end_of_block(line, from) + 1) {
    long number = -1;
    const std::size_t p = behind_head(line, from, skip);
    FoundWord found = scan_macro_block(line, p);
    found.skip = skip;
    if (found.word == FlowWord::section && p != behind_number(line, from, number)) continue;
    if (found.word == FlowWord::none)
      found = stray(stray_macro_word(line, p, end_of_block(line, p)));
    if (found.word != FlowWord::none || found.fault) out.push_back(std::move(found));
  }
}

void scan_oword_line(std::string_view line, std::vector<FoundWord>& out) {
  long number = -1;
  FoundWord found;
  std::size_t p = found.at = behind_number(line, 0, number);
  if (!oword_name(line, p, found.name)) return;
  const std::string word = oword_keyword(line, p);
  if (word.empty()) found.word = FlowWord::label;
  for (const Keyword& known : kOwords)
    if (known.name == word) {
      found.word = known.word;
      found.ends = known.ends;
    }
  found.behind = p;
  if (found.word != FlowWord::none && found.word != FlowWord::call) out.push_back(std::move(found));
}

void scan_sinumerik_line(std::string_view line, std::vector<FoundWord>& out) {
  long number = -1;
  std::size_t p = behind_number(line, 0, number);
  for (;;) {
    const std::size_t from = p;
    const char c = upper(at(line, p));
    if (!is_letter(c) && c != '_') return;
    while (is_name(at(line, p))) ++p;
    const std::string name = upper_case(line.substr(from, std::min<std::size_t>(p - from, 33)));
    const std::size_t end = skip_blanks(line, p);
    if (at(line, end) == ':') {
      out.push_back({FlowWord::label, from, end + 1, name, FlowWord::none});
      p = skip_blanks(line, end + 1);
      continue;
    }
    for (const Keyword& known : kSinumerikWords) {
      if (known.name != name || at(line, end) == '=') continue;
      if (known.word == FlowWord::branch && has_jump(line.substr(p))) return;
      if (known.word == FlowWord::loop_repeat && !ends_here(line, p)) return;
      out.push_back({known.word, from, p, {}, known.ends});
      return;
    }
    if (FoundWord found = stray(stray_sinumerik_word(line, p)); found.fault)
      out.push_back(std::move(found));
    return;
  }
}

// (SUB 12)
void scan_fagor_line(std::string_view line, std::vector<FoundWord>& out) {
  long number = -1;
  FoundWord found;
  std::size_t p = found.at = behind_number(line, 0, number);
  if (at(line, p) != '(' || letters_at(line, ++p) != "SUB") return;
  found.name = digits_at(line, p);
  if (found.name.empty() || found.name.size() > 9) return;
  found.name = std::to_string(std::stol(found.name));
  p = skip_blanks(line, p);
  if (at(line, p) != ')') return;
  found.behind = p + 1;
  found.word = FlowWord::label;
  out.push_back(std::move(found));
}

// SUBPROGRAM NAME{...}
void scan_codesys_line(std::string_view line, std::vector<FoundWord>& out) {
  long number = -1;
  FoundWord found;
  std::size_t p = found.at = behind_number(line, 0, number);
  if (letters_at(line, p) != "SUBPROGRAM" || is_name(at(line, p))) return;
  found.behind = line.size();
  found.word = FlowWord::section;
  out.push_back(std::move(found));
}

}  // namespace

void scan_flow(OutlineForm form, std::string_view line, std::vector<FoundWord>& out) {
  switch (form) {
    case OutlineForm::macro:
      return scan_macro_line(line, out);
    case OutlineForm::owords:
      return scan_oword_line(line, out);
    case OutlineForm::sinumerik:
      return scan_sinumerik_line(line, out);
    case OutlineForm::fagor:
      return scan_fagor_line(line, out);
    case OutlineForm::codesys:
      return scan_codesys_line(line, out);
  }
}

}  // namespace mrsim
