// Wavefront OBJ: one group a face owner, its origin in a comment.
#pragma once

#include "core/text/text_io.h"
#include "mesh/solid/mesh_source.h"
#include <mrsim/types.h>

#include <string>
#include <string_view>

namespace mrsim {

/// The mesh in the text of an OBJ file: vertices (with colours, where all have them), faces of any
/// polygon, relative indices, and the owners of files that mrsim wrote. Normals, textures,
/// materials and curves are passed over. Throws Error "obj-syntax", "obj-index", "obj-nan",
/// "obj-polygon", "obj-empty".
TriMesh parse_obj(std::string_view text, const std::string& name);

/// Text; numbers are the shortest that read back to the same float. Faces of one owner follow one
/// another only where the mesh has them so: order and indices are those of the mesh.
void write_obj(const MeshSource& mesh, const ByteSink& out, int threads = 0);
inline void write_obj(const TriMesh& mesh, const ByteSink& out) {
  write_obj(MemoryMesh(mesh), out);
}

}  // namespace mrsim
