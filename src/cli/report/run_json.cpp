#include "cli/report/run_json.h"

#include "cli/console/exit_codes.h"
#include "cli/console/figures.h"
#include "cli/report/report.h"
#include "cli/report/run_facts.h"
#include "core/process/memory_limit.h"
#include "core/text/text_io.h"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace mrsim::cli {
namespace {

using Json = nlohmann::ordered_json;

// Infinities, which JSON lacks, stand for "nothing".
Json number(double x) { return x - x == 0 ? Json(x) : Json(nullptr); }
// For figures that are never zero: 0 means that the figure is not known.
Json positive(double x) { return x > 0 ? number(x) : Json(nullptr); }
Json point(const Vec3& p) { return {number(p.x), number(p.y), number(p.z)}; }
Json box(const Box3& b) { return {point(b.lo), point(b.hi)}; }
Json text_or_null(const std::string& text) {
  return text.empty() ? Json(nullptr) : Json(to_utf8(text));
}

const char* status_of(int exit_code) {
  switch (exit_code) {
    case kDone:
      return "done";
    case kUsage:
      return "usage";
    case kInternal:
      return "internal";
    case kRejected:
      return "rejected";
    case kCollision:
      return "collision";
    default:
      return exit_code > 128 ? "stopped" : "failed";
  }
}

Json cycle_json(const JobResult& r, const std::string& machine) {
  const CycleTime& t = r.cycle;
  Json tools = Json::array();
  for (const ToolTime& tool : t.tools) {
    if (tool.tool < 0) continue;
    const std::string& id = r.program.tools[static_cast<std::size_t>(tool.tool)].id;
    tools.push_back({{"id", to_utf8(id)},
                     {"seconds", number(tool.cutting + tool.rapid + tool.dwell)},
                     {"cutting", number(tool.cutting)},
                     {"rapid", number(tool.rapid)},
                     {"dwell", number(tool.dwell)}});
  }
  return {{"seconds", number(t.total)},
          {"cutting", number(t.cutting)},
          {"rapid", number(t.rapid)},
          {"dwell", number(t.dwell)},
          {"tool_change", number(t.tool_change)},
          {"spindle", number(t.spindle)},
          {"tool_changes", t.tool_changes},
          {"without_feed", t.without_feed},
          {"machine", text_or_null(machine)},
          {"tools", std::move(tools)}};
}

Json program_json(const RunRecord& record) {
  const JobResult& r = *record.result;
  Json files = Json::array();
  for (const std::string& file : r.program.files) files.push_back(to_utf8(file));
  return {{"path", to_utf8(record.arguments->input)},
          {"files", std::move(files)},
          {"dialect", dialect_name(r.program.dialect)},
          {"dialect_reason", to_utf8(r.program.dialect_reason)},
          {"machine", machine_name(r.program.machine)},
          {"machine_reason", to_utf8(r.program.machine_reason)},
          {"motions",
           {{"rapid", r.rapid_motions},
            {"line", r.line_motions},
            {"arc", r.arc_motions},
            {"cutting", r.cutting_motions}}},
          {"cycle", cycle_json(r, record.arguments->machine.origin)},
          {"machine_seconds", number(r.cycle.total)},
          {"dwell_seconds", number(r.cycle.dwell)},
          {"stops", r.cycle.stops},
          {"optional_stops", r.cycle.optional_stops}};
}

Json tools_json(const Program& program) {
  Json out = Json::array();
  for (const Tool& tool : program.tools)
    out.push_back({{"id", to_utf8(tool.id)},
                   {"text", to_utf8(tool_text(tool))},
                   {"diameter", number(tool.diameter)},
                   {"corner_radius", number(tool.corner_radius)},
                   {"nose_radius", number(tool.nose_radius)},
                   {"flute_length", number(tool.flute_length)},
                   {"origin", to_utf8(tool.origin)}});
  return out;
}

Json repair_json(const StockRepair& repair) {
  if (!repair.wrapped) return nullptr;
  return {{"openings", repair.openings},
          {"widest", number(repair.widest)},
          {"distance", {number(repair.least), number(repair.most)}},
          {"at", point(repair.place)}};
}

Json stock_json(const RunRecord& record) {
  const StockShape& stock = record.result->stock;
  const bool known = stock.box.lo.x <= stock.box.hi.x;
  return {{"given", text_or_null(record.arguments->stock)},
          {"description", text_or_null(stock.description)},
          {"box", known ? box(stock.box) : Json(nullptr)},
          {"repair", repair_json(record.result->stock_repair)},
          {"volume", positive(record.result->stock_volume)}};
}

Json reduction_json(const MeshReduction& reduction) {
  if (reduction.before == 0) return nullptr;
  return {{"before", reduction.before},
          {"distance", {number(reduction.least), number(reduction.most)}},
          {"at", point(reduction.place)}};
}

// Bound of the distance between the written mesh and the exact part, mm; 0 where no bound was
// found, as on the voxels of --voxel.
double bound_of(const JobResult& r) {
  return r.mesh_bound > 0 ? r.mesh_bound + r.reduction.most : 0;
}

Json mesh_json(const JobResult& r) {
  return {{"triangles", r.triangles},
          {"closed", r.summary.closed},
          {"oriented", r.summary.oriented},
          {"manifold", r.summary.manifold},
          {"components", r.summary.components},
          {"euler", r.summary.euler},
          {"area", number(r.summary.area)},
          {"volume", number(r.summary.volume)},
          {"slabs", r.slabs},
          {"reduced", reduction_json(r.reduction)}};
}

// All are counted, the first ten thousand are named.
Json thin_json(const JobResult& r) {
  constexpr std::size_t kMostNamed = 10'000;
  Json places = Json::array();
  for (std::size_t i = 0; i < std::min(r.thin.size(), kMostNamed); ++i) {
    const ThinPlace& thin = r.thin[i];
    places.push_back({{"kind", thin.wall ? "wall" : "gap"},
                      {"thickness", number(thin.thickness)},
                      {"place", point(thin.place)}});
  }
  return {{"count", r.thin.size()}, {"places", places}};
}

Json pieces_json(const JobResult& r) {
  Json out = Json::array();
  for (const PartPiece& piece : r.pieces)
    out.push_back({{"volume", number(piece.volume)},
                   {"center", point(piece.center)},
                   {"bounds", box(piece.bounds)},
                   {"triangles", piece.triangles},
                   {"kept", piece.kept}});
  return out;
}

Json collisions_json(const JobResult& r) {
  Json lines = Json::array();
  for (const ReportCollision& c : collisions_of(r))
    lines.push_back({{"file", to_utf8(c.file)},
                     {"line", c.line},
                     {"tool", to_utf8(c.tool)},
                     {"part", c.part},
                     {"rapid", c.rapid},
                     {"depth", number(c.depth)},
                     {"volume", number(c.volume)},
                     {"at", point(c.place)},
                     {"motion", c.motion},
                     {"seconds", number(c.seconds)},
                     {"motions", c.motions}});
  return {{"lines", std::move(lines)}, {"more", r.collisions.more}};
}

Json diagnostics_json(const Program& program) {
  Json out = Json::array();
  for (const Diagnostic& d : program.diagnostics) {
    Json one = Json::parse(diagnostic_json(d), nullptr, false);
    if (one.is_object() && !one.contains("file")) one["file"] = to_utf8(d.place.file);
    out.push_back(std::move(one));
  }
  return out;
}

Json removal_json(const Removal& removal) {
  return {{"removed", number(removal.removed)},
          {"seconds", number(removal.seconds)},
          {"rate", number(removal.rate())},
          {"air", number(removal.air())}};
}

Json removals_json(const JobResult& r) {
  Json tools = Json::array();
  for (const ToolRemoval& tool : r.history.tools) {
    Json one = removal_json(tool.removal);
    one["id"] =
        tool.tool < 0 ? "" : to_utf8(r.program.tools[static_cast<std::size_t>(tool.tool)].id);
    tools.push_back(std::move(one));
  }
  Json total = removal_json(r.history.total);
  if (!(r.history.voxel > 0))  // no history was made
    for (Json& figure : total) figure = nullptr;
  return {{"voxel", positive(r.history.voxel)},
          {"total", std::move(total)},
          {"tools", std::move(tools)}};
}

Json seconds_json(const JobResult& r) {
  Json stages = Json::object();
  double total = 0;
  for (const auto& [stage, seconds] : r.stage_seconds) {
    stages[stage] = number(seconds);
    total += seconds;
  }
  return {{"total", number(total)}, {"stages", std::move(stages)}};
}

bool has_stage(const JobResult& r, const char* name) {
  return std::any_of(r.stage_seconds.begin(), r.stage_seconds.end(),
                     [&](const auto& stage) { return stage.first == name; });
}

Json outputs_json(const RunRecord& record) {
  Json out = Json::array();
  const bool written = record.exit_code == kDone || record.exit_code == kRejected;
  if (!written) return out;
  for (const WrittenFile& file : record.result->files)
    out.push_back({{"path", to_utf8(file.path)},
                   {"bytes", file.bytes},
                   {"sha256", text_or_null(file.sha256)}});
  return out;
}

Json reasoned(double value, const std::string& reason) {
  return {{"value", positive(value)}, {"reason", text_or_null(reason)}};
}

const char* verdict_of(const Comparison* c) {
  if (c == nullptr || !c->accepted) return "none";
  return *c->accepted ? "accepted" : "rejected";
}

std::string xml(const std::string& text) { return xml_escaped(to_utf8(text)); }

// The findings of one severity, one a line.
std::string findings(const RunRecord& record, Severity severity) {
  std::string out;
  for (const Diagnostic& d : record.result->program.diagnostics)
    if (d.severity == severity)
      out += fmt::format("{}:{}: {} [{}]\n", d.place.file, d.place.line, d.text, d.code);
  return out;
}

// The collisions, the deepest first, one a line.
std::string collisions_text(const JobResult& r) {
  std::string out;
  for (const ReportCollision& c : collisions_of(r))
    out += fmt::format(
        "{}:{}: the {} of T{} runs {:.3f} mm deep into {} mm³ of material{}, motion {} at {}\n",
        c.file, c.line, c.part, c.tool, c.depth, small_volume(c.volume),
        c.rapid ? " in a rapid" : "", c.motion, duration(c.seconds));
  return r.collisions.more > 0 ? out + fmt::format("and {} more\n", r.collisions.more) : out;
}

}  // namespace

std::string run_json(const RunRecord& given) {
  static const JobResult nothing;
  RunRecord record = given;
  if (record.result == nullptr) record.result = &nothing;
  const JobResult& r = *record.result;
  const bool failed = !record.error_code.empty();
  Json out{{"schema", 1},
           {"kind", "run"},
           {"mrsim", version()},
           {"unit", "mm"},
           {"status", status_of(record.exit_code)},
           {"exit_code", record.exit_code}};
  out["error"] = failed ? Json{{"code", record.error_code}, {"text", to_utf8(record.error_text)}}
                        : Json(nullptr);
  out["program"] = program_json(record);
  out["tools"] = tools_json(r.program);
  out["stock"] = stock_json(record);
  out["voxel"] = reasoned(r.voxel, r.voxel_reason);
  out["tolerance"] = reasoned(r.tolerance, r.tolerance_reason);
  out["bound"] = {{"distance", positive(bound_of(r))}, {"sampled_triangles", r.mesh_sampled}};
  out["thin"] = thin_json(r);
  out["volume"] = {{"part", positive(r.volume)},
                   {"removed", r.volume > 0 ? number(r.removed_volume) : Json(nullptr)}};
  out["history"] = removals_json(r);
  out["mesh"] = mesh_json(r);
  out["pieces"] = pieces_json(r);
  out["collisions"] = collisions_json(r);
  out["diagnostics"] = diagnostics_json(r.program);
  out["seconds"] = seconds_json(r);
  const std::size_t peak = r.peak_memory > 0 ? r.peak_memory : peak_memory();  // of a failed run
  out["memory"] = {{"peak", peak}, {"expected", r.expected_memory}};
  out["outputs"] = outputs_json(record);
  out["verdict"] = verdict_of(record.comparison);
  out["comparison"] = record.comparison != nullptr
                          ? Json::parse(comparison_json(*record.comparison), nullptr, false)
                          : Json(nullptr);
  out["rest"] = record.rest.empty() ? Json(nullptr) : Json::parse(record.rest, nullptr, false);
  return out.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string run_junit(const RunRecord& given) {
  static const JobResult nothing;
  RunRecord record = given;
  if (record.result == nullptr) record.result = &nothing;
  std::string cases;
  int failures = 0, skipped = 0;
  // `missing` says why the case was not tried.
  const auto add = [&](const char* name, bool failed, const std::string& text,
                       const char* missing = "") {
    const bool skip = !failed && *missing != 0;
    failures += failed;
    skipped += skip;
    cases += fmt::format("  <testcase classname=\"mrsim.run\" name=\"{}\">", name);
    if (failed) cases += fmt::format("<failure message=\"{0}\">{0}</failure>", xml(text));
    if (skip) cases += fmt::format("<skipped message=\"{}\"/>", missing);
    cases += "</testcase>\n";
  };
  const std::string errors = findings(record, Severity::error);
  add("program", !errors.empty(), errors);
  add("run", record.exit_code != kDone && record.exit_code != kRejected,
      record.error_text.empty() ? status_of(record.exit_code) : record.error_text);
  const std::string collisions = collisions_text(*record.result);
  add("collisions", !collisions.empty(), collisions,
      has_stage(*record.result, "collisions") ? "" : "the run ended before the search");
  const bool compared = record.comparison != nullptr;
  add("comparison", record.exit_code == kRejected,
      compared ? comparison_text(*record.comparison) : "",
      compared                                    ? ""
      : record.arguments->compare.nominal.empty() ? "no nominal"
                                                  : "the run ended before the comparison");
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<testsuites tests=\"4\" failures=\"{0}\" skipped=\"{1}\">\n"
      " <testsuite name=\"mrsim {2}\" tests=\"4\" failures=\"{0}\" skipped=\"{1}\">\n{3} "
      "</testsuite>\n"
      "</testsuites>\n",
      failures, skipped, xml(record.arguments->input), cases);
}

}  // namespace mrsim::cli
