// 3MF: a ZIP archive with an XML model.
//
// Written without identifiers or times of its own, so that equal meshes give equal bytes. Owners
// are base materials, one each, named "PRIMER_2F.MPF:12, tool 4" with the colour asked for; what
// they stand for is kept in a metadata entry besides.
#pragma once

#include "core/text/text_io.h"
#include "mesh/solid/mesh_source.h"
#include <mrsim/options.h>
#include <mrsim/types.h>

#include <string>
#include <string_view>

namespace mrsim {

/// The objects of the build of a 3MF file (all objects where it builds none), components and
/// transforms applied, in mm. Throws Error "3mf-zip", "3mf-too-large" (more than 1 GB unpacked,
/// more than 50 million triangles by repetition), "3mf-xml", "3mf-index", "3mf-nan", "3mf-empty",
/// "3mf-unsupported" (parts in other files, encrypted content).
TriMesh parse_3mf(std::string_view bytes, const std::string& name);

void write_3mf(const MeshSource& mesh, ColorBy color, const ByteSink& out, int threads = 0);
inline void write_3mf(const TriMesh& mesh, ColorBy color, const ByteSink& out) {
  write_3mf(MemoryMesh(mesh), color, out);
}

}  // namespace mrsim
