// The stock's surface as a triangle mesh.
#pragma once

#include "mesh/mesh_part.h"
#include "mesh/solid/mesh_plan.h"
#include "removal/part/stock.h"
#include <mrsim/types.h>

namespace mrsim {

/// The part's surface: closed, oriented, 2-manifold, with the owner of each face. Throws as
/// refuse_empty() does where it has none.
TriMesh extract_mesh(const Stock& stock, const MeshPlan& options = {},
                     MeshReport* report = nullptr);

/// extract_mesh() in blocks (mesh/mesh_part.h).
void extract_mesh(const Stock& stock, const MeshPlan& options, MeshSink& sink,
                  MeshReport* report = nullptr);

}  // namespace mrsim
