// STL, binary and ASCII.
//
// STL keeps three points a triangle and no more: reading welds points with equal coordinates,
// writing drops owners and colours. Which of the two forms a file has follows from its size and
// content, never by its first word alone (binary files that begin with "solid" exist).
#pragma once

#include "core/text/text_io.h"
#include "mesh/solid/mesh_source.h"
#include <mrsim/types.h>

#include <string>
#include <string_view>

namespace mrsim {

/// The mesh in the bytes of an STL file. `name` is the file's, for messages. Triangles with two
/// equal corners are left out; normals in the file are not looked at. Memory grows with the bytes
/// that are there, never with what a header claims.
/// Throws Error "stl-empty", "stl-truncated", "stl-size", "stl-syntax", "stl-nan".
TriMesh parse_stl(std::string_view bytes, const std::string& name);

/// Binary STL, little-endian on any machine.
void write_stl(const MeshSource& mesh, const ByteSink& out, int threads = 0);
inline void write_stl(const TriMesh& mesh, const ByteSink& out) {
  write_stl(MemoryMesh(mesh), out);
}

/// Writes the bytes of write_stl() while the mesh is made, from its blocks as they come.
class StlStream final : public MeshSink {
 public:
  /// Writes to `draft`, which must outlive it, on `threads` threads.
  StlStream(DraftFile& draft, int threads);
  void take(const MeshBlock& block) override;
  void restart() override;
  /// The count is known, the draft complete. Throws Error "stl-too-large".
  void finish();

 private:
  DraftFile& draft_;
  ByteSink sink_;
  int threads_;
  std::uint64_t triangles_ = 0;
};

/// ASCII STL; numbers are the shortest that read back to the same float.
void write_stl_ascii(const MeshSource& mesh, const ByteSink& out, int threads = 0);
inline void write_stl_ascii(const TriMesh& mesh, const ByteSink& out) {
  write_stl_ascii(MemoryMesh(mesh), out);
}

}  // namespace mrsim
