// Reads the words of a block one after another. The first character says what a word is; words of
// one control alone go to their own reader. Private to src/interp.
#pragma once

#include "interp/text/okuma_words.h"
#include "interp/text/sinumerik_words.h"
#include "interp/text/special_words.h"
#include "interp/text/strange_text.h"

namespace mrsim {

class WordReader : public LineParser {
 public:
  explicit WordReader(ParsedLine& line)
      : LineParser(line), sinumerik_(line), okuma_(line), special_(line), strange_(line) {}
  void set_skip(unsigned levels) { skip_ = levels; }

  /// Reads on to the end of the block. False when nothing is left on the line.
  bool read(Block& block);

 private:
  enum class Step { more, end_of_block };

  void plain_words(Block& block);
  Step step(Block& block);
  Step letter_step(Block& block);
  void end_sign();
  bool head_of_block(Block& block);
  std::size_t end_of_wait() const;
  bool skip_rest(Block& block);
  void warn_of_division(const Block& block, std::size_t end);
  void letter_word(Block& block);
  bool exponent_follows(const Block& block, char address) const;
  void numbered_word(Block& block, std::size_t from, char c);
  bool ends_block() const;
  void slashes(Block& block);
  bool is_end_sign() const;
  bool ends_tape(const Block& block) const;
  bool is_directive() const;
  void read_comment(Block& block, char close);
  void end_of_outer_comment(Block& block);
  void bare_number(Block& block);

  SinumerikWords sinumerik_;
  OkumaWords okuma_;
  SpecialWords special_;
  StrangeText strange_;
  unsigned skip_ = 0;  ///< levels of block skip in force
};

}  // namespace mrsim
