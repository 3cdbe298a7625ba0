#include "interp/language/bracket_statement.h"

#include "interp/comments/comment_tokens.h"

#include <algorithm>
#include <array>
#include <vector>

namespace mrsim {
namespace {

using Tokens = std::vector<CommentToken>;

bool has(const Tokens& tokens, std::string_view word) {
  return std::any_of(tokens.begin(), tokens.end(),
                     [&](const CommentToken& t) { return t.is(word); });
}

// Whether an address such as N10 or P5 stands there: a letter and a number without a blank between.
bool is_address(const Tokens& tokens, std::size_t at, std::string_view letter) {
  return at + 1 < tokens.size() && tokens[at].is(letter) && tokens[at + 1].is_number() &&
         tokens[at + 1].glued;
}

// Whether N10, N(P1*10) or NP1, the number of a block, stands there.
bool is_block(const Tokens& tokens, std::size_t at) {
  if (is_address(tokens, at, "N") || is_address(tokens, at, "NP")) return true;
  return at + 1 < tokens.size() && tokens[at].is("N") && tokens[at + 1].is("(");
}

// Whether there is a comparison, as in every condition.
bool asks(const Tokens& tokens) {
  const std::array comparisons{"EQ", "NE", "GT", "GE", "LT", "LE"};
  return std::any_of(comparisons.begin(), comparisons.end(),
                     [&](std::string_view word) { return has(tokens, word); });
}

// Whether the statement sets a value of the control's tables: (ORGX54=5), (TOR1=4.98), (GUP 100=2).
bool sets_table(const Tokens& tokens) {
  if (tokens.size() < 4 || !tokens[1].is_number() || !tokens[2].is("=")) return false;
  const std::string_view name = tokens.front().text;
  const std::array tables{"TOR", "TOL", "TOI", "TOK", "GUP", "LUP"};
  return std::ranges::find(tables, name) != tables.end() ||
         (name.size() == 4 && name.starts_with("ORG"));
}

}  // namespace

std::string bracket_statement(std::string_view text) {
  const std::string folded = fold_comment(text);
  const Tokens tokens = comment_tokens(folded);
  if (tokens.empty()) return "";
  if (is_address(tokens, 0, "P") && tokens.size() > 3 && tokens[2].is("="))
    return "P" + std::string(tokens[1].text) + "=";
  const std::string_view first = tokens.front().text;
  if (first == "IF" && (asks(tokens) || has(tokens, "GOTO"))) return "IF";
  if ((first == "RET" || first == "MDOFF") && tokens.size() == 1) return std::string(first);
  const std::array to_block{"GOTO", "RPT"};
  if (std::ranges::find(to_block, first) != to_block.end() && is_block(tokens, 1))
    return std::string(first);
  const std::array to_program{"CALL", "PCALL", "MCALL", "SUB", "EXEC"};
  if (std::ranges::find(to_program, first) != to_program.end() && tokens.size() > 1 &&
      (tokens[1].is_number() || tokens[1].is("(") || is_address(tokens, 1, "P")))
    return std::string(first);
  if (sets_table(tokens)) return std::string(first);
  if (first == "ERROR" && tokens.size() > 1 && tokens[1].is_number()) return "ERROR";
  return "";
}

}  // namespace mrsim
