#include "interp/comments/comment_view.h"

#include <algorithm>

namespace mrsim {

bool CommentView::is_one(std::size_t i, std::initializer_list<std::string_view> words) const {
  return has(i) && std::any_of(words.begin(), words.end(),
                               [&](std::string_view w) { return tokens_[i].is(w); });
}

void CommentView::take(std::size_t first, std::size_t end) {
  for (std::size_t i = first; i < end; ++i) taken_[i] = true;
}

bool CommentView::whole(std::size_t i) const {
  if (!has(i) || !tokens_[i].is_number()) return false;
  const CommentToken& t = tokens_[i];
  return !t.decimals && !t.fraction && t.unit == 0 && !t.angle;
}

bool CommentView::numbers_work(std::size_t i) const {
  return i > 0 && is_one(i - 1, {"HOLE", "HOLES", "OP", "PART", "STEP", "SIDE", "FIXTURE", "VISE",
                                 "PASS", "JOB", "POS", "FILE", "SHEET"});
}

bool CommentView::is_size(std::size_t i) const {
  if (!number(i) || tokens_[i].angle || !(tokens_[i].value > 0)) return false;
  if (glued(i + 1) && is(i + 1, "-") && number(i + 2) && glued(i + 2))
    return tokens_[i].fraction || tokens_[i].unit > 0;  // "1/4-20" is a thread
  if (i == 0) return true;
  const CommentToken& before = tokens_[i - 1];
  const bool named = before.is("=") && i > 1 &&
                     ((tokens_[i - 2].is_number() && taken_[i - 2]) || tokens_[i - 2].is("TOOL"));
  if (named) return true;  // "T1 = 6mm endmill"
  if (is_one(i - 1, {"#", "=", "NO", "NR", "NUMBER"})) return false;
  if (numbers_work(i) && whole(i)) return false;
  if ((before.is("-") || before.is("+")) && tokens_[i].glued) return false;
  return !(before.kind == CommentToken::Kind::word && tokens_[i].glued);
}

ToolLength CommentView::length(std::size_t i) const {
  const bool letter_point = word(i - 1) && tokens_[i].glued && tokens_[i].text.starts_with('.');
  const CommentToken& t = tokens_[i];
  return {t.value, t.unit, t.fraction, letter_point, t.inch_style()};
}

std::size_t CommentView::behind(std::size_t i) const {
  std::size_t at = i + 1;
  while (is_one(at, {"=", ":", "-"})) ++at;
  return at;
}

std::size_t CommentView::value_behind(std::size_t i) const {
  const std::size_t at = behind(i);
  return number(at) && !tokens_[at].angle ? at : kNone;
}

bool CommentView::may_be_angle(std::size_t i) const {
  if (!number(i) || !whole(i) || !is_size(i)) return false;
  constexpr double kUsual[] = {45, 60, 82, 90, 118, 120, 135, 140};
  return std::find(std::begin(kUsual), std::end(kUsual), tokens_[i].value) != std::end(kUsual);
}

}  // namespace mrsim
