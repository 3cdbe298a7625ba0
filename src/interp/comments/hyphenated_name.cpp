#include "interp/comments/hyphenated_name.h"

#include "interp/comments/tool_kind.h"

namespace mrsim {
namespace {

constexpr double kFewNumbers = 4;

// Whether token i is a hyphen with no blank on either side.
bool joins(const std::vector<CommentToken>& tokens, std::size_t i) {
  return i + 1 < tokens.size() && tokens[i].is("-") && tokens[i].glued && tokens[i + 1].glued;
}

bool is_running_number(const CommentToken& t) {
  return t.text.front() == '0' ||
         (!t.decimals && !t.fraction && t.unit == 0 && t.value < kFewNumbers);
}

// Marks the last number of "SPOT-10-90" as the angle of the point.
void mark_angle(const ToolKind& kind, std::vector<CommentToken>& tokens, std::size_t at) {
  using enum ToolTrade;
  const bool drill = kind.trade == twist_drill;
  const bool pointed = drill || kind.trade == spot_drill || kind.trade == center_drill ||
                       kind.trade == countersink || kind.trade == chamfer_mill;
  if (!pointed || at + 1 != tokens.size() || !tokens[at].is_number()) return;
  CommentToken& last = tokens[at];
  const bool whole = !last.decimals && !last.fraction && last.unit == 0;
  for (const double usual : {60.0, 82.0, 90.0, 118.0, 120.0, 135.0, 140.0, 142.0, 145.0})
    if (whole && last.value == usual && (!drill || usual > 90)) last.angle = true;
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
  mark_angle(kind, tokens, kind.end + 1);
}

}  // namespace mrsim
