// The compare part of the facade that needs every stage: parts from .vdb, programs beside parts.
#include "compare/distance/nominal.h"
#include "core/process/error.h"
#include "core/process/memory_limit.h"
#include "core/text/ascii.h"
#include "core/text/text_io.h"
#include "mesh/draw/palette.h"
#include "mesh/extract.h"
#include "mesh/format/mesh_io.h"
#include "mesh/solid/check.h"
#include "mesh/solid/solid_repair.h"
#include "run/cuts/cuts.h"
#include "run/files/outputs.h"
#include "run/files/vdb_files.h"
#include <mrsim/mrsim.h>
#include <mrsim/solid_files.h>

#include <filesystem>

#include <fmt/format.h>

namespace mrsim {
namespace {

TriMesh mesh_of_vdb(const std::string& path, int threads, std::string* note) {
  VdbContent saved = read_vdb_file(path);
  if (!saved.recipe) {
    if (note != nullptr) *note = saved.accuracy;
    return std::move(saved.surface);
  }
  const StockRecipe& recipe = *saved.recipe;
  const CarvePlan plan{.voxel = recipe.voxel, .threads = threads, .keep_grid = false};
  const CutHistory& cuts = recipe.shape.history;
  const Stock stock = carve(recipe.shape, cuts.motions, cuts.tools, plan);
  TriMesh mesh = extract_mesh(stock, {.threads = threads});
  mesh.origin = owner_table(owners_of(MemoryMesh(mesh)), CutList(cuts));
  if (note != nullptr)
    *note = fmt::format("{}: meshed with its voxel of {:.4g} mm", path, recipe.voxel);
  return mesh;
}

// A mesh that is nearly a solid is made one, as a stock is. One that leaves something to guess is
// refused where it is used.
std::string repair(TriMesh& mesh, const std::string& path) {
  const MeshSummary summary = check_mesh(mesh);
  const bool is_solid = summary.closed && summary.oriented && summary.volume > 0;
  if (is_solid && summary.components < 2) return "";
  TriMesh solid = mesh;
  try {
    const std::string repairs = make_solid(solid, path);
    if (repairs.empty() && is_solid) return "";
    mesh = std::move(solid);
    return path + " was no solid and has been repaired: " + repairs;
  } catch (const Error&) {
    return "";
  }
}

// Bodies that cross or hold each other have faces within the material, and deviations from these;
// around one that is inside out all is material.
std::string crossing(const TriMesh& mesh, const std::string& path) {
  const MeshSummary summary = check_mesh(mesh);
  if (!summary.closed || !summary.oriented || summary.components < 2) return "";
  try {
    require_clean_bodies(mesh, path);
    return "";
  } catch (const Error& error) {
    std::string text = error.what();
    if (error.code() != "mesh-inverted")
      text +=
          "; until then faces within the material are compared like others, and what lies in two "
          "bodies counts twice in volumes";
    return text;
  }
}

std::vector<std::string> split_lines(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    std::size_t end = text.find('\n', begin);
    if (end == text.npos) end = text.size();
    const std::size_t length = end - begin - (end > begin && text[end - 1] == '\r');
    lines.push_back(to_utf8(text.substr(begin, length)));
    begin = end + 1;
  }
  return lines;
}

// The name as it is where it was stored, then by its last part only: no name from a part's file
// leads out of the folders that were given.
std::vector<std::string> places_of(const std::string& name, const std::string& part,
                                   const std::vector<std::string>& folders) {
  namespace fs = std::filesystem;
  const fs::path last = fs::path(name).filename();
  std::vector<std::string> places{fs::path(part).parent_path() / last};
  for (const std::string& folder : folders) places.push_back(fs::path(folder) / last);
  if (name == last.string() || part.empty()) places.push_back(name);
  return places;
}

std::vector<std::string> find_program(const std::vector<std::string>& places) {
  for (const std::string& place : places) {
    std::error_code ignored;
    if (std::filesystem::is_regular_file(place, ignored)) return split_lines(read_file(place));
  }
  return {};
}

}  // namespace

bool is_step(const std::string& path) {
  const std::string extension = extension_of(path);
  return extension == ".step" || extension == ".stp";
}

TriMesh read_solid(const std::string& path, double deflection, int threads, std::string* note) {
  if (is_vdb(path)) return mesh_of_vdb(path, threads, note);
  if (!is_step(path)) mesh_format_of(path, " .step .stp .vdb");
  TriMesh mesh = is_step(path) ? read_step(path, deflection, note) : read_mesh(path);
  if (note == nullptr) return mesh;
  // The comparison asks for as much after this.
  require_memory(kCheckBytes * double(mesh.triangles.size()), "checking the bodies of " + path,
                 "a coarser mesh takes less");
  if (!is_step(path)) *note = repair(mesh, path);
  if (const std::string crosses = crossing(mesh, path); !crosses.empty())
    *note += (note->empty() ? "" : "\n") + crosses;
  return mesh;
}

std::vector<std::vector<std::string>> read_program_lines(const OwnerTable& origin,
                                                         const std::string& part,
                                                         const std::vector<std::string>& folders) {
  std::vector<std::vector<std::string>> out;
  for (const std::string& file : origin.files)
    out.push_back(find_program(places_of(file, part, folders)));
  return out;
}

std::vector<std::string> program_places(const OwnerTable& origin, const std::string& part,
                                        const std::vector<std::string>& folders) {
  std::vector<std::string> out;
  for (const std::string& file : origin.files)
    for (std::string& place : places_of(file, part, folders)) out.push_back(std::move(place));
  return out;
}

double step_deflection(const std::optional<Acceptance>& accept) {
  if (!accept) return 0.001;
  return std::clamp(narrow_side(*accept) / 20, 0.0002, 0.005);
}

}  // namespace mrsim
