// GLB (binary glTF 2.0), for browsers and Blender.
//
// Positions are exact, in mm; normals have 8 bit (KHR_mesh_quantization) and are split at edges.
// glTF wants metres with Y up: the matrix of the part's node scales and turns it. Faces carry their
// owner in the vertex attribute _OWNER (float, -1 = stock); the mesh's extras say what owners are:
// {"mrsim": {"files": [..], "tools": [..], "origins": [[owner, file, line, tool], ..]}}, with
// "legend": [[r, g, b, text], ..] where vertices have colours.
#pragma once

#include "core/text/text_io.h"
#include <mrsim/options.h>
#include <mrsim/types.h>

#include <string>
#include <string_view>

namespace mrsim {

/// The triangles of the scene of any GLB file, transforms of its nodes applied, in mm with Z up.
/// Colours are read where a legend explains them. Throws Error "glb-syntax", "glb-truncated",
/// "glb-unsupported" (compression, other files), "glb-index", "glb-nan", "glb-empty",
/// "glb-too-large" (more than 50 million triangles by repetition).
TriMesh parse_glb(std::string_view bytes, const std::string& name);

/// Throws Error "glb-too-large" above 4 GB.
void write_glb(const TriMesh& mesh, const MeshFileOptions& options, const ByteSink& out);

}  // namespace mrsim
