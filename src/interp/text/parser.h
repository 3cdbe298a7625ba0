// Characters to blocks: one line of text holds one block, or several (FANUC ";", CODESYS "N").
// Rules that a control does not share with the others are classes of their own; every fault is
// reported at its character and the rest of the block is still read, so that one run shows all of
// them.
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
  /// Who reads expressions and assignments; without one they are errors.
  void set_language(LanguageReader* language) { line_.language = language; }
  /// Levels of block skip in force, a bit each: the rest of such a line is not read.
  void set_skip(unsigned levels);

  /// Reads the block that starts at `position` of block.line and moves `position` behind it.
  /// False when nothing is left on the line.
  bool next(Block& block, std::size_t& position);

 private:
  ParsedLine line_;
  std::unique_ptr<WordReader> words_;
};

}  // namespace mrsim
