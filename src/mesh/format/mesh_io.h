// Mesh files by extension.
#pragma once

#include "core/text/text_io.h"
#include "mesh/solid/mesh_source.h"
#include <mrsim/options.h>
#include <mrsim/types.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace mrsim {

enum class MeshFormat : std::uint8_t { stl, obj, ply, off, threemf, glb };

/// The format that a file name ends in, whatever its case. Throws Error "mesh-format" of kind usage
/// that lists the known ones, and `also`, those that the caller takes beside them (" .vdb").
MeshFormat mesh_format_of(const std::string& path, std::string_view also = "");

/// Mesh in the bytes of a file of that format; `name` for messages. Throws what the format throws.
TriMesh parse_mesh(std::string_view bytes, MeshFormat format, const std::string& name);

/// Whether a file of that format is written from a mesh that is not in memory.
bool is_streamed(MeshFormat format);

/// The bytes of a file of that format, which do not depend on the blocks of the mesh. Requires: the
/// mesh is in memory where the format is not streamed.
void encode_mesh(const MeshSource& mesh, MeshFormat format, const MeshFileOptions& options,
                 const ByteSink& out);

/// Reads a file. Throws what read_file and the format throw.
TriMesh load_mesh(const std::string& path);

/// Writes a file whole or not at all. Throws Error "mesh-empty" for a mesh without triangles and
/// what write_file_atomically throws.
void save_mesh(const std::string& path, const TriMesh& mesh, const MeshFileOptions& options = {});

}  // namespace mrsim
