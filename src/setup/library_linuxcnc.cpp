// LinuxCNC's tool.tbl: "T1 P1 Z-51.2 D6.35 Q0 ;1/4 end mill", a line a tool.
#include "core/numbers/units.h"
#include "core/text/text_io.h"
#include "core/words/tool_types.h"
#include "setup/library_formats.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

struct Row {
  std::string id, remark;
  double diameter = 0;
  double front = 0, back = 0;  ///< directions of the two edges, degrees from +Z
  int orientation = 0;
};

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

// One word of a row; false for what is no letter with a number.
bool read_word(std::string_view word, Row& row) {
  const char letter = word[0] >= 'a' ? static_cast<char>(word[0] - 32) : word[0];
  std::string_view digits = word.substr(1);
  const bool negative = digits.starts_with('-');
  if (negative || digits.starts_with('+')) digits.remove_prefix(1);
  const std::optional<double> value = parse_number(digits, true);
  if (!value || std::string_view("TPXYZABCUVWDIJQ").find(letter) == std::string_view::npos)
    return false;
  if (letter == 'T') row.id = fmt::format("{:.0f}", *value);
  if (letter == 'D') row.diameter = *value;
  if (letter == 'I') row.front = negative ? -*value : *value;
  if (letter == 'J') row.back = negative ? -*value : *value;
  if (letter == 'Q') row.orientation = static_cast<int>(std::min(*value, 9.0));
  return true;
}

Row read_row(std::string_view line, const std::string& name, int number) {
  Row row;
  while (!line.empty() && is_blank(line.back())) line.remove_suffix(1);
  const std::size_t semicolon = line.find(';');
  if (semicolon != line.npos) {
    row.remark = to_utf8(line.substr(semicolon + 1, 200));
    line = line.substr(0, semicolon);
  }
  while (!line.empty()) {
    if (is_blank(line.front())) {
      line.remove_prefix(1);
      continue;
    }
    std::size_t end = 0;
    while (end < line.size() && !is_blank(line[end])) ++end;
    if (!read_word(line.substr(0, end), row))
      fail_library(name, fmt::format("line {}: \"{}\" is no word of a tool table", number,
                                     to_utf8(line.substr(0, std::min<std::size_t>(end, 40)))));
    line.remove_prefix(end);
  }
  return row;
}

// The direction of an edge as it is on a tool of orientation 2, which lies towards +X and +Z.
double unmirrored(double degrees, int orientation) {
  if (orientation == 1) degrees = 180 - degrees;
  if (orientation == 3 || orientation == 8) degrees = -degrees;
  if (orientation == 4) degrees -= 180;
  return degrees - 360 * std::floor(degrees / 360);
}

// The corner between the edges I and J, and the angle of the steeper one to the feed.
void set_edges(const Row& row, Tool& tool) {
  if (row.orientation == 5 || row.orientation == 7 || row.orientation == 9) return;
  const auto [low, high] =
      std::minmax({unmirrored(row.front, row.orientation), unmirrored(row.back, row.orientation)});
  if (low < 0 || high >= 180 || high - low < 1) return;
  tool.insert_angle = radians(high - low);
  tool.lead_angle = radians(180 - high);
}

}  // namespace

void read_linuxcnc_table(std::string_view text, const std::string& name, ToolLibrary& out) {
  out.format = LibraryFormat::linuxcnc;
  for (int number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const Row row = read_row(text.substr(0, end), name, number);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (row.id.empty()) continue;
    LibraryTool entry;
    entry.remark = row.remark;
    entry.tool.id = row.id;
    entry.tool.origin = fmt::format("{}:{}", name, number);
    entry.tool.diameter = row.diameter;
    if (row.orientation > 0) {
      entry.tool.type = ToolType::turning;
      entry.tool.tip = tip_of_linuxcnc(row.orientation);
      entry.tool.tip_is_nose_centre = row.orientation == 9;
      entry.tool.nose_radius = row.diameter / 2;
      entry.tool.diameter = 0;
      set_edges(row, entry.tool);
    }
    if (row.orientation == 0 && !(row.diameter > 0))
      skip_library_tool(out, row.id, "no diameter");
    else
      add_library_tool(out, std::move(entry), name);
  }
}

}  // namespace mrsim
