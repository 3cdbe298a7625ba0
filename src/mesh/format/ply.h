// PLY: the format that keeps everything mrsim knows of a face.
//
// Written as binary little-endian. Faces have the properties owner, file, line and tool (int;
// numbers of the lists of files and tools in the header's comments, -1 = unknown) and, where
// asked for, red, green, blue. Vertices have colours where the mesh has them (deviation), and the
// header's comments say what the colours stand for.
#pragma once

#include "core/text/text_io.h"
#include "mesh/solid/mesh_source.h"
#include <mrsim/options.h>
#include <mrsim/types.h>

#include <string>
#include <string_view>

namespace mrsim {

/// The mesh in the bytes of a PLY file, text or binary of either order, any property types;
/// elements and properties that mean nothing here are passed over. Throws Error "ply-syntax",
/// "ply-truncated", "ply-index", "ply-nan", "ply-polygon", "ply-empty".
TriMesh parse_ply(std::string_view bytes, const std::string& name);

void write_ply(const MeshSource& mesh, ColorBy color, const ByteSink& out, int threads = 0);
inline void write_ply(const TriMesh& mesh, ColorBy color, const ByteSink& out) {
  write_ply(MemoryMesh(mesh), color, out);
}

}  // namespace mrsim
