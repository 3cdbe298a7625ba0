#include "interp/text/parser.h"

#include "interp/text/word_reader.h"

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr std::size_t kLongestBlock = 512;  // characters, SINUMERIK

}  // namespace

Parser::Parser(Dialect dialect, Reporter& reporter)
    : line_(dialect, reporter), words_(std::make_unique<WordReader>(line_)) {}
Parser::~Parser() = default;

void Parser::set_skip(unsigned levels) { words_->set_skip(levels); }

bool Parser::next(Block& block, std::size_t& position) {
  block.words.clear();
  block.comments.clear();
  block.argument = block.function_name = block.name = block.contour = {};
  block.skip_level = block.inner_skip = -1;
  block.modal_call = false;
  block.statement = Block::kNoStatement;
  block.bad = block.has_number = block.no_hole = false;
  line_.text = block.line;
  line_.position = position;
  if (position == 0 && line_.dialect == Dialect::sinumerik && line_.text.size() > kLongestBlock) {
    block.bad = true;
    line_.reporter.add(
        Severity::error, "block-too-long",
        fmt::format("{} characters, and a block has at most {}", line_.text.size(), kLongestBlock),
        static_cast<int>(kLongestBlock), static_cast<int>(line_.text.size() - kLongestBlock));
  }
  const bool any = words_->read(block);
  position = line_.position;
  return any;
}

}  // namespace mrsim
