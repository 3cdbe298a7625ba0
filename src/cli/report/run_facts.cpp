#include "cli/report/run_facts.h"

#include "cli/console/figures.h"
#include "cli/report/report.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

namespace mrsim::cli {
namespace {

const char* tool_kind(MachineKind kind) { return kind == MachineKind::lathe ? "lathe" : "mill"; }

// The times by tool. With a single tool the time of the cycle says the same.
void add_tool_times(const JobResult& result, ReportFacts& out) {
  if (result.cycle.tools.size() < 2) return;
  for (const ToolTime& tool : result.cycle.tools) {
    if (tool.tool < 0) continue;
    const std::string& id = result.program.tools[static_cast<std::size_t>(tool.tool)].id;
    out.facts.emplace_back(
        "Time of " + (id.empty() ? std::string("the tool") : "T" + id),
        fmt::format("{}: cutting {}, rapids {}, dwells {}",
                    duration(tool.cutting + tool.rapid + tool.dwell), duration(tool.cutting),
                    duration(tool.rapid), duration(tool.dwell)));
  }
}

}  // namespace

std::vector<ReportCollision> collisions_of(const JobResult& result) {
  const Program& program = result.program;
  std::vector<double> seconds(program.motions.size());  // before each motion
  for (std::size_t i = 1; i < std::min(seconds.size(), result.cycle.seconds.size() + 1); ++i)
    seconds[i] = seconds[i - 1] + result.cycle.seconds[i - 1];
  std::vector<ReportCollision> out;
  for (const Collision& c : result.collisions.lines) {
    const Motion& m = program.motions[c.motion];
    ReportCollision shown;
    shown.part = tool_part_name(c.part);
    shown.tool = program.tools[static_cast<std::size_t>(m.tool)].id;
    shown.file = program.files[static_cast<std::size_t>(m.file)];
    shown.line = m.line;
    shown.rapid = m.kind == MotionKind::rapid;
    shown.depth = c.depth;
    shown.volume = c.volume;
    shown.seconds = seconds[c.motion];
    shown.place = c.place;
    shown.motion = c.motion + 1;
    shown.motions = c.motions;
    for (const Diagnostic& d : program.diagnostics)
      if (d.place.line == m.line && d.place.file == shown.file && !d.source_line.empty())
        shown.text = d.source_line;
    out.push_back(shown);
  }
  // Of two collisions whose printed depths are equal, the one that meets more material is worse.
  const auto order = [](const ReportCollision& c) {
    return std::pair(-std::llround(c.depth / 1e-3), -c.volume);
  };
  std::stable_sort(out.begin(), out.end(), [&](const ReportCollision& a, const ReportCollision& b) {
    return order(a) < order(b);
  });
  return out;
}

ReportFacts facts_of(const JobResult& result, const std::string& program) {
  ReportFacts out;
  out.title = std::filesystem::path(program).filename().string();
  out.facts = {{"Program", program},
               {"Machine", tool_kind(result.program.machine)},
               {"Stock", result.stock.description},
               {"Voxel", fmt::format("{:.4g} mm, {}", result.voxel, result.voxel_reason)},
               {"Moves", fmt::format("{} rapids, {} lines, {} arcs", result.rapid_motions,
                                     result.line_motions, result.arc_motions)},
               {"Volume", grouped(result.volume, 3) + " mm³"},
               {"Removed", grouped(result.removed_volume, 3) + " mm³"},
               {"Cycle", duration(result.cycle.total)},
               {"Memory", fmt::format("{:.0f} MB", double(result.peak_memory) / 1e6)}};
  add_tool_times(result, out);
  if (result.stock_repair.wrapped)
    out.facts.emplace_back("Stock's repair",
                           fmt::format("wrapped, at most {:.3g} mm beside its surface, {} openings "
                                       "closed",
                                       result.stock_repair.most, result.stock_repair.openings));
  if (result.mesh_bound > 0)
    out.facts.emplace_back("Mesh",
                           fmt::format("within {:.4g} mm of the exact part{}", result.mesh_bound,
                                       result.mesh_sampled > 0 ? ", by samples in places" : ""));
  out.times = result.stage_seconds;
  out.tools = result.program.tools;
  out.diagnostics = result.program.diagnostics;
  out.collisions = collisions_of(result);
  out.more_collisions = result.collisions.more;
  out.run = {&result.program, &result.cycle, &result.stock, &result.play};
  return out;
}

}  // namespace mrsim::cli
