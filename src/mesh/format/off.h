// OFF files in their text form.
#pragma once

#include "core/text/text_io.h"
#include "mesh/solid/mesh_source.h"
#include <mrsim/types.h>

#include <string>
#include <string_view>

namespace mrsim {

/// The mesh in the text of an OFF, COFF or NOFF file; colours and normals are passed over. Throws
/// Error "off-syntax", "off-truncated", "off-index", "off-nan", "off-polygon", "off-empty".
TriMesh parse_off(std::string_view text, const std::string& name);

/// Numbers are the shortest that read back to the same float. Owners are lost. Colours are not
/// written: many readers would take them for indices of vertices.
void write_off(const MeshSource& mesh, const ByteSink& out, int threads = 0);
inline void write_off(const TriMesh& mesh, const ByteSink& out) {
  write_off(MemoryMesh(mesh), out);
}

}  // namespace mrsim
