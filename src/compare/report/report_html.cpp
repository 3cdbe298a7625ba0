// The HTML report: the built viewer (web/dist/report.html) with the data of one comparison inside.
//
// Safe with any text from programs and files: JSON in a script element, with every '<' written as
// \u003c, so that nothing in it can end the element; the viewer sets text, never markup.
#include "compare/blame/blame.h"
#include "compare/distance/align.h"
#include "compare/report/display_mesh.h"
#include "compare/report/packed.h"
#include "compare/report/play_json.h"
#include "compare/report/report_template.h"
#include "core/numbers/units.h"
#include "core/numbers/vec.h"
#include "core/process/error.h"
#include "core/process/memory_limit.h"
#include "core/text/printable.h"
#include "core/text/text_io.h"
#include "core/words/tool_types.h"
#include "mesh/solid/half_edges.h"
#include <mrsim/report_html.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <nlohmann/json.hpp>

namespace mrsim {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostShown = 200000;  // triangles of the part
constexpr std::size_t kMostNominal = 150000;
constexpr int kMostProgramLines = 200000;  // of a program; beyond, only those around the cuts
constexpr double kDeviationStep = 1e-4;    // mm
// Bytes, measured: what is shown has at most so many triangles, but comes from copies.
constexpr double kPage = 25e6, kPartTriangle = 30, kNominalTriangle = 200;
constexpr double kPlayMotion = 250, kPlayVoxel = 8;

// Positions as 24-bit steps over the bounds: 6 nm on 100 mm.
struct Grid {
  Vec3 lo;
  double step = 1;
};

Grid grid_of(const TriMesh& a, const TriMesh& b) {
  Box3 box;
  for (const TriMesh* mesh : {&a, &b})
    for (const auto& v : mesh->vertices) extend(box, to_vec(v));
  if (is_empty(box)) return {};
  const Vec3 size = box.hi - box.lo;
  return {box.lo, std::max({size.x, size.y, size.z, 1e-6}) / 16777215.0};
}

Json pack_positions(const TriMesh& mesh, const Grid& grid) {
  Packer out;
  std::int64_t last[3] = {0, 0, 0};
  for (const auto& v : mesh.vertices) {
    const Vec3 p = (1 / grid.step) * (to_vec(v) - grid.lo);
    for (int k = 0; k < 3; ++k) out.add(std::llround(component(p, k)), last[k]);
  }
  return out.json();
}

template <std::size_t N>
Json pack_indices(const std::vector<std::array<std::uint32_t, N>>& items) {
  Packer out;
  std::int64_t last = 0;
  for (const auto& item : items)
    for (const std::uint32_t i : item) out.add(i, last);
  return out.json();
}

Json pack_deviations(const std::vector<float>& values) {
  Packer out;
  std::int64_t last = 0;
  for (const float v : values) out.add(std::llround(double(v) / kDeviationStep), last);
  return out.json();
}

Json mesh_json(const DisplayMesh& display, const Grid& grid, const FaceLines* lines) {
  Json out{{"vertices", display.mesh.vertices.size()},
           {"triangles", display.mesh.triangles.size()},
           {"position", pack_positions(display.mesh, grid)},
           {"index", pack_indices(display.mesh.triangles)}};
  const auto creases = crease_lines(display.mesh, radians(28));
  out["creases"] = creases.size();
  out["crease"] = pack_indices(creases);
  if (!display.deviation.empty()) out["deviation"] = pack_deviations(display.deviation);
  if (lines == nullptr) return out;
  Packer owners;
  std::int64_t last = 0;
  for (std::uint32_t f = 0; f < display.mesh.triangles.size(); ++f)
    owners.add(lines->index(f), last);
  out["owner"] = owners.json();
  return out;
}

// Lines to embed: all of a program of usual length, else those around what is shown.
std::vector<bool> wanted_lines(const Comparison& c, std::size_t file,
                               const std::vector<LineKey>& keys) {
  const auto& text = c.text[file];
  std::vector<bool> wanted(text.size(), text.size() <= std::size_t(kMostProgramLines));
  if (text.size() <= std::size_t(kMostProgramLines)) return wanted;
  int left = kMostProgramLines;
  for (const LineKey& key : keys) {
    if (key.file != std::int32_t(file) || left <= 0) continue;
    for (int l = std::max(0, key.line - 3); l < std::min(int(text.size()), key.line + 2); ++l)
      if (!wanted[std::size_t(l)]) {
        wanted[std::size_t(l)] = true;
        --left;
      }
  }
  return wanted;
}

Json programs_json(const Comparison& c, const std::vector<LineKey>& keys) {
  Json out = Json::array();
  for (std::size_t file = 0; file < c.origin.files.size(); ++file) {
    Packer numbers;
    std::string text;
    std::int64_t count = 0, last = 0;
    if (file < c.text.size()) {
      const std::vector<bool> wanted = wanted_lines(c, file, keys);
      for (std::size_t l = 0; l < wanted.size(); ++l)
        if (wanted[l]) {
          numbers.add(std::int64_t(l) + 1, last);
          text += to_utf8(c.text[file][l]);
          text += '\n';
          ++count;
        }
    }
    out.push_back({{"file", to_utf8(c.origin.files[file])},
                   {"count", count},
                   {"numbers", numbers.json()},
                   {"text", text}});  // plain, so that a search finds a line in the file
  }
  return out;
}

Json keys_json(const std::vector<LineKey>& keys, const OwnerTable& table) {
  Json out = Json::array();
  for (const LineKey& key : keys) {
    const BlamedLine name = name_line(key, table, {});
    out.push_back({{"file", key.file},
                   {"line", key.line},
                   {"tool", key.is_stock() ? -1 : key.tool},
                   {"name", to_utf8(name.file)},
                   {"stock", key.is_stock()},
                   {"toolName", to_utf8(name.tool)}});
  }
  return out;
}

const char* severity_name(Severity s) {
  return s == Severity::error ? "error" : s == Severity::warning ? "warning" : "note";
}

Json tool_json(const Tool& t) {
  return {{"id", to_utf8(t.id)},          {"type", tool_type_name(t.type)},
          {"diameter", t.diameter},       {"corner_radius", t.corner_radius},
          {"nose_radius", t.nose_radius}, {"flute_length", t.flute_length},
          {"origin", to_utf8(t.origin)}};
}

// Their places move with the part.
Json collisions_json(const ReportFacts& facts, const RigidTransform& moved) {
  Json lines = Json::array();
  for (const ReportCollision& c : facts.collisions) {
    const Vec3 at = apply(moved, c.place);
    lines.push_back({{"part", c.part},
                     {"tool", to_utf8(c.tool)},
                     {"file", to_utf8(c.file)},
                     {"line", c.line},
                     {"text", to_utf8(c.text)},
                     {"rapid", c.rapid},
                     {"depth", c.depth},
                     {"volume", c.volume},
                     {"at", {at.x, at.y, at.z}},
                     {"motion", c.motion},
                     {"seconds", c.seconds},
                     {"motions", c.motions}});
  }
  return {{"lines", std::move(lines)}, {"more", facts.more_collisions}};
}

Json facts_json(const ReportFacts& facts) {
  Json out{{"title", to_utf8(facts.title)}};
  for (const char* key : {"facts", "times", "tools", "diagnostics"}) out[key] = Json::array();
  for (const auto& [name, value] : facts.facts)
    out["facts"].push_back({to_utf8(name), to_utf8(value)});
  for (const auto& [name, seconds] : facts.times) out["times"].push_back({to_utf8(name), seconds});
  for (const Tool& t : facts.tools) out["tools"].push_back(tool_json(t));
  for (const Diagnostic& d : facts.diagnostics)
    out["diagnostics"].push_back({{"severity", severity_name(d.severity)},
                                  {"code", to_utf8(d.code)},
                                  {"text", to_utf8(d.text)},
                                  {"file", to_utf8(d.place.file)},
                                  {"line", d.place.line},
                                  {"column", d.place.column}});
  return out;
}

// Nothing between the tags of a script element may look like its end, nor turn the page's text
// round.
void add_script_safe(std::string_view json, std::string& out) {
  for (std::size_t i = 0; i < json.size(); ++i) {
    const bool turns = json[i] == '\xE2' && turns_text(json.substr(i));
    if (json[i] == '<')
      out += "\\u003c";
    else
      out += turns ? '?' : json[i];
    if (turns) i += 2;
  }
}

// The template with the data in it. The data are given up on the way.
std::string page_with(Json data) {
  const std::string_view page(report_template());
  const std::string_view mark = "\"MRSIM-DATA\"";
  const std::size_t at = page.find(mark);
  MRSIM_ASSERT(at != page.npos);
  const std::string json = data.dump(-1, ' ', false, Json::error_handler_t::replace);
  data = nullptr;
  std::string out;
  out.reserve(page.size() + json.size() + json.size() / 64);
  out += page.substr(0, at);
  add_script_safe(json, out);
  return out += page.substr(at + mark.size());
}

double play_memory(const ReportRun& run) {
  if (!run.play) return 0;
  return kPlayMotion * double(run.play->removed.size()) +
         kPlayVoxel * double(run.play->gone.size());
}

DisplayMesh shown_part(const TriMesh& part, const TriMesh& nominal, const Comparison& c,
                       int threads) {
  TriMesh moved = transformed(part, c.transform);
  if (nominal.triangles.empty()) {
    std::vector<float> none(moved.vertices.size(), 0.0f);
    return {std::move(moved), std::move(none)};
  }
  const NominalSurface surface(nominal, threads);
  return refine_for_display(moved, surface, (c.band.hi - c.band.lo) / 8, kMostShown, threads);
}

}  // namespace

std::string report_html(const TriMesh& part, const TriMesh& nominal, const Comparison& comparison,
                        const ReportFacts& facts, int threads) {
  const double copies = nominal.triangles.empty() ? 1 : 2;
  require_memory(kPage + copies * kPartTriangle * double(part.triangles.size()) +
                     kNominalTriangle * double(nominal.triangles.size()) + play_memory(facts.run),
                 "a report", "--max-memory allows more, and a coarser mesh takes less");
  const DisplayMesh shown =
      cluster_for_display(shown_part(part, nominal, comparison, threads), kMostShown);
  const DisplayMesh overlay = cluster_for_display(
      {nominal, std::vector<float>(nominal.vertices.size(), 0.0f)}, kMostNominal);
  const FaceLines lines(shown.mesh);
  const Grid grid = grid_of(shown.mesh, overlay.mesh);
  Json data{{"version", 2},
            {"generator", std::string("mrsim ") + MRSIM_VERSION},
            {"compared", !nominal.triangles.empty()},
            {"reduced", shown.mesh.triangles.size() < part.triangles.size()},
            {"comparison", Json::parse(comparison_json(comparison))},
            {"facts", facts_json(facts)},
            {"collisions", collisions_json(facts, comparison.transform)},
            {"keys", keys_json(lines.lines(), part.origin)},
            {"programs", programs_json(comparison, lines.lines())},
            {"grid", {{"lo", {grid.lo.x, grid.lo.y, grid.lo.z}}, {"step", grid.step}}},
            {"deviationStep", kDeviationStep},
            {"part", mesh_json(shown, grid, &lines)},
            {"play", play_json(facts.run, comparison.origin.files.size())}};
  if (!overlay.mesh.triangles.empty())
    data["nominal"] = mesh_json({overlay.mesh, {}}, grid, nullptr);
  return page_with(std::move(data));
}

}  // namespace mrsim
