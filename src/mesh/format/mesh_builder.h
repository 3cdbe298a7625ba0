// What the readers of indexed formats have in common: polygons to triangles, checks, welding.
#pragma once

#include "core/process/memory_limit.h"
#include "mesh/format/text_scan.h"
#include <mrsim/types.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace mrsim::detail {

/// Largest coordinate that is read, mm: 10 km. Beyond it, single precision is coarser than a
/// millimetre and distances in a comparison lose their digits.
inline constexpr double kFarthest = 1e7;

/// Text of the error for a coordinate beyond it.
std::string too_far(double coordinate);

/// Before a vector of a file's items grows: throws Error "memory" where its next room, twice as
/// large, does not fit beside the one it has. `bytes`: of an item, with what grows along with it.
template <class T>
void require_growth(const std::vector<T>& items, std::size_t bytes, const std::string& name) {
  constexpr std::size_t kSmall = 4096;
  if (items.size() == items.capacity() && items.size() >= kSmall)
    require_memory(2.0 * double(bytes) * double(items.size()), "reading " + name);
}

/// Builds a mesh from untrusted numbers. Every fault is an Error "<format>-index", "-nan",
/// "-polygon", "-empty" that names the file, or "memory" (core/process/memory_limit.h).
class MeshBuilder {
 public:
  /// `format` is the beginning of error codes, "obj".
  MeshBuilder(std::string format, std::string name)
      : format_(std::move(format)), name_(std::move(name)) {}

  void add_vertex(double x, double y, double z);
  /// Before `vertices` and `triangles` are added: throws Error "<format>-too-large" above 50
  /// million triangles or the vertices these have at most, and "memory". A file of few bytes can
  /// hold many instances of one mesh.
  void expect(std::size_t vertices, std::size_t triangles) const;
  /// A polygon of vertex indices, split into triangles by its ears; polygons of fewer than three
  /// different corners are left out.
  void add_face(std::span<const std::int64_t> corners, std::int32_t owner);
  std::size_t vertex_count() const { return mesh_.vertices.size(); }
  TriMesh& mesh() { return mesh_; }

  /// The mesh. A file that repeats its vertices (each face its own, for normals or textures) is
  /// welded: a solid is to be closed. Owners are dropped when no face has any.
  TriMesh take();

  [[noreturn]] void fail(const char* fault, const std::string& text) const;

 private:
  std::string format_, name_;
  TriMesh mesh_;
  bool has_owners_ = false;
};

}  // namespace mrsim::detail
