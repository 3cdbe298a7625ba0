#include "interp/comments/shank_words.h"

#include "interp/comments/comment_words.h"

namespace mrsim {

bool is_shank(const CommentView& view, std::size_t i) {
  return view.is_one(i, {"SHANK", "SHK", "SHAFT", "SCHAFT"});
}

bool is_cut(const CommentView& view, std::size_t i) {
  if (!view.is_one(i, {"CUT", "CUTTING", "CUTTER", "HEAD", "KOPF", "SCHNEIDE"})) return false;
  const WordRole next = view.word(i + 1) ? comment_word(view[i + 1].text).role : WordRole::none;
  return next != WordRole::other && next != WordRole::length && next != WordRole::work;
}

std::size_t size_of_shank(const CommentView& view, std::size_t i) {
  std::size_t at = view.behind(i);
  if (view.is_one(at, {"D", "DIA", "DIAM", "DIAMETER", "DURCHMESSER", "~"})) at = view.behind(at);
  return view.has(at) && view[at].is_number() ? at : CommentView::kNone;
}

bool cuts_behind_shank(const CommentView& view, std::size_t i, std::size_t number) {
  if (i == 0 || !is_shank(view, i) || !is_cut(view, number + 1) || !view[i - 1].is_number())
    return false;
  return !(i > 1 && view.is_one(i - 2, {"T", "TOOL"}));  // "T1 SHANK"
}

bool is_size_of_shank(const CommentView& view, std::size_t number) {
  if (!is_shank(view, number + 1)) return false;
  const std::size_t other = size_of_shank(view, number + 1);
  return other == CommentView::kNone || is_cut(view, other + 1);
}

}  // namespace mrsim
