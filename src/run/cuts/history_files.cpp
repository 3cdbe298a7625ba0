// A history as a table and as JSON: the same rows in both.

#include "core/numbers/motions.h"
#include "core/numbers/units.h"
#include "core/process/memory_limit.h"
#include "core/text/text_io.h"
#include <mrsim/history.h>

#include <cmath>
#include <map>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace mrsim {
namespace {

// Bytes of a row, of the map of lines and of the text, as measured; a motion has a line at most.
constexpr double kRowMemory = 1000;
constexpr double kCubicCmPerMinute = 60 / 1000.0;  // in a mm^3/s

// What a row is about; what does not apply is empty or 0.
struct Row {
  const char* kind;
  std::string file;
  int line = 0;
  std::size_t motion = 0;  // from 1, as --until counts
  std::string tool;
  Removal removal;
  CutShape shape;
};

std::string tool_id(const Program& program, int tool) {
  return tool < 0 ? std::string() : program.tools[static_cast<std::size_t>(tool)].id;
}

// Motions, lines in the order of files and numbers, tools, the program.
std::vector<Row> rows_of(const Program& program, const CycleTime& time, const History& history) {
  require_memory(2 * kRowMemory * static_cast<double>(history.removed.size()), "--history");
  std::vector<Row> rows;
  struct Sum {
    Removal removal;
    CutShape shape;
  };
  std::map<std::pair<int, int>, Sum> lines;
  std::map<int, CutShape> tools;
  CutShape all;
  for (std::size_t i = 0; i < history.removed.size(); ++i) {
    const Motion& m = program.motions[i];
    if (!is_cut(m)) continue;
    const Removal one = removal_of(program, time, history, i);
    const CutShape shape = history.shapes.empty() ? CutShape{} : history.shapes[i];
    rows.push_back({"motion", program.files[static_cast<std::size_t>(m.file)], m.line, i + 1,
                    tool_id(program, m.tool), one, shape});
    Sum& line = lines[{m.file, m.line}];
    line.removal += one, line.shape += shape;
    tools[m.tool] += shape;
    all += shape;
  }
  for (const auto& [place, sum] : lines)
    rows.push_back({"line", program.files[static_cast<std::size_t>(place.first)], place.second, 0,
                    "", sum.removal, sum.shape});
  for (const ToolRemoval& tool : history.tools)
    rows.push_back({"tool", "", 0, 0, tool_id(program, tool.tool), tool.removal, tools[tool.tool]});
  rows.push_back(
      {"program", program.files.empty() ? "" : program.files[0], 0, 0, "", history.total, all});
  return rows;
}

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == text.npos) return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
  return out + "\"";
}

std::string known_or_empty(double x) {
  return std::isnan(x) ? std::string() : fmt::format("{:.3f}", x);
}

std::string number_or_empty(std::size_t n) { return n > 0 ? std::to_string(n) : std::string(); }

}  // namespace

std::string history_csv(const Program& program, const CycleTime& time, const History& history) {
  std::string out =
      "kind,file,line,motion,tool,seconds,removed_mm3,rate_cm3_min,air_share,depth_mm,width_mm,"
      "engagement_deg\n";
  for (const Row& row : rows_of(program, time, history))
    out += fmt::format(
        "{},{},{},{},{},{:.4f},{:.4f},{:.4f},{:.4f},{},{},{}\n", row.kind, quoted(row.file),
        number_or_empty(static_cast<std::size_t>(row.line)), number_or_empty(row.motion),
        quoted(row.tool), row.removal.seconds, row.removal.removed,
        row.removal.rate() * kCubicCmPerMinute, row.removal.air(), known_or_empty(row.shape.depth),
        known_or_empty(row.shape.width), known_or_empty(degrees(row.shape.engagement)));
  return out;
}

std::string history_json(const Program& program, const CycleTime& time, const History& history) {
  using Json = nlohmann::ordered_json;
  const auto text_of = [](const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
  };
  // Row by row: an object of all rows takes five times its text.
  std::string out =
      "{\n \"schema\": 1,\n \"kind\": \"history\",\n \"unit\": \"mm\",\n \"voxel\": " +
      text_of(history.voxel) + ",\n \"rows\": [";
  const char* between = "\n  ";
  for (const Row& row : rows_of(program, time, history)) {
    Json one{{"kind", row.kind}};
    if (!row.file.empty()) one["file"] = to_utf8(row.file);
    if (row.line > 0) one["line"] = row.line;
    if (row.motion > 0) one["motion"] = row.motion;
    if (!row.tool.empty()) one["tool"] = to_utf8(row.tool);
    one["seconds"] = row.removal.seconds;
    one["removed"] = row.removal.removed;
    one["rate"] = row.removal.rate();
    one["air"] = row.removal.air();
    one["depth"] = row.shape.depth;  // NaN is written as null
    one["width"] = row.shape.width;
    one["engagement"] = degrees(row.shape.engagement);
    out += between + text_of(one);
    between = ",\n  ";
  }
  return out + "\n ]\n}\n";
}

}  // namespace mrsim
