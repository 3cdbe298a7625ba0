// The mesh of a run: within its tolerance or on the grid, as it was chosen and as memory allows;
// and made smaller where the job limits its triangles.
#pragma once

#include "mesh/cells/mesh_report.h"
#include "mesh/solid/mesh_plan.h"
#include "removal/part/stock.h"
#include "run/files/outputs.h"
#include "run/mesh/mesh_choice.h"
#include "run/mesh/mesh_store.h"
#include <mrsim/mrsim.h>

#include <optional>
#include <string>

namespace mrsim {

/// Why a run whose mesh has that tolerance (mm, 0 = none) cannot be done in slabs, should memory be
/// short; empty: it can.
std::string no_slabs(const Job& job, double tolerance);

/// Makes the mesh of a run. In the end `choice` holds the voxel and the tolerance of that mesh.
class MeshMaker {
 public:
  /// `next` takes the blocks too. `threads`: of what is done with a block while others are made.
  MeshMaker(const Job& job, Stock& stock, MeshChoice& choice, MeshSink& next, int threads)
      : job_(job), stock_(stock), choice_(choice), next_(next), threads_(threads) {}

  /// The mesh as it was chosen, or on a grid where that is given up. Throws what mesh_part() does,
  /// and "memory".
  MeshReport make();
  /// Requires: make().
  MeshStore& part() { return *part_; }
  /// Bytes that the run was expected to take at its peak.
  double memory() const { return memory_; }

 private:
  MeshReport extract(MeshPlan plan);
  MeshReport extract_grid(const MeshPlan& plan);

  const Job& job_;
  Stock& stock_;
  MeshChoice& choice_;
  MeshSink& next_;
  int threads_;
  std::optional<MeshStore> part_;
  double memory_ = 0;
};

/// mm^3. Exact where the stock is a primitive; a stock that has been cut before is meshed as it
/// was.
double volume_before(const Job& job, const StockShape& shape, const MeshChoice& choice);

/// Reduces the mesh where it has more triangles than the job allows, and measures the distance
/// between both meshes into result.reduction. Returns whether it did. Throws Error "max-triangles",
/// which names a number that is possible, where no sound mesh is that small.
bool reduce_part(const Job& job, JobResult& result, MeshStore& part, Outputs& outputs);

}  // namespace mrsim
