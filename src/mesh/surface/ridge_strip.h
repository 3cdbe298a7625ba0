// The strips of triangles in which a mesh of cells ends short of a sharp ridge, drawn out to the
// ridge: their vertices are moved there, and what then has no area is taken away (docs/mesh.md,
// Vertices).
#pragma once

#include "mesh/points/surface_search.h"

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace mrsim::detail {

/// A vertex that goes to a ridge, or lies on one beside such a vertex; or a smooth point beside it
/// that the mesh can do without.
struct RidgeVertex {
  std::uint32_t vertex = 0;
  SurfacePoint point;  ///< where it goes or lies; count = 1: a smooth point
  bool moves = false;
};

/// A closed mesh without intersections, while some of its vertices are moved and joined. A vertex
/// that makes triangles meet is put back, together with all that were joined into it.
class RidgeStrip {
 public:
  /// Normal of the face of the part that a triangle, by its number, was made for.
  using NormalOf = std::function<Vec3(std::uint32_t)>;

  /// Moves the vertices of `ridge` that `moves` says to their points.
  RidgeStrip(std::vector<Vec3>& vertices, std::vector<std::array<std::uint32_t, 3>>& triangles,
             std::vector<RidgeVertex> ridge, NormalOf normal_of, int threads);

  /// Joins vertices along a ridge where triangles have all their corners on it or have been turned
  /// over; the shortest sides first. Costs n log n of those triangles.
  void join();
  /// Puts vertices back until no triangles meet; after some rounds, all vertices. Costs a test of
  /// the whole mesh.
  void put_back_crossed();

  struct Left {
    std::vector<std::uint32_t> triangles;  ///< the numbers of those that are left, ascending
    std::vector<std::uint32_t> near;       ///< among them, those about ridges, by new numbers
  };
  /// Takes away the triangles that have no area.
  Left finish();
  /// What is known of a vertex; null where it was put back, and for others.
  const SurfacePoint* find(std::uint32_t vertex) const;

 private:
  using Triangle = std::array<std::uint32_t, 3>;

  std::int32_t index_of(std::uint32_t vertex) const { return index_[vertex]; }
  const RidgeVertex& of(std::int32_t index) const {
    return ridge_[static_cast<std::size_t>(index)];
  }
  std::uint32_t now(std::uint32_t vertex) const;
  Triangle now(const Triangle& x) const { return {now(x[0]), now(x[1]), now(x[2])}; }
  bool is_spoiled(std::uint32_t triangle) const;
  bool looks_away(std::uint32_t triangle, const Triangle& x) const;
  void find_stars();
  void touch(std::span<const std::int32_t> indices);
  bool has_corner(std::uint32_t triangle, std::span<const char> flags) const;
  std::vector<std::uint32_t> star(std::int32_t index) const;
  bool join_if(std::int32_t from, std::int32_t to, bool must_be_spoiled);
  // Each of these steps returns whether it has changed anything.
  bool join_neighbour(std::int32_t index);
  bool put_back(std::int32_t index);
  bool put_back_corners(std::uint32_t triangle);
  bool put_back_flat();
  bool put_back_doubled();
  bool put_back_meeting();

  std::vector<Vec3>& vertices_;
  std::vector<Triangle>& triangles_;
  std::vector<RidgeVertex> ridge_;
  NormalOf normal_of_;
  int threads_;
  std::vector<std::int32_t> index_;                 ///< by vertex: its index in `ridge_`, -1 = none
  std::vector<Vec3> before_;                        ///< by index, as all below
  std::vector<std::int32_t> joined_;                ///< the index that it was joined into
  std::vector<std::vector<std::int32_t>> members_;  ///< all indices joined into it, and itself
  std::vector<std::uint32_t> first_, stars_;        ///< triangles about each, before joining
  std::vector<char> fresh_;               ///< moved, joined or put back since the last test
  std::vector<char> touched_, reset_;     ///< at any time; put back at any time
  std::vector<char> is_back_, has_slid_;  ///< back to its old place; to its neighbour's
  std::vector<std::uint32_t> near_;       ///< triangles about all of them, ascending
};

}  // namespace mrsim::detail
