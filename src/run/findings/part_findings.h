// What a run has to say about its part: diagnostics, pieces and figures of the result.
#pragma once

#include "mesh/extract.h"
#include "removal/part/stock.h"
#include "run/mesh/mesh_choice.h"
#include "run/mesh/mesh_store.h"
#include <mrsim/mrsim.h>

#include <string>

namespace mrsim {

/// A diagnostic of the whole program, without a line.
void report(JobResult& result, Severity severity, const char* code, const std::string& text);

/// Warns where the mesh, coarse or reduced, may decide the verdict instead of the part.
void warn_of_coarse_mesh(const Job& job, JobResult& result);

/// Warns, once for each tool, of threads that turning tools cut: the part has none of them.
void warn_of_threads(JobResult& result);

/// Warns, once for each tool, of tools whose cuts all lie in the air while others cut. Tools that
/// the columns of the history may miss are left out.
void warn_of_idle_tools(JobResult& result, bool stock_assumed);

/// Puts into the result: voxel and tolerance with their reasons; what the mesher found; that the
/// run was done in slabs.
void tell_choice(JobResult& result, const MeshChoice& choice);
void report_mesh(JobResult& result, const MeshReport& found);
void report_slabs(JobResult& result, const MeshStore& part, const Stock& stock);

/// Finds the pieces and drops all but the largest where that was asked for. `in_vdb`: a .vdb is
/// written, which holds all.
void keep_pieces(JobResult& result, MeshStore& part, KeepPieces keep, bool in_vdb);

/// Figures of what is kept. `volume`: of the part, mm^3. Throws
/// InternalError where the mesh is no closed, oriented 2-manifold.
void summarize_part(JobResult& result, MeshStore& part, const CutList& cuts, double volume);

}  // namespace mrsim
