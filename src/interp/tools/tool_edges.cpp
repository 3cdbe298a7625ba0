#include "interp/tools/tool_edges.h"

#include "core/words/tool_types.h"

#include <cmath>
#include <string>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr double kSameNose = 0.01;  // mm: the rounding of a radius in inches with three decimals

}  // namespace

// T0303 and T0313 call one tool. A blade often has an offset for each of its corners, and no
// program says which is which.
void ToolEdges::compare_offset(const Word& word, const Tool* used) {
  const long number = static_cast<long>(word.value), offset = number % 100;
  if (!lathe() || !is(Dialect::fanuc) || word.string || number < 100 || number > 9999 ||
      offset == 0 || tool_.current == fmt::format("{}", number))
    return;
  const auto [at, first] = offsets_.emplace(tool_.current, offset);
  if (first || at->second == offset || !used || used->type != ToolType::grooving) return;
  tell_second(text_of(word), fmt::format("{}", number), *used, word);
}

void ToolEdges::tell_second(const std::string& offset, const std::string& id, const Tool& tool,
                            const Word& where) {
  reporter_.once(
      Severity::warning, "second-offset",
      fmt::format("{0} is a second offset of blade {1}: its point is read as before. Where it is "
                  "the other corner, these cuts lie {2:g} mm beside: say so with --tool "
                  "{3}=grooving:w={2:g},tip=..",
                  offset, tool.id, tool.width, id),
      where, id);
}

// "3.D2" for D2 of a SINUMERIK lathe, where the tool table has it: an edge with a point of its own.
std::string ToolEdges::id_at_edge() const {
  if (!lathe() || !is(Dialect::sinumerik) || modal_.edge < 2) return tool_.current;
  std::string id = fmt::format("{}.D{}", tool_.current, modal_.edge);
  return data_.given(id) ? id : tool_.current;
}

// D2 of a blade is often its right corner.
void ToolEdges::compare_edge(const Tool& tool, const Word& where) {
  if (!lathe() || !is(Dialect::sinumerik) || modal_.edge < 1 || tool.type != ToolType::grooving ||
      tool.id != tool_.current)
    return;
  const auto [at, first] = offsets_.emplace(tool_.current, modal_.edge);
  if (first || at->second == modal_.edge) return;
  const std::string edge = fmt::format("D{}", modal_.edge);
  tell_second(edge, fmt::format("{}.{}", tool_.current, edge), tool, where);
}

// R of G10 P1 is the nose radius of the offset that T0101 calls.
void ToolEdges::compare_nose(const Tool& tool, const Word& where) {
  const auto told = control_.told_noses.find(static_cast<long>(tool_.written) % 100);
  if (told == control_.told_noses.end() || !is_turning(tool.type)) return;
  if (std::abs(told->second - nose_radius(tool)) < kSameNose) return;
  reporter_.once(
      Severity::warning, "nose-differs",
      fmt::format("G10 gives tool {0} a nose radius of {1:.4g} mm, its data say {2:.4g}, which "
                  "cuts here: where {1:.4g} is right, say --tool {0}=turning:insert=..,r={1:.4g}",
                  tool.id, told->second, nose_radius(tool)),
      where, tool.id);
}

// Q of G10 P1 and $TC_DP2 are the orientation of the tip, which counts where the tool's data leave
// it open.
void ToolEdges::settle_tip(Tool& tool, const Word& where) {
  const auto written = static_cast<long>(tool_.written);
  const bool whole = is(Dialect::ngc) || is(Dialect::sinumerik);  // T0101 has the offset 1
  const auto told = control_.told_tips.find(whole ? written : written % 100);
  if (told == control_.told_tips.end() || !is_turning(tool.type) || tool.tip_is_nose_centre) return;
  if (tool.tip == 0) {
    if (told->second != tip_orientation(tool))
      tool.origin += fmt::format("; tip orientation {} by the program", told->second);
    tool.tip = told->second;
  }
  if (tool.tip == told->second) return;
  reporter_.once(
      Severity::warning, "nose-differs",
      fmt::format("{3} gives tool {0} the tip orientation {1}, its data say {2}, which "
                  "counts here: where {1} is right, say --tool {0}=..,tip={1}",
                  tool.id, told->second, tool.tip, is(Dialect::sinumerik) ? "$TC_DP2" : "G10"),
      where, tool.id + " tip");
}

}  // namespace mrsim
