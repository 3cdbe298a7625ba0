#include "interp/text/hyphenated_name.h"

#include "interp/text/tool_kind.h"

namespace mrsim {
namespace {

constexpr double kFewNumbers = 4;

// A hyphen with no blank on either side.
bool joins(const std::vector<CommentToken>& tokens, std::size_t i) {
  return i + 1 < tokens.size() && tokens[i].is("-") && tokens[i].glued && tokens[i + 1].glued;
}

bool is_running_number(const CommentToken& t) {
  return t.text.front() == '0' ||
         (!t.decimals && !t.fraction && t.unit == 0 && t.value < kFewNumbers);
}

}  // namespace

void part_hyphenated_name(std::vector<CommentToken>& tokens) {
  const std::vector<ToolKind> kinds = find_tool_kinds(tokens);
  if (kinds.empty()) return;
  const ToolKind& kind = kinds.front();
  const bool thread = kind.trade == ToolTrade::tap || kind.trade == ToolTrade::thread_mill;
  if (thread || !joins(tokens, kind.end)) return;  // "TAP-1/4-20"
  const CommentToken& size = tokens[kind.end + 1];
  if (!size.is_number() || is_running_number(size)) return;
  for (std::size_t i = kind.end; i < tokens.size() && (i == kind.end || tokens[i].glued); ++i) {
    if (!joins(tokens, i)) continue;
    tokens.erase(tokens.begin() + static_cast<std::ptrdiff_t>(i));
    tokens[i].glued = false;
  }
}

}  // namespace mrsim
