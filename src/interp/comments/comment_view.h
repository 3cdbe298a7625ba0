// The tokens of a comment about a tool, and which of them have been explained.
#pragma once

#include "core/numbers/units.h"
#include "interp/comments/comment_tokens.h"
#include "interp/comments/tool_comment.h"

#include <cstddef>
#include <initializer_list>
#include <string_view>
#include <utility>
#include <vector>

namespace mrsim {

class CommentView {
 public:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  explicit CommentView(std::vector<CommentToken> tokens)
      : tokens_(std::move(tokens)), taken_(tokens_.size(), false) {}

  std::size_t size() const { return tokens_.size(); }
  const CommentToken& operator[](std::size_t i) const { return tokens_[i]; }
  const std::vector<CommentToken>& tokens() const { return tokens_; }
  bool has(std::size_t i) const { return i < tokens_.size(); }
  bool word(std::size_t i) const { return has(i) && tokens_[i].kind == CommentToken::Kind::word; }
  bool is(std::size_t i, std::string_view what) const { return has(i) && tokens_[i].is(what); }
  /// Whether token i is one of the words.
  bool is_one(std::size_t i, std::initializer_list<std::string_view> words) const;
  bool glued(std::size_t i) const { return has(i) && tokens_[i].glued; }

  bool taken(std::size_t i) const { return has(i) && taken_[i]; }
  void take(std::size_t i) { taken_[i] = true; }
  /// Marks the tokens [first, end) as explained.
  void take(std::size_t first, std::size_t end);

  /// A number that nothing has explained yet.
  bool number(std::size_t i) const { return has(i) && tokens_[i].is_number() && !taken_[i]; }
  /// A number without a point, a fraction, a unit or a degree sign.
  bool whole(std::size_t i) const;
  /// Whether the number at i counts parts or their sides: "PART 7", "SIDE 2".
  bool numbers_work(std::size_t i) const;
  /// A number that may be a size: not behind a letter, a "#", an "=" or a sign of its own.
  bool is_size(std::size_t i) const;
  /// A bare number that nothing has explained, as angles of tools are: "90", "118".
  bool may_be_angle(std::size_t i) const;
  /// The place behind the name at i, past "=", ":" or "-": that of 10. in "DIA. - 10.".
  std::size_t behind(std::size_t i) const;
  /// The place of the number there; kNone: there is none, or it is an angle.
  std::size_t value_behind(std::size_t i) const;

  void say_inches(std::size_t i) { tokens_[i].unit = kMmPerInch; }
  /// The number of token i as a length, with its unit if it has one.
  ToolLength length(std::size_t i) const;

 private:
  std::vector<CommentToken> tokens_;
  std::vector<bool> taken_;
};

}  // namespace mrsim
