// The compare part of the facade that needs every stage: parts from .vdb, programs beside parts.
#include "core/text_io.h"
#include "cuts.h"
#include "mesh/draw/palette.h"
#include "mesh/extract.h"
#include "outputs.h"
#include "vdb_files.h"
#include <mrsim/mrsim.h>
#include <mrsim/solid_files.h>

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

namespace mrsim {
namespace {

bool has_extension(const std::string& path, const std::string& wanted) {
  std::string end = std::filesystem::path(path).extension().string();
  std::transform(end.begin(), end.end(), end.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
  return end == wanted;
}

TriMesh mesh_of_vdb(const std::string& path, int threads, std::string* note) {
  VdbContent saved = read_vdb_file(path);
  if (!saved.recipe) {
    if (note != nullptr) *note = saved.accuracy;
    return std::move(saved.surface);
  }
  const StockRecipe& recipe = *saved.recipe;
  CarveOptions carve_options;
  carve_options.voxel = recipe.voxel;
  carve_options.threads = threads;
  carve_options.keep_grid = false;
  const CutHistory& cuts = recipe.shape.history;
  const Stock stock = carve(recipe.shape, cuts.motions, cuts.tools, carve_options);
  MeshOptions mesh_options;
  mesh_options.threads = threads;
  TriMesh mesh = extract_mesh(stock, mesh_options);
  mesh.origin = owner_table(owners_of(MemoryMesh(mesh)), CutList(cuts));
  if (note != nullptr)
    *note = fmt::format("{}: meshed with its voxel of {:.4g} mm", path, recipe.voxel);
  return mesh;
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
  return has_extension(path, ".step") || has_extension(path, ".stp");
}

TriMesh read_solid(const std::string& path, double deflection, int threads, std::string* note) {
  if (is_vdb(path)) return mesh_of_vdb(path, threads, note);
  if (!is_step(path)) return read_mesh(path);
  return read_step(path, deflection, note);
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
