#include "run/files/outputs.h"

#include "core/output/output_place.h"
#include "core/output/publish.h"
#include "core/output/scratch_file.h"
#include "core/text/ascii.h"
#include "core/text/text_io.h"
#include "mesh/format/mesh_io.h"
#include "mesh/format/stl.h"

#include <filesystem>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr std::string_view kVdb = ".vdb";

std::vector<NamedPath> named_outputs(const Job& job) {
  std::vector<NamedPath> out;
  for (const std::string& path : job.outputs) out.push_back({path, "-o"});
  for (const SideFile& side : job.side_files) out.push_back(side.file);
  return out;
}

void note_file(const DraftFile& draft, bool hash, std::vector<WrittenFile>& written) {
  written.push_back({draft.path(), draft.size(), hash ? draft.sha256() : std::string()});
}

}  // namespace

bool is_vdb(const std::string& path) { return extension_of(path) == kVdb; }

void check_outputs(const Job& job) {
  for (const std::string& path : job.outputs)
    if (!is_vdb(path)) mesh_format_of(path, " .vdb");
  std::vector<NamedPath> inputs = {{job.program, "the program"}, {job.stock, "the stock"}};
  inputs.insert(inputs.end(), job.inputs.begin(), job.inputs.end());
  prepare_outputs(named_outputs(job), inputs);
}

void protect_program_files(const Job& job, const std::vector<std::string>& files) {
  std::vector<NamedPath> inputs;
  for (const std::string& file : files) inputs.push_back({file, "a file of the program"});
  refuse_overwrites(named_outputs(job), inputs);
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
  if (paths.empty()) return temporary_folder();
  const std::string folder = std::filesystem::path(paths[0]).parent_path().string();
  return folder.empty() ? "." : folder;
}

struct PreparedFiles::Files {
  std::vector<std::unique_ptr<DraftFile>> drafts;
  std::vector<SideFile> last;
  bool hash_files = false;

  // Writes the draft of a file that is not a mesh.
  void make(const SideFile& side, JobResult& result) {
    DraftFile& draft = *drafts.emplace_back(std::make_unique<DraftFile>(side.file.path));
    side.write(result, draft.sink());
    draft.finish();
    note_file(draft, hash_files, result.files);
  }
};

PreparedFiles::PreparedFiles() : files_(std::make_unique<Files>()) {}
PreparedFiles::~PreparedFiles() = default;

void PreparedFiles::publish(JobResult& result) {
  for (const SideFile& side : files_->last) files_->make(side, result);
  files_->last.clear();
  std::vector<DraftFile*> all;
  for (const auto& draft : files_->drafts) all.push_back(draft.get());
  mrsim::publish(all);
  files_->drafts.clear();
}

struct Outputs::File {
  explicit File(const std::string& path) : draft(std::make_unique<DraftFile>(path)) {}
  std::unique_ptr<DraftFile> draft;
  std::unique_ptr<StlStream> stream;  ///< has taken the blocks; null: another format
};

Outputs::Outputs(const std::vector<std::string>& paths, const MeshFileOptions& options, int threads)
    : options_(options) {
  for (const std::string& path : paths) {
    File& file = *files_.emplace_back(std::make_unique<File>(path));
    if (!is_vdb(path) && mesh_format_of(path) == MeshFormat::stl && !options.ascii)
      file.stream = std::make_unique<StlStream>(*file.draft, threads);
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

void Outputs::complete_file(File& file, const MeshSource& mesh, const Stock& stock,
                            const StockRecipe& recipe) {
  if (file.stream && !replaced_) return file.stream->finish();
  if (file.stream) file.draft->clear();
  const std::string& path = file.draft->path();
  if (is_vdb(path))
    write_vdb(stock, recipe, file.draft->sink());
  else
    encode_mesh(mesh, mesh_format_of(path), options_, file.draft->sink());
  file.draft->finish();
}

void Outputs::complete(const MeshSource& mesh, const Stock& stock, const StockRecipe& recipe,
                       bool hash, std::vector<WrittenFile>& written) {
  for (const auto& file : files_) {
    complete_file(*file, mesh, stock, recipe);
    note_file(*file->draft, hash, written);
  }
}

void Outputs::prepare(const Job& job, JobResult& result, PreparedFiles& prepared) {
  PreparedFiles::Files& all = *prepared.files_;
  all.hash_files = all.hash_files || job.hash_files;
  for (const auto& file : files_) {
    file->stream.reset();
    all.drafts.push_back(std::move(file->draft));
  }
  files_.clear();
  for (const SideFile& side : job.side_files) {
    if (side.is_last)
      all.last.push_back(side);
    else
      all.make(side, result);
  }
}

TriMesh read_mesh(const std::string& path) { return load_mesh(path); }
void write_mesh(const std::string& path, const TriMesh& mesh) { save_mesh(path, mesh); }
void encode_mesh(const TriMesh& mesh, const std::string& name, const ByteSink& sink) {
  encode_mesh(MemoryMesh(mesh), mesh_format_of(name), {}, sink);
}

}  // namespace mrsim
