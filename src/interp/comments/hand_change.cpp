#include "interp/comments/hand_change.h"

#include "core/text_io.h"
#include "interp/comments/comment_tokens.h"
#include "interp/comments/comment_view.h"
#include "interp/comments/tool_kind.h"

#include <algorithm>
#include <cstddef>
#include <string>

namespace mrsim {
namespace {

bool is_order(const CommentView& view, std::size_t i) {
  return view.is_one(i, {"CHANGE",     "INSERT",    "INSTALL",  "LOAD",       "SWITCH",
                         "FIT",        "MOUNT",     "SWAP",     "PUT",        "WECHSEL",
                         "WECHSELN",   "EINSETZEN", "EINLEGEN", "EINSPANNEN", "WERKZEUGWECHSEL",
                         "TOOLCHANGE", "CHANGER",   "MONTER",   "CAMBIAR",    "COLOCAR",
                         "CAMBIO",     "CAMBIARE",  "ZAMENJAJ", "VSTAVI",     "WYMIEN",
                         "ZMIEN"});
}

bool is_tool(const CommentView& view, std::size_t i) {
  return view.is_one(i, {"TOOL", "TOOLS", "BIT", "CUTTER", "WERKZEUG", "OUTIL", "HERRAMIENTA",
                         "UTENSILE", "ORODJE", "NARZEDZIE", "WERKZEUGWECHSEL", "TOOLCHANGE"});
}

// "CHANGE DRILL IF WORN", "CHANGE TOOL OFFSET": the tool stays.
bool is_reserve(const CommentView& view, std::size_t i) {
  return view.is_one(i, {"IF", "CHECK", "WORN", "BROKEN", "DULL", "OFFSET", "OFFSETS", "NO", "NOT",
                         "SETTER", "PROBE", "WEAR"});
}

}  // namespace

bool says_tool_is_changed(std::string_view bytes) {
  constexpr std::size_t kLongest = 200;  // characters of a note to the operator
  const std::string folded = fold_comment(to_utf8(bytes.substr(0, kLongest)));
  const std::vector<CommentToken> tokens = comment_tokens(folded);
  const CommentView view(tokens);
  bool order = false, tool = false;
  for (std::size_t i = 0; i < view.size(); ++i) {
    if (is_reserve(view, i)) return false;
    order |= is_order(view, i);
    tool |= is_tool(view, i);
  }
  if (!order) return false;
  const std::vector<ToolKind> kinds = find_tool_kinds(tokens);
  return tool || std::any_of(kinds.begin(), kinds.end(), [](const ToolKind& kind) {
           return kind.trade != ToolTrade::no_cutter;
         });
}

}  // namespace mrsim
