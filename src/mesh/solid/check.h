// Whether a mesh is what mrsim promises to write and needs to read: the boundary of a solid.
//
// Checked here: indices and coordinates, every edge with two triangles that run through it in
// opposite directions, every vertex with one fan, triangles without area, the sign of the volume.
// Not checked: self-intersection (tests do, with CGAL). About 0.1 s a million triangles.
#pragma once

#include <mrsim/types.h>

#include <string>

namespace mrsim {

/// All figures of the mesh and a sentence about its first fault ("open edge at (0, 0, 10) mm; 4
/// open edges in all"), the same for any number of threads. Never throws for a bad mesh.
MeshSummary check_mesh(const TriMesh& mesh, int threads = 0);

/// Throws Error "mesh-invalid", "mesh-open", "mesh-inverted", "mesh-not-oriented" or
/// "mesh-not-manifold" unless the mesh bounds a solid (which surfaces that touch in a point do),
/// saying what is wrong with file `name`, where, and what to do.
void require_solid(const TriMesh& mesh, const std::string& name, int threads = 0);

/// Signed volume in mm^3, positive when the triangles are counter-clockwise seen from outside.
/// Summed in a fixed order. Requires: indices in range.
double signed_volume(const TriMesh& mesh);

/// Area in mm^2, summed in the order of the triangles. Requires: indices in range.
double surface_area(const TriMesh& mesh);

/// Bounds of the vertices that triangles use.
Box3 mesh_bounds(const TriMesh& mesh);

}  // namespace mrsim
