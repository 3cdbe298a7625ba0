// Finds the words of control structures in one line of text, by the rules of each control.
// Does not match them with one another (ProgramOutline does that) or read expressions.
#pragma once

#include "interp/language/program_outline.h"

#include <string>
#include <string_view>
#include <vector>

namespace mrsim {

struct FoundWord {
  FlowWord word = FlowWord::none;
  std::size_t at = 0, behind = 0;
  std::string name;                ///< loop number, label, name of a subprogram; upper case
  FlowWord ends = FlowWord::none;  ///< see FlowEntry
  const char* fault = nullptr;     ///< what is wrong with the block, whether it runs or not
  int skip = -1;                   ///< see FlowEntry
};

/// Appends the words that stand in the line.
void scan_flow(OutlineForm form, std::string_view line, std::vector<FoundWord>& out);

/// Where the words of a block begin behind blanks, "/2" and "N10". `number`: the N word, or -1.
std::size_t behind_number(std::string_view line, std::size_t from, long& number);

/// FANUC: the place behind the blanks and comments at `p`.
std::size_t behind_comments(std::string_view line, std::size_t p);

/// FANUC: the end of the block at `p`. Where a ";" ends the line, that is the next ";" outside of
/// comments; else the end of the line, because a comment begins behind ";" there.
std::size_t end_of_block(std::string_view line, std::size_t p);

/// FANUC: whether only blanks and comments stand between `p` and the end of the block.
bool ends_block(std::string_view line, std::size_t p);

/// The bracket that closes the one at `open`, [ or (, or npos.
std::size_t closing_bracket(std::string_view line, std::size_t open);

/// Reads the O word at `p`: its name (upper case, without blanks; empty for an expression). `p`
/// ends behind it. False: no O word.
bool oword_name(std::string_view line, std::size_t& p, std::string& name);
/// The word behind an O word, in which blanks mean nothing ("end sub").
std::string oword_keyword(std::string_view line, std::size_t& p);
/// The first 16 letters at `p` behind blanks, upper case; `p` ends behind all of them.
std::string letters_at(std::string_view line, std::size_t& p);

}  // namespace mrsim
