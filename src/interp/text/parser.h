// Characters to blocks: one line of text holds one block, or several (FANUC ";", CODESYS "N").
// Rules of one control alone are classes of their own. Every fault is reported at its character,
// and the rest of the block is still read, so that one run shows all faults.
#pragma once

#include "interp/text/line_parser.h"

#include <cstddef>
#include <memory>

namespace mrsim {

class WordReader;

class Parser {
 public:
  Parser(Dialect dialect, Reporter& reporter);
  ~Parser();
  Parser(const Parser&) = delete;
  Parser& operator=(const Parser&) = delete;

  Dialect dialect() const { return line_.dialect; }
  /// Sets the reader of expressions and assignments; without one they are errors.
  void set_language(LanguageReader* language) { line_.language = language; }
  /// Sets the levels of block skip in force, a bit each: what follows such a level's slash is not
  /// read.
  void set_skip(unsigned levels);

  /// Reads the block that starts at `position` of block.line and moves `position` behind it.
  /// False when nothing is left on the line.
  bool next(Block& block, std::size_t& position);

 private:
  ParsedLine line_;
  std::unique_ptr<WordReader> words_;
};

}  // namespace mrsim
