// Vertices by their exact coordinates, for files that repeat them in every triangle.
#pragma once

#include <mrsim/types.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace mrsim {

/// Gives equal points (bit by bit, -0 equal to 0) the same index, in the order of first use, so
/// that the result depends on the input alone. About 50 ns a point.
class Welder {
 public:
  /// Index of `point`, a new one if it was not seen before. Requires: finite.
  std::uint32_t add(std::array<float, 3> point);
  std::vector<std::array<float, 3>> take() { return std::move(points_); }
  std::size_t size() const { return points_.size(); }

 private:
  void grow();
  std::vector<std::array<float, 3>> points_;
  std::vector<std::uint32_t> slots_;  // open addressing, index + 1, 0 = free
};

/// `mesh` with equal vertices merged, unused ones dropped, and the triangles that thereby lost a
/// side left out. Colours of merged vertices: the first.
TriMesh weld(const TriMesh& mesh);

/// Renumbers the vertices in use without gaps, in ascending order, also in `triangles`. Returns the
/// former number of each.
std::vector<std::uint32_t> number_used(std::vector<std::array<std::uint32_t, 3>>& triangles,
                                       std::size_t vertices);

/// Drops the vertices that no triangle names; the order of the others is kept.
void drop_unused_vertices(TriMesh& mesh);

}  // namespace mrsim
