// Characters to blocks: one line of text holds one block, or several (FANUC ";", CODESYS "N").
// Lexical rules of the four dialects are flags; every fault is reported at its character and the
// rest of the block is still read, so that one run shows all of them.
#pragma once

#include "interp/text/block.h"
#include "interp/text/language_reader.h"
#include "interp/text/reporter.h"

#include <cstddef>
#include <string>

namespace mrsim {

class Parser {
 public:
  Parser(Dialect dialect, Reporter& reporter);
  Dialect dialect() const { return dialect_; }
  /// Who reads expressions and assignments; without one they are errors.
  void set_language(LanguageReader* language) { language_ = language; }
  /// Levels of block skip in force, a bit each: the rest of such a line is not read.
  void set_skip(unsigned levels) { skip_ = levels; }

  /// Reads the block that starts at `position` of block.line and moves `position` behind it.
  /// False when nothing is left on the line.
  bool next(Block& block, std::size_t& position);

 private:
  static constexpr double kLargestNumber = 1e9;
  static constexpr std::string_view kNoHole = "NCYL";  ///< of Okuma: the cycle makes no hole here

  enum class Step { more, end_of_block };

  Step step(Block& block);
  bool head_of_block(Block& block);
  bool skip_rest(const Block& block);
  void letter_word(Block& block);
  void sinumerik_word(Block& block);
  void sinumerik_name(Block& block);
  void label(Block& block, std::size_t from, std::size_t end);
  void short_label(Block& block, std::size_t from);
  bool of_other_axis(std::size_t close) const;
  void array_word(Block& block, std::size_t from, const std::string& name);
  void program_name(Block& block, std::size_t from, std::string_view name);
  void sinumerik_call(Block& block, std::size_t from, std::string_view name);
  bool sinumerik_value(Block& block, Word& word);
  bool zero_follows();
  bool sinumerik_form(Block& block, Word& word);
  bool sinumerik_expression_follows() const;
  bool sinumerik_radix(Word& word);
  void codesys_name(Block& block);
  void jump_label();
  bool block_name(Block& block);
  bool contour_name(Block& block);
  void skip_conditions(Block& block);
  void unknown_word(Block& block, std::size_t from);
  bool macro_word(Block& block);
  bool corner_word(Block& block);
  bool spindle_speed(Block& block, Word& word);
  bool okuma_word(Block& block);
  bool fagor_instruction(Block& block);
  bool okuma_program(Block& block);
  bool program_in_brackets(Block& block);
  bool okuma_pattern(Block& block);
  bool assigns_name() const;
  bool skips_switch(const Block& block);
  bool has_message(const Word& word) const;
  bool statement(Block& block, std::size_t from);
  void assignment(Block& block, std::size_t from);
  bool expression(Block& block, Word& word, bool whole);
  bool expression_follows(std::size_t from) const;
  bool operator_follows() const;
  void check_inner_blanks(std::size_t from);
  bool plain_number(Word& word, bool exponent);
  bool number(Block& block, Word& word, bool exponent);
  bool number_slow(Block& block, Word& word, std::size_t from, bool exponent);
  bool ends_block() const;
  bool is_end_sign() const;
  bool is_directive() const;
  void read_comment(Block& block, char close);
  void bare_number(Block& block);
  void doubt_comment(const Block& block);
  bool zero_as_letter(Block& block);
  void strange_character(Block& block);
  bool grbl_command(Block& block);
  std::string alarm(const char* fanuc, const char* sinumerik = nullptr) const;
  void text_value(Block& block, Word& word);
  void skip_blanks();
  void fault(Block& block, const char* code, const std::string& text, std::size_t from,
             std::size_t to);
  void unsupported(Block& block, std::string_view word, std::string_view what, std::size_t from);
  void push(Block& block, Word& word, std::size_t from);
  char at(std::size_t i) const { return i < line_.size() ? line_[i] : '\0'; }
  bool blank(char c) const {  // SINUMERIK's & too
    return c == ' ' || c == '\t' || c == '\r' || (c == '&' && dialect_ == Dialect::sinumerik);
  }

  Dialect dialect_;
  Reporter& reporter_;
  LanguageReader* language_ = nullptr;
  unsigned skip_ = 0;
  bool glued_blanks_;  ///< FANUC, LinuxCNC: blanks mean nothing, even inside a word
  std::string_view line_;
  std::size_t p_ = 0;
};

/// "; is CR=5 meant?" for a SINUMERIK name that is an address and digits, else empty.
std::string missing_equal_sign(std::string_view name);

}  // namespace mrsim
