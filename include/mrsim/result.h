/// mrsim: what simulate() has found and made: the part's figures, its mesh, and what each default
/// was.
#pragma once

#include <mrsim/collisions.h>
#include <mrsim/cycle_time.h>
#include <mrsim/history.h>
#include <mrsim/play.h>
#include <mrsim/types.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace mrsim {

/// A file that a run has written.
struct WrittenFile {
  std::string path;
  std::uint64_t bytes = 0;
  std::string sha256;  ///< where Job::hash_files asks for it
};

/// One of the pieces that no material joins.
struct PartPiece {
  double volume = 0;  ///< mm^3, cavities subtracted
  Vec3 center;        ///< centre of volume, mm
  Box3 bounds;        ///< mm
  std::size_t triangles = 0;
  bool kept = true;  ///< false: dropped by Job::keep, and not in JobResult::mesh
};

/// What Job::max_triangles did to the mesh.
struct MeshReduction {
  std::size_t before = 0;  ///< triangles; 0: the mesh was not reduced
  /// mm: the largest distance of a point of either mesh, before and after, from the other one lies
  /// between these.
  double least = 0, most = 0;
  Vec3 place;  ///< where `least` was found
};

/// What StockOptions::wrap made of the stock's mesh.
struct StockRepair {
  bool wrapped = false;
  std::size_t openings = 0;  ///< closed with triangles between their corners
  double widest = 0;         ///< mm: the largest side of those
  /// mm: the largest distance of a point of the wrap, or of the surface with its openings closed,
  /// from the other one lies between these.
  double least = 0, most = 0;
  Vec3 place;  ///< where `least` was found
};

/// A wall (material between air) or gap that the mesh does not hold, or may not hold.
struct ThinPlace {
  Vec3 place;  ///< mm, on or in it
  bool wall = false;
  double thickness = 0;  ///< mm
};

struct JobResult {
  Program program;   ///< with all diagnostics, those of later stages too
  StockShape stock;  ///< as simulated, without its mesh
  StockRepair stock_repair;
  double voxel = 0;  ///< mm
  std::string voxel_reason;
  double tolerance = 0;  ///< mm, 0 = the mesh has the grid of the voxels
  std::string tolerance_reason;
  /// mm: certified distance between mesh and part; 0 where the voxel was given. By default it may
  /// be that of the grid's triangles from the part; then mesh_usual holds for 99 % of them. Both
  /// are of the mesh before its reduction.
  double mesh_bound = 0, mesh_usual = 0;
  /// Triangles whose distance from the exact part is sampled, not proven.
  std::size_t mesh_sampled = 0;
  /// Vertices that stay because the mesh would meet itself without them.
  std::size_t mesh_kept = 0;
  /// What mesh_bound does not hold for, the thickest first.
  std::vector<ThinPlace> thin;
  std::size_t rapid_motions = 0, line_motions = 0, arc_motions = 0;
  CycleTime cycle;                  ///< how long the machine takes
  History history;                  ///< what the motions remove
  Play play;                        ///< the stock at every moment, where Job::play asks for it
  std::size_t cutting_motions = 0;  ///< lines and arcs whose start is known
  std::size_t active_voxels = 0;    ///< 0 where none were sampled: a .vdb alone needs them
  CollisionReport collisions;       ///< each a warning among the diagnostics as well
  TriMesh mesh;                     ///< empty where the run was done in slabs
  std::size_t triangles = 0;        ///< of the part
  std::size_t slabs = 0;            ///< 0: the mesh was in memory
  MeshSummary summary;
  MeshReduction reduction;
  std::vector<PartPiece> pieces;  ///< of the part as cut, the largest first; usually one
  /// mm^3, of the exact part where the mesh has a tolerance and no piece was dropped (docs/mesh.md,
  /// Volume), else of the mesh (summary.volume); pieces that were dropped count as removed.
  double volume = 0, stock_volume = 0, removed_volume = 0;
  std::vector<std::pair<std::string, double>> stage_seconds;  ///< in the order they ran
  std::size_t peak_memory = 0;                                ///< bytes
  std::size_t expected_memory = 0;  ///< bytes, as estimated before the mesh was made
  std::vector<WrittenFile> files;   ///< outputs, then side files, as far as they are complete
  bool ok = false;                  ///< false: the program has errors, nothing was written
};

}  // namespace mrsim
