/// mrsim: what simulate() is asked for: a program, a stock, what is to be made of them and where it
/// is to be written. Every member but the program has a default.
#pragma once

#include <mrsim/cycle_time.h>
#include <mrsim/files.h>
#include <mrsim/history.h>
#include <mrsim/options.h>
#include <mrsim/types.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace mrsim {

struct JobResult;

/// A file that a run writes besides the part: it appears together with the outputs, or none does.
struct SideFile {
  NamedPath file;  ///< "-" is the standard output; the role is what messages call it, "--report"
  /// Called once the part's files are complete, in the order of Job::side_files.
  std::function<void(const JobResult& result, const ByteSink& sink)> write;
  bool is_last = false;  ///< lists all files: made when PreparedFiles are published
};

/// Files of one run or of several, complete but not yet in their places. They lie on the disk
/// without names, each with an open descriptor, and are gone if nobody publishes them.
class MRSIM_API PreparedFiles {
 public:
  PreparedFiles();
  ~PreparedFiles();
  PreparedFiles(const PreparedFiles&) = delete;
  PreparedFiles& operator=(const PreparedFiles&) = delete;
  /// Makes the last ones of `result`, whose `files` they join; then all take their places, or none
  /// does and an Error is thrown.
  void publish(JobResult& result);

 private:
  friend class Outputs;
  struct Files;
  std::unique_ptr<Files> files_;
};

struct Job {
  std::string program;
  InterpOptions interp;
  /// As load_stock takes it. Empty: the stock that the program states, or else a box around its
  /// cuts, on lathes a bar; reported.
  std::string stock;
  StockOptions stock_options;
  CarveOptions carve;
  CollisionOptions collisions;
  MeshOptions mesh;
  std::vector<std::string> outputs;  ///< files to write, format by extension; may be empty
  MeshFileOptions files;             ///< colours and such of the mesh files among them
  std::vector<SideFile> side_files;  ///< written together with the outputs
  /// Gets the files of the run, which appear when it is published; nullptr: at the end of the run.
  PreparedFiles* prepared = nullptr;
  std::vector<NamedPath> inputs;  ///< further files that no output may overwrite
  bool hash_files = false;        ///< fill WrittenFile::sha256
  /// Pieces that the program cuts loose: kept, with a warning, or dropped but for the largest, with
  /// a note. A .vdb among the outputs holds them all: it is the stock and its cuts.
  KeepPieces keep = KeepPieces::all;
  /// Most triangles of the mesh, 0 = any number. More are reduced, and the distance that makes is
  /// measured: JobResult::reduction. Error "max-triangles" where no sound mesh is that small. The
  /// run is not done in slabs, and a .vdb does not change.
  std::size_t max_triangles = 0;
  /// The moment at which the program ends: "12" (a line), "O100:7" (a line of another file) or
  /// "#5000" (a motion); empty: its end. The stock and the tools are those of the whole program.
  std::string until;
  /// What each motion removes is found, too, for JobResult::history.
  HistoryDetail history = HistoryDetail::summary;
  bool play = false;    ///< JobResult::play is made, for a page that plays the run
  MachineData machine;  ///< what decides how long the program takes
  bool strict = false;  ///< warnings are errors
  /// Tolerance of the part in mm that the mesh will be judged by; 0 = none. Where neither a voxel
  /// nor a tolerance of the mesh is given, the mesh keeps to a quarter of it.
  double accept = 0;
  /// Sees the part before anything is written; what it throws ends the run. Default: nothing.
  std::function<void(const TriMesh& part)> inspect;
  /// The whole mesh is wanted, in JobResult or by `inspect`. false: a run that does not fit into
  /// memory is done in slabs where it can be, with the same files; JobResult::mesh is then empty.
  bool whole_mesh = true;
};

}  // namespace mrsim
