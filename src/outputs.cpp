#include "outputs.h"

#include "core/text_io.h"
#include "mesh/mesh_io.h"
#include "mesh/stl.h"
#include <mrsim/mrsim.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr std::string_view kVdb = ".vdb";

}  // namespace

bool is_vdb(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return extension == kVdb;
}

void check_outputs(const std::vector<std::string>& paths) {
  std::set<std::string> seen;
  for (const std::string& path : paths) {
    if (!is_vdb(path)) mesh_format_of(path);
    check_writable(path);
    if (!seen.insert(std::filesystem::absolute(path).lexically_normal().string()).second)
      throw Error("output-twice", fmt::format("{} is given as output twice", path),
                  Error::Kind::usage);
  }
}

std::string whole_output(const std::vector<std::string>& paths) {
  for (const std::string& path : paths) {
    if (is_vdb(path))
      return fmt::format("{} holds the whole grid: without it the run is done in slabs", path);
    if (!is_streamed(mesh_format_of(path)))
      return fmt::format(
          "{} needs the whole mesh: .stl .ply .obj .off and .3mf are written in slabs", path);
  }
  return {};
}

std::string spill_folder(const std::vector<std::string>& paths) {
  if (paths.empty()) return std::filesystem::temp_directory_path().string();
  const std::string folder = std::filesystem::path(paths[0]).parent_path().string();
  return folder.empty() ? "." : folder;
}

struct Outputs::File {
  explicit File(const std::string& path) : draft(path) {}
  DraftFile draft;
  std::unique_ptr<StlStream> stream;  ///< that has taken the blocks
};

Outputs::Outputs(const std::vector<std::string>& paths, const MeshFileOptions& options, int threads)
    : options_(options) {
  for (const std::string& path : paths) {
    File& file = *files_.emplace_back(std::make_unique<File>(path));
    if (!is_vdb(path) && mesh_format_of(path) == MeshFormat::stl && !options.ascii)
      file.stream = std::make_unique<StlStream>(file.draft, threads);
  }
}

Outputs::~Outputs() = default;

void Outputs::take(const MeshBlock& block) {
  for (const auto& file : files_)
    if (file->stream) file->stream->take(block);
}

void Outputs::restart() {
  for (const auto& file : files_)
    if (file->stream) file->stream->restart();
}

void Outputs::complete(File& file, const MeshSource& mesh, const Stock& stock,
                       const StockRecipe& recipe) {
  if (file.stream && !replaced_) return file.stream->finish();
  if (file.stream) file.draft.clear();
  const std::string& path = file.draft.path();
  if (is_vdb(path))
    write_vdb(stock, recipe, file.draft.sink());
  else
    encode_mesh(mesh, mesh_format_of(path), options_, file.draft.sink());
  file.draft.finish();
}

void Outputs::finish(const MeshSource& mesh, const Stock& stock, const StockRecipe& recipe) {
  for (const auto& file : files_) complete(*file, mesh, stock, recipe);
  for (const auto& file : files_) file->draft.publish();
}

TriMesh read_mesh(const std::string& path) { return load_mesh(path); }
void write_mesh(const std::string& path, const TriMesh& mesh) { save_mesh(path, mesh); }

}  // namespace mrsim
