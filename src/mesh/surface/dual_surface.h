// The surface over the leaves of the octree or over a tile: crossings of edges, segments in faces,
// loops in cells, and from them triangles that can not intersect (docs/mesh.md, Surface).
#pragma once

#include "mesh/cells/octree.h"
#include "mesh/cells/tile.h"
#include "mesh/surface/crossing_finder.h"
#include "mesh/surface/loop_finder.h"
#include "mesh/surface/loop_triangles.h"
#include "mesh/surface/surface_graph.h"
#include "mesh/surface/vertex_placer.h"

#include <span>
#include <vector>

namespace mrsim::detail {

class DualSurface {
 public:
  using Options = SurfaceOptions;
  DualSurface(const ExactField& field, const SurfaceCells& cells, const Options& options)
      : graph_(field, cells, options), crossings_(graph_), vertices_(graph_) {}
  DualSurface(const DualSurface&) = delete;
  DualSurface& operator=(const DualSurface&) = delete;

  /// Finds crossings, segments and loops. Requires: the crossings on every face can be joined. Of a
  /// part of the grid (CrossedGrid::complete), triangles are made about the edges that it owns.
  void find_loops(CrossedGrid grid);
  /// find_loops() of a tile, where segments between crossings of one face of the part, which need
  /// no vertex, are left out.
  void find_loops(const CellTile& tile);
  /// Cells that hold more than one loop.
  const std::vector<std::int32_t>& crowded() const { return graph_.crowded; }
  /// Places vertices and makes triangles.
  const BaseMesh& make_triangles();

  /// Draws the surface about an edge at least that finely from the next find_loops() on. Requires:
  /// Options::remember.
  void refine(const Crossing& crossing, Detail detail) { crossings_.refine(crossing, detail); }

  /// Puts the vertices of these cells between their crossings from the next make_triangles() on:
  /// pieces of surface in one cell hardly meet then, but creases in it are cut off. False: all
  /// of them lie there already.
  bool flatten(std::span<const std::int32_t> cells) { return vertices_.flatten(cells); }
  /// As flatten(), for these cells alone: all others get their usual vertices.
  void flatten_only(std::span<const std::int32_t> cells) { vertices_.flatten_only(cells); }

  /// Moves vertices to creases just beyond their cells and faces, as far as no triangles meet, and
  /// takes away triangles that have no area there; vertices may be left that none uses.
  /// Requires: make_triangles(). Costs a test of the whole mesh where there is anything to move.
  void sharpen(const CellOctree& tree);

  const BaseMesh& mesh() const { return mesh_; }
  const std::vector<Crossing>& crossings() const { return graph_.crossings; }
  const std::vector<Loop>& loops() const { return graph_.loops; }

 private:
  SurfaceGraph graph_;
  CrossingFinder crossings_;
  VertexPlacer vertices_;
  BaseMesh mesh_;
};

}  // namespace mrsim::detail
