// The stock's surface as a triangle mesh.
#pragma once

#include "mesh/contour.h"
#include "removal/stock.h"
#include <mrsim/options.h>
#include <mrsim/types.h>

namespace mrsim {

/// The part's surface: closed, oriented, 2-manifold, with the owner of each face. Throws Error
/// "part-empty" when nothing is left.
TriMesh extract_mesh(const Stock& stock, const MeshOptions& options = {},
                     ContourReport* report = nullptr);

/// The same in blocks (mesh/contour.h).
void extract_mesh(const Stock& stock, const MeshOptions& options, MeshSink& sink,
                  ContourReport* report = nullptr);

}  // namespace mrsim
