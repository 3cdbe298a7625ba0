#include "interp/comments/tool_gauges.h"

#include "core/numbers/units.h"
#include "interp/comments/drill_gauge.h"

#include <string_view>

namespace mrsim {
namespace {

void read_key_number(CommentView& view, const ToolKind& kind, ToolFacts& facts) {
  const std::string_view name = view[kind.first].text;
  if (!name.starts_with("KEY") && !name.starts_with("WOODRUFF")) return;
  const auto key = find_key_number(view, kind.first, kind.end);
  if (!key) return;
  facts.named.push_back({key->inches, kMmPerInch, false});
  facts.width = ToolLength{key->width, kMmPerInch, false};
  view.take(key->first, key->end);
}

void read_centre_gauge(CommentView& view, const ToolKind& kind, ToolFacts& facts) {
  const auto gauge = find_centre_gauge(view, kind.first, kind.end);
  if (!gauge) return;
  facts.gauge = ToolLength{gauge->body, kMmPerInch, false};
  facts.gauge_name = gauge->name;
  facts.pilot = ToolLength{gauge->pilot, kMmPerInch, false};
  facts.disputed_gauge = gauge->disputed;
  view.take(gauge->first, gauge->end);
}

void read_drill_gauge(CommentView& view, const ToolKind& kind, ToolFacts& facts) {
  const auto gauge = find_drill_gauge(view, kind.first, kind.end);
  if (!gauge) return;
  facts.gauge = ToolLength{gauge->inches, kMmPerInch, false};
  facts.gauge_name = gauge->name;
  view.take(gauge->first, gauge->end);
}

}  // namespace

void read_gauges(CommentView& view, ToolFacts& facts) {
  using enum ToolTrade;
  if (!facts.kind()) return;
  const ToolKind kind = *facts.kind();
  if (kind.trade == disc)
    read_key_number(view, kind, facts);
  else if (kind.trade == center_drill)
    read_centre_gauge(view, kind, facts);
  else if (kind.trade == twist_drill || (kind.trade == hole && kind.firm))
    read_drill_gauge(view, kind, facts);
}

}  // namespace mrsim
