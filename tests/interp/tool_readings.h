// Tables of comments and the tools that programs in mm or inches make of them.
#pragma once

#include "core/numbers/units.h"
#include "interp/comments/tool_comment.h"
#include "interp/comments/tool_hint.h"

#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace mrsim::testing {

// "drill 6.35, point 118": what a program in this unit makes of the comment; "? ..." why it asks;
// "-": the comment is not about a tool.
inline std::string told(const std::string& comment, double unit, bool lathe) {
  static constexpr const char* kNames[] = {"endmill", "ballmill", "bullmill", "chamfer",  "taper",
                                           "drill",   "tslot",    "lollipop", "barrel",   "form",
                                           "turning", "grooving", "boring",   "threading"};
  const ToolHint hint = read_tool_comment(comment);
  if (!hint && hint.id.empty()) return "-";
  Tool tool;
  std::string why;
  if (!fill_tool(hint, unit, lathe, tool, why)) return "? " + why;
  std::string out = kNames[static_cast<std::size_t>(tool.type)];
  const auto add = [&](const char* name, double value) {
    if (value > 0) out += fmt::format("{}{:.5g}", name, value);
  };
  add(" ", tool.diameter);
  add(", corner ", tool.corner_radius);
  add(", point ", degrees(tool.tip_angle));
  add(", side ", degrees(tool.taper_angle));
  add(", tip ", tool.tip_diameter);
  add(", width ", tool.width);
  add(", flutes ", tool.flute_length);
  add(", orientation ", tool.tip);
  if (!is_turning(tool.type) || tool.type == ToolType::grooving) return out;
  add(", insert ", degrees(tool.insert_angle));
  add(", nose ", tool.nose_radius);
  return out;
}

enum In : std::uint8_t { mm, inch, lathe_mm, lathe_inch };

struct Reading {
  In program;
  const char *comment, *tool;
};

inline void expect_readings(const std::vector<Reading>& rows) {
  for (const Reading& row : rows) {
    const bool inches = row.program == inch || row.program == lathe_inch;
    EXPECT_EQ(told(row.comment, inches ? kMmPerInch : 1, row.program >= lathe_mm), row.tool)
        << row.comment;
  }
}

}  // namespace mrsim::testing
