#include "mesh/solid/wrap.h"

#include "core/numbers/triangle_tree.h"
#include "core/numbers/vec.h"
#include "core/process/error.h"
#include "mesh/solid/check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_mesh_to_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/alpha_wrap_3.h>
#include <fmt/format.h>

namespace mrsim {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using SurfaceMesh = CGAL::Surface_mesh<Point>;
using Face = std::array<std::size_t, 3>;

constexpr double kUsualGap = 10;  // distances
constexpr double kOffset = 0.5;   // of the distance: where the wrap is made
constexpr double kFinest = 10;    // offsets: side of the triangles, where no gap is narrower
constexpr double kLeft = 0.02;  // of the offset: at least this stays, so that no triangle collapses
constexpr double kMostTriangles = 2e6;
constexpr std::size_t kMostCorners = 2000;  // of an opening: larger ones take long to triangulate

struct Soup {
  std::vector<Point> points;
  std::vector<Face> faces;
};

TriMesh to_mesh(const Soup& soup) {
  TriMesh out;
  for (const Point& p : soup.points)
    out.vertices.push_back({float(p.x()), float(p.y()), float(p.z())});
  for (const Face& f : soup.faces)
    out.triangles.push_back({std::uint32_t(f[0]), std::uint32_t(f[1]), std::uint32_t(f[2])});
  return out;
}

// The triangles with corners apart, joined where they have corners in one place.
Soup clean_soup(const TriMesh& mesh) {
  Soup soup;
  for (const auto& v : mesh.vertices) soup.points.emplace_back(v[0], v[1], v[2]);
  for (const auto& t : mesh.triangles) soup.faces.push_back({t[0], t[1], t[2]});
  pmp::merge_duplicate_points_in_polygon_soup(soup.points, soup.faces);
  std::erase_if(soup.faces, [&](const Face& f) {
    return CGAL::collinear(soup.points[f[0]], soup.points[f[1]], soup.points[f[2]]);
  });
  pmp::remove_isolated_points_in_polygon_soup(soup.points, soup.faces);
  return soup;
}

double side_of(const SurfaceMesh& mesh, SurfaceMesh::Halfedge_index border) {
  Box3 box;
  for (const auto v : CGAL::vertices_around_face(border, mesh)) {
    const Point& p = mesh.point(v);
    extend(box, Vec3{p.x(), p.y(), p.z()});
  }
  const Vec3 size = box.hi - box.lo;
  return std::max({size.x, size.y, size.z});
}

bool is_lone_triangle(const SurfaceMesh& mesh, SurfaceMesh::Halfedge_index border) {
  const auto face = mesh.face(mesh.opposite(border));
  const auto sides = CGAL::halfedges_around_face(border, mesh);
  return std::all_of(sides.begin(), sides.end(), [&](SurfaceMesh::Halfedge_index side) {
    return mesh.face(mesh.opposite(side)) == face;
  });
}

// Triangles in the openings of the surface.
void close_openings(Soup& soup, Wrap& out) {
  pmp::orient_polygon_soup(soup.points, soup.faces);
  SurfaceMesh mesh;
  pmp::polygon_soup_to_polygon_mesh(soup.points, soup.faces, mesh);
  pmp::stitch_borders(mesh);
  std::vector<SurfaceMesh::Halfedge_index> borders;
  pmp::extract_boundary_cycles(mesh, std::back_inserter(borders));
  for (const SurfaceMesh::Halfedge_index border : borders) {
    const auto corners = CGAL::halfedges_around_face(border, mesh);
    if (std::size_t(std::distance(corners.begin(), corners.end())) > kMostCorners) continue;
    if (is_lone_triangle(mesh, border)) continue;
    const double side = side_of(mesh, border);
    std::vector<SurfaceMesh::Face_index> added;
    pmp::triangulate_hole(mesh, border, std::back_inserter(added));
    if (added.empty()) continue;
    ++out.openings;
    out.widest = std::max(out.widest, side);
  }
  soup = {};
  pmp::polygon_mesh_to_polygon_soup(mesh, soup.points, soup.faces);
}

[[noreturn]] void no_solid() {
  throw Error("stock-wrap", "--stock-repair: no solid was found round the stock's surface");
}

double offset_of(const StockWrap& options) { return kOffset * options.distance; }

double alpha_of(const StockWrap& options) {
  return 0.5 * (options.gap > 0 ? options.gap : kUsualGap * options.distance);
}

// Side of the smallest triangles, mm.
double finest_of(const StockWrap& options) {
  return std::min(alpha_of(options), kFinest * offset_of(options));
}

// What decides how many triangles a wrap takes: its area, and its length, since a needle has hardly
// any area.
class Extent {
 public:
  explicit Extent(const TriMesh& mesh) : by_area_(4 * surface_area(mesh)) {
    constexpr double kRound = 12;  // triangles round a needle
    const Box3 box = mesh_bounds(mesh);
    const Vec3 size = box.hi - box.lo;
    by_length_ = kRound * std::max({size.x, size.y, size.z});
  }
  double triangles(double side) const { return by_area_ / (side * side) + by_length_ / side; }
  // The side at which there are so many triangles.
  double side(double triangles) const {
    return (by_length_ + std::sqrt(by_length_ * by_length_ + 4 * by_area_ * triangles)) /
           (2 * triangles);
  }

 private:
  double by_area_, by_length_ = 0;
};

void require_few_triangles(const TriMesh& mesh, const StockWrap& options) {
  const double side = Extent(mesh).side(kMostTriangles);
  if (finest_of(options) >= side) return;
  const bool by_gap = alpha_of(options) < kFinest * offset_of(options);
  constexpr double kRounded = 1.06;  // so that two digits do not tell less
  throw Error("stock-wrap",
              fmt::format("--stock-repair wrap={:g} would take more than {:g} triangles: {} {:.2g} "
                          "mm or more",
                          options.distance, kMostTriangles, by_gap ? "a gap of" : "a wrap of",
                          kRounded * (by_gap ? 2 * side : side / (kFinest * kOffset))),
              Error::Kind::usage);
}

}  // namespace

double wrapped_triangles(const TriMesh& mesh, const StockWrap& options) {
  return Extent(mesh).triangles(finest_of(options));
}

Wrap wrap_surface(const TriMesh& mesh, const StockWrap& options) {
  Wrap out;
  try {
    Soup soup = clean_soup(mesh);
    if (soup.faces.empty()) no_solid();
    close_openings(soup, out);
    out.closed = to_mesh(soup);
    require_few_triangles(out.closed, options);
    SurfaceMesh wrap;
    CGAL::alpha_wrap_3(soup.points, soup.faces, alpha_of(options), offset_of(options), wrap);
    Soup wrapped;
    pmp::polygon_mesh_to_polygon_soup(wrap, wrapped.points, wrapped.faces);
    if (wrapped.faces.empty()) no_solid();
    const TriangleTree tree(out.closed);
    for (Point& p : wrapped.points) {
      const Vec3 at{p.x(), p.y(), p.z()};
      const Vec3 on = tree.nearest(at).point, moved = on + kLeft * (at - on);
      p = {moved.x, moved.y, moved.z};
    }
    out.solid = to_mesh(wrapped);
  } catch (const CGAL::Failure_exception&) {
    no_solid();
  }
  return out;
}

}  // namespace mrsim
