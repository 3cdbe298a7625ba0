// A mesh whose edges and triangles are cut at points on them, with the neighbours of its triangles.
#pragma once

#include "mesh/simplify/simplify.h"
#include "mesh/solid/half_edges.h"

#include <initializer_list>

namespace mrsim::detail {

/// Half edges are those of mesh/solid/half_edges.h.
class CutMesh {
 public:
  using Corners = std::array<std::uint32_t, 3>;

  CutMesh(const LabelledMesh& from, int threads);

  LabelledMesh mesh;
  /// By triangle: true where the surface has moved, by the rounding of a new point. In a plane on
  /// which one coordinate is constant it never does.
  std::vector<char> moved;
  /// By half edge: the caller's, kept as long as both ends stay; 0 of a new one.
  std::vector<std::int32_t> marks;

  std::uint32_t opposite(std::uint32_t h) const { return opposites_[h]; }
  std::uint32_t from(std::uint32_t h) const { return mesh.triangles[h / 3][h % 3]; }
  std::uint32_t to(std::uint32_t h) const { return from(next_half_edge(h)); }
  std::uint32_t apex(std::uint32_t h) const { return from(previous_half_edge(h)); }
  const Vec3& position(std::uint32_t v) const { return mesh.vertices[v]; }
  /// Its length is twice the area.
  Vec3 normal(std::uint32_t t) const;
  Vec3 middle(std::uint32_t t) const;
  /// mm: over the longest side.
  double height(std::uint32_t t) const;

  /// Cuts the edge and both of its triangles in two, which keep their labels; false where a piece
  /// would face backwards or be too thin. The new triangles are the last two: of the edge's own and
  /// of the other one.
  bool cut_edge(std::uint32_t h, const Vec3& at);
  /// Cuts a triangle in three about a point in it; the new ones are the last two.
  bool cut_triangle(std::uint32_t t, const Vec3& at);
  /// Joins the other two corners of an edge's triangles instead of its ends, where the circle about
  /// one triangle holds the apex of the other one (Delaunay's condition, which keeps triangles from
  /// growing long). Returns whether it did; then the edge's own triangle has the begin of the edge,
  /// the other one its end. Done only in planes on which one coordinate is the same, so that no
  /// surface moves. Requires: both triangles lie in one plane.
  bool flip_edge(std::uint32_t h);

 private:
  bool may_replace(std::uint32_t t, const Vec3& a, const Vec3& b, const Vec3& c) const;
  bool is_horizontal(std::initializer_list<std::uint32_t> corners, const Vec3& at) const;
  std::uint32_t add_vertex(const Vec3& p);
  std::uint32_t add_copy(std::uint32_t t, bool moves);
  /// A half edge as it was before a change of its triangle.
  struct Side {
    std::uint32_t opposite = kBoundaryEdge;
    std::int32_t mark = 0;
  };
  Side side(std::uint32_t h) const { return {opposites_[h], marks[h]}; }
  void place(std::uint32_t h, const Side& side);
  void join(std::uint32_t h, std::uint32_t o);

  std::vector<std::uint32_t> opposites_;
};

}  // namespace mrsim::detail
