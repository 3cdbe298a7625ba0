// What all readers of words share: the place in the line, numbers, expressions as values,
// statements of the control's language, faults with their place. Private to src/interp.
#pragma once

#include "interp/text/block.h"
#include "interp/text/language_reader.h"
#include "interp/text/reporter.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace mrsim {

/// The line being read, and how far it is read.
struct ParsedLine {
  ParsedLine(Dialect dialect_in, Reporter& reporter_in)
      : dialect(dialect_in),
        reporter(reporter_in),
        glued_blanks(dialect == Dialect::fanuc || dialect == Dialect::ngc) {}

  Dialect dialect;
  Reporter& reporter;
  LanguageReader* language = nullptr;
  bool glued_blanks;  ///< FANUC, LinuxCNC: blanks mean nothing, even inside a word
  std::string_view text;
  std::size_t position = 0;
};

/// Each reader of words is a class of its own that derives from this one.
class LineParser {
 protected:
  explicit LineParser(ParsedLine& line)
      : dialect_(line.dialect),
        reporter_(line.reporter),
        language_(line.language),
        glued_blanks_(line.glued_blanks),
        line_(line.text),
        p_(line.position) {}

  static constexpr double kLargestNumber = 1e9;
  static constexpr std::size_t kMostWords = 4096;  ///< of a block

  char at(std::size_t i) const { return i < line_.size() ? line_[i] : '\0'; }
  bool blank(char c) const {  // SINUMERIK's & is one, too
    return c == ' ' || c == '\t' || c == '\r' || (c == '&' && dialect_ == Dialect::sinumerik);
  }
  void skip_blanks();
  void push(Block& block, Word& word, std::size_t from);
  /// The block's number, read from `from` to p_; a second one shows a lost end of line.
  void block_number(Block& block, std::size_t from);

  /// Gives `word` the value of a number of at most 15 digits, as nearly all are, and whether it has
  /// a point. Returns the place behind it; null for any other number.
  static const char* read_digits(const char* p, const char* end, Word& word);
  bool number(Block& block, Word& word, bool exponent);
  bool plain_number(Word& word, bool exponent);

  bool statement(Block& block, std::size_t from);
  void assignment(Block& block, std::size_t from);
  bool expression(Block& block, Word& word, bool whole);
  bool expression_follows(std::size_t from) const;
  bool operator_follows() const;

  void fault(Block& block, const char* code, const std::string& text, std::size_t from,
             std::size_t to);
  void unsupported(Block& block, std::string_view word, std::string_view what, std::size_t from);
  std::string alarm(const char* fanuc, const char* sinumerik = nullptr) const;

  const Dialect dialect_;
  Reporter& reporter_;
  LanguageReader* const& language_;  ///< null: expressions and assignments are errors
  const bool glued_blanks_;
  std::string_view& line_;
  std::size_t& p_;

 private:
  bool number_slow(Block& block, Word& word, std::size_t from, bool exponent);
};

}  // namespace mrsim
