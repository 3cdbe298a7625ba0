#include "cli/report/report.h"

#include "cli/console/figures.h"
#include "cli/console/terminal.h"
#include "core/numbers/rounding.h"
#include "core/numbers/tool_point.h"
#include "core/numbers/units.h"
#include "core/process/memory_limit.h"
#include "core/words/tool_types.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

namespace mrsim::cli {
namespace {

constexpr int kLabel = 11;

class Sheet {
 public:
  explicit Sheet(bool colours) : colours_(colours) {}
  void title(const std::string& text) {
    out_ += styled(printable(text), Style::bold, colours_) + "\n";
  }
  // A label, a value, and why it is so.
  void row(const std::string& label, const std::string& value, const std::string& reason = "") {
    const std::string head = fmt::format("  {:<{}}", label, kLabel);
    out_ += styled(head, Style::dim, colours_) + printable(value);
    if (!reason.empty()) out_ += styled("  (" + printable(reason) + ")", Style::dim, colours_);
    out_ += '\n';
  }
  std::string text() const { return out_; }

 private:
  bool colours_;
  std::string out_;
};

std::string plural(std::size_t n, const char* word) {
  return fmt::format("{} {}{}", grouped(static_cast<double>(n), 0), word, n == 1 ? "" : "s");
}

void add_program(Sheet& sheet, const Program& program) {
  sheet.row("dialect", dialect_name(program.dialect), program.dialect_reason);
  sheet.row("machine", machine_name(program.machine), program.machine_reason);
  bool first = true;
  for (const Tool& tool : program.tools) {
    sheet.row(first ? "tools" : "", (tool.id.empty() ? "" : "T" + tool.id + "  ") + tool_text(tool),
              tool.origin);
    first = false;
  }
}

// Two digits, rounded up: a bound stays true when it is printed.
double printed_bound(double bound) {
  const double unit = std::pow(10, std::floor(std::log10(bound)) - 1);
  return std::ceil(bound / unit * (1 - kShareRounding)) * unit;
}

// Where a bound and a volume do not hold.
std::string without_thin(const JobResult& result) {
  const std::size_t count = result.thin.size();
  return count == 1 ? "but for the thin place above"
                    : fmt::format("but for the {} thin places above",
                                  grouped(static_cast<double>(count), 0));
}

std::string bound_text(const JobResult& result) {
  if (!(result.mesh_bound > 0)) return "";
  std::string bound =
      fmt::format(", within {:.2g} mm of the exact part", printed_bound(result.mesh_bound));
  // Measured are the triangles of the mesh; a piece of the part that has no triangle is not
  // measured.
  if (result.mesh_usual > 0)
    bound =
        fmt::format(", measured: each within {:.2g} mm of the exact part, 99 % within {:.2g} mm",
                    printed_bound(result.mesh_bound), printed_bound(result.mesh_usual));
  if (result.mesh_sampled > 0)
    bound += fmt::format(", by samples on {} of them",
                         grouped(static_cast<double>(result.mesh_sampled), 0));
  if (result.reduction.before > 0) bound += ", before the reduction";
  if (!result.thin.empty()) bound += fmt::format(", {}", without_thin(result));
  return bound;
}

// Meshes, pages, tables and the frames, of which there may be hundreds.
void add_files(Sheet& sheet, const std::vector<WrittenFile>& files) {
  constexpr std::size_t kMostListed = 12;
  const std::size_t listed = files.size() > kMostListed ? kMostListed / 2 : files.size();
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (i >= listed && i + listed < files.size()) continue;
    sheet.row("written", files[i].path, size_text(static_cast<double>(files[i].bytes)));
    if (i + 1 == listed && listed < files.size())
      sheet.row("", fmt::format("... and {} more", files.size() - 2 * listed));
  }
}

void add_part(Sheet& sheet, const Arguments& arguments, const JobResult& result) {
  const MeshSummary& summary = result.summary;
  const bool from_field = std::abs(result.volume - summary.volume) >= 5e-4;
  const bool is_measured = from_field || result.mesh_bound > 0;
  std::string volume_of = from_field     ? "the mesh " + grouped(summary.volume, 3) + " mm³"
                          : !is_measured ? "of the mesh"
                                         : "";
  if (!result.thin.empty()) volume_of += (volume_of.empty() ? "" : ", ") + without_thin(result);
  sheet.row("volume", grouped(result.volume, 3) + " mm³", volume_of);
  sheet.row("removed", grouped(result.removed_volume, 3) + " mm³",
            "stock " + grouped(result.stock_volume, 3) + " mm³");
  sheet.row("triangles", grouped(static_cast<double>(result.triangles), 0),
            "closed, oriented, 2-manifold" + bound_text(result));
  if (const MeshReduction& reduced = result.reduction; reduced.before > 0)
    sheet.row("", "reduced from " + grouped(static_cast<double>(reduced.before), 0),
              fmt::format("measured, both ways: within {:.2g} mm of the mesh before",
                          printed_bound(reduced.most)));
  if (result.mesh_kept > 0)
    sheet.row("", grouped(static_cast<double>(result.mesh_kept), 0) + " vertices kept",
              "the mesh would meet itself without them");
  if (result.pieces.size() > 1)
    sheet.row("pieces", grouped(static_cast<double>(result.pieces.size()), 0),
              result.pieces[1].kept ? "all kept" : "the largest kept");
  if (arguments.verbose) {
    sheet.row("area", grouped(summary.area, 3) + " mm²");
    sheet.row("surfaces",
              fmt::format("{}, Euler characteristic {}", summary.components, summary.euler));
    if (result.active_voxels > 0)
      sheet.row("voxels", grouped(static_cast<double>(result.active_voxels), 0) + " active");
  }
  add_files(sheet, result.files);
}

std::string tool_name(const JobResult& result, int tool) {
  const std::string& id = result.program.tools[static_cast<std::size_t>(tool)].id;
  return id.empty() ? "the tool" : "T" + id;
}

void add_cycle(Sheet& sheet, const Arguments& arguments, const JobResult& result) {
  const CycleTime& t = result.cycle;
  std::string parts = fmt::format("cutting {}, rapids {}", duration(t.cutting), duration(t.rapid));
  if (t.dwell > 0) parts += fmt::format(", dwells {}", duration(t.dwell));
  if (t.tool_changes > 0)
    parts += fmt::format(", {} {}", plural(t.tool_changes, "tool change"), duration(t.tool_change));
  if (t.spindle > 0) parts += fmt::format(", spindle {}", duration(t.spindle));
  if (t.stops > 0) parts += fmt::format("; {} (M0)", plural(t.stops, "stop"));
  if (t.optional_stops > 0)
    parts += fmt::format("; {} (M1)", plural(t.optional_stops, "optional stop"));
  if (t.without_feed > 0) parts += fmt::format("; {} have no feed", plural(t.without_feed, "cut"));
  const std::string& origin = arguments.machine.origin;
  sheet.row("cycle", duration(t.total),
            parts + "; " + (origin.empty() ? "a usual machine: --machine-file" : origin));
  if (t.tools.size() < 2 && !arguments.verbose) return;
  for (const ToolTime& tool : t.tools)
    if (tool.tool >= 0)
      sheet.row("", fmt::format("{}  {}", tool_name(result, tool.tool),
                                duration(tool.cutting + tool.rapid + tool.dwell)));
}

void add_history(Sheet& sheet, const JobResult& result) {
  const History& history = result.history;
  if (!(history.voxel > 0) || !(history.total.removed > 0)) return;
  const auto text = [](const Removal& r) {
    return fmt::format("{} mm³ in {}, {:.3g} cm³/min, {:.0f} % of the time in air",
                       small_volume(r.removed), duration(r.seconds), r.rate() * 0.06,
                       100 * r.air());
  };
  sheet.row("cuts", text(history.total), fmt::format("by voxels of {:.3g} mm", history.voxel));
  if (history.tools.size() < 2) return;
  for (const ToolRemoval& tool : history.tools)
    if (tool.tool >= 0)
      sheet.row("", fmt::format("{}  {}", tool_name(result, tool.tool), text(tool.removal)));
}

void add_time(Sheet& sheet, const JobResult& result, bool is_part_alone) {
  double total = 0;
  std::string stages;
  for (const auto& [stage, seconds] : result.stage_seconds) {
    total += seconds;
    stages += fmt::format("{}{} {:.3f}", stages.empty() ? "" : ", ", stage, seconds);
  }
  sheet.row("time", fmt::format("{:.3f} s", total), stages);
  sheet.row("memory", size_text(static_cast<double>(result.peak_memory)) + " at most",
            size_text(static_cast<double>(result.expected_memory)) + " were expected" +
                (is_part_alone ? "" : " of the part alone"));
}

}  // namespace

const char* dialect_name(Dialect dialect) {
  switch (dialect) {
    case Dialect::sinumerik:
      return "SINUMERIK";
    case Dialect::iso:
      return "ISO";
    case Dialect::fanuc:
      return "FANUC";
    case Dialect::codesys:
      return "CODESYS";
    case Dialect::ngc:
      return "LinuxCNC";
    case Dialect::automatic:
      break;
  }
  return "unknown";
}

const char* tool_part_name(ToolPart part) {
  return part == ToolPart::cutter ? "cutter" : part == ToolPart::shank ? "shank" : "holder";
}

const char* machine_name(MachineKind kind) {
  return kind == MachineKind::mill ? "mill" : kind == MachineKind::lathe ? "lathe" : "unknown";
}

namespace {

std::string angle_text(const Tool& tool) {
  if (tool.type == ToolType::taper)
    return fmt::format(", {:.4g}° a side", degrees(tool.taper_angle));
  const bool pointed = tool.type == ToolType::drill || tool.type == ToolType::chamfer;
  return pointed ? fmt::format(", point {:.4g}°", degrees(2 * point_half_angle(tool))) : "";
}

std::string largest(const char* name, const std::vector<ToolSegment>& pieces) {
  double d = 0;
  for (const ToolSegment& s : pieces) d = std::max({d, s.diameter_low, s.diameter_high});
  return pieces.empty() ? "" : fmt::format(", {} Ø{:.6g}", name, d);
}

std::string insert_text(const Tool& tool) {
  std::string text(tool_type_text(tool.type));
  if (tool.type == ToolType::grooving) {
    if (tool.width > 0) text += fmt::format(" {:.6g} mm wide", tool.width);
    if (tool.nose_radius > 0) text += fmt::format(", corner radius {:.6g}", tool.nose_radius);
    return text;
  }
  if (!tool.insert.empty()) text += " " + tool.insert;
  if (tool.diameter > 0) text += fmt::format(" Ø{:.6g}", tool.diameter);
  if (tool.insert_angle > 0) text += fmt::format(" {:.4g}°", degrees(tool.insert_angle));
  if (tool.lead_angle > 0) text += fmt::format(", lead {:.4g}°", degrees(tool.lead_angle));
  if (tool.edge_length > 0) text += fmt::format(", edge {:.6g} mm", tool.edge_length);
  if (tool.nose_radius > 0) return text + fmt::format(", nose radius {:.6g} mm", tool.nose_radius);
  return tool.diameter > 0 ? text : text + ", sharp";
}

}  // namespace

std::string tool_text(const Tool& tool) {
  if (is_turning(tool.type)) return insert_text(tool);
  std::string text(tool_type_text(tool.type));
  const auto add = [&](const char* name, double value) {
    if (value > 0) text += fmt::format(", {}{:.6g}", name, value);
  };
  if (tool.diameter > 0) text += fmt::format(" Ø{:.6g}", tool.diameter);
  add("corner radius ", tool.corner_radius);
  add("flank radius ", tool.profile_radius);
  text += angle_text(tool);
  add("tip Ø", tool.tip_diameter);
  if (tool.flute_length > 0)
    text += fmt::format(", flutes {:.6g} mm", tool.flute_length);
  else if (tool.width > 0)
    text += fmt::format(", head {:.6g} mm", tool.width);
  else if (!ends_in_head(tool))
    text += ", cuts up to the stock's top";
  add("neck Ø", tool.neck_diameter);
  return text + largest("shank", tool.shank) + largest("holder", tool.holder);
}

std::string format_program(const Program& program, bool verbose, bool colours) {
  Sheet sheet(colours);
  sheet.title(program.files.empty() ? "program" : program.files[0]);
  add_program(sheet, program);
  bool first = true;
  for (const auto& [name, mode] : program.start_modes) {
    if (verbose) sheet.row(first ? "starts in" : "", mode, name);
    first = false;
  }
  return sheet.text();
}

std::string format_report(const Arguments& arguments, const JobResult& result, bool colours) {
  const std::string head = format_program(result.program, arguments.verbose, colours);
  Sheet sheet(colours);
  sheet.row("stock", result.stock.description);
  sheet.row("voxel", fmt::format("{:.6g} mm", result.voxel), result.voxel_reason);
  if (result.tolerance > 0)
    sheet.row("tolerance", fmt::format("{:.6g} mm", result.tolerance), result.tolerance_reason);
  else if (!result.tolerance_reason.empty())
    sheet.row("tolerance", "as the voxels give", result.tolerance_reason);
  sheet.row("motions",
            fmt::format("{} cut, {}", grouped(static_cast<double>(result.cutting_motions), 0),
                        plural(result.rapid_motions, "rapid")),
            fmt::format("{}, {}", plural(result.line_motions, "line"),
                        plural(result.arc_motions, "arc")));
  add_cycle(sheet, arguments, result);
  sheet.title("part");
  add_part(sheet, arguments, result);
  add_history(sheet, result);
  const CompareRequest& compare = arguments.compare;
  add_time(sheet, result, compare.nominal.empty() && compare.report.empty());
  return head + sheet.text();
}

}  // namespace mrsim::cli
