// What simulate() writes: files by their extension, all of them or none.
#pragma once

#include "mesh/solid/mesh_source.h"
#include "removal/part/stock.h"
#include "removal/part/stock_file.h"
#include <mrsim/mrsim.h>

#include <memory>
#include <string>
#include <vector>

namespace mrsim {

/// Whether the name ends in .vdb: a stock with its recipe rather than a mesh.
bool is_vdb(const std::string& path);

/// Whether the name ends in .step or .stp.
bool is_step(const std::string& path);

/// Finds faults of output names before any work: an unknown format, a folder that is missing or
/// read-only, an output that is an input or another output. Settles what a run that was killed left
/// in the folders. Throws Error "mesh-format", "output-is-input", "output-twice" (usage),
/// "output-...".
void check_outputs(const Job& job);

/// The files of the program that were found while it was read, beside the one that was named.
void protect_program_files(const Job& job, const std::vector<std::string>& files);

/// Why these outputs can not be written in slabs; empty: they can.
std::string whole_output(const std::vector<std::string>& paths);

/// Where the mesh may be kept while it is made: the folder of the first output.
std::string spill_folder(const std::vector<std::string>& paths);

/// The files of a run, none of which appears before all are complete. An STL is written while the
/// mesh is made, the others in finish().
class Outputs final : public MeshSink {
 public:
  /// `threads`: for files that are written while the mesh is made.
  Outputs(const std::vector<std::string>& paths, const MeshFileOptions& options, int threads);
  ~Outputs() override;
  Outputs(const Outputs&) = delete;
  Outputs& operator=(const Outputs&) = delete;

  void take(const MeshBlock& block) override;
  void restart() override;
  /// The mesh is not the one whose blocks came.
  void replace_mesh() { replaced_ = true; }
  /// Completes the part's files; none is seen yet. `written` gets them.
  void complete(const MeshSource& mesh, const Stock& stock, const StockRecipe& recipe, bool hash,
                std::vector<WrittenFile>& written);
  /// Makes the side files of `job` and gives all of them to `prepared`.
  void prepare(const Job& job, JobResult& result, PreparedFiles& prepared);

 private:
  struct File;
  void complete_file(File& file, const MeshSource& mesh, const Stock& stock,
                     const StockRecipe& recipe);
  MeshFileOptions options_;
  std::vector<std::unique_ptr<File>> files_;
  bool replaced_ = false;
};

}  // namespace mrsim
