// GLB (binary glTF 2.0), for browsers and Blender.
//
// Positions are 16 bit steps of the longest side (KHR_mesh_quantization: 1.5 micrometres for a part
// of 100 mm), normals 8 bit, split at edges; the part stands in metres with Y up, as glTF wants it,
// by its node's transform. Faces carry their owner in the vertex attribute _OWNER (float, -1 =
// stock), what owners stand for is in the mesh's extras: {"mrsim": {"files": [..], "tools": [..],
// "origins": [[owner, file, line, tool], ..]}}. For measuring take PLY or STL instead.
#pragma once

#include "core/text_io.h"
#include <mrsim/options.h>
#include <mrsim/types.h>

namespace mrsim {

/// Largest distance in mm between a vertex and its place in the GLB file.
double glb_max_error(const TriMesh& mesh);

/// Throws Error "glb-too-large" above 4 GB.
void write_glb(const TriMesh& mesh, const MeshFileOptions& options, const ByteSink& out);

}  // namespace mrsim
