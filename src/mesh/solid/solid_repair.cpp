#include "mesh/solid/solid_repair.h"

#include "core/numbers/vec.h"
#include "core/text/counted.h"
#include "mesh/solid/check.h"
#include "mesh/solid/double_faces.h"
#include "mesh/solid/half_edges.h"
#include "mesh/solid/pieces.h"
#include "mesh/solid/self_intersection.h"
#include "mesh/solid/weld.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>
#include <CGAL/Surface_mesh.h>
#include <boost/iterator/function_output_iterator.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace mrsim {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using SurfaceMesh = CGAL::Surface_mesh<Point>;
using Triangle = std::array<std::uint32_t, 3>;

// Vertices of open edges that are this many float steps of the largest coordinate apart are one.
constexpr float kWeldSteps = 8;
constexpr std::uint32_t kUnused = ~0u;

bool is_solid(const TriMesh& mesh) { return check_mesh(mesh).oriented; }

float weld_distance(const TriMesh& mesh) {
  float largest = 0;
  for (const auto& v : mesh.vertices)
    for (const float x : v) largest = std::max(largest, std::fabs(x));
  return kWeldSteps * (std::nextafter(largest, std::numeric_limits<float>::infinity()) - largest);
}

std::vector<std::uint32_t> border_vertices(const TriMesh& mesh) {
  const std::vector<std::uint32_t> opposite = find_opposites(mesh, 1);
  std::vector<std::uint32_t> found;
  for (std::uint32_t h = 0; h < opposite.size(); ++h)
    if (opposite[h] == kBoundaryEdge)
      found.insert(found.end(), {origin_of(mesh, h), target_of(mesh, h)});
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

// Moves vertices of open edges onto an earlier one beside them, along x.
void join_borders(TriMesh& mesh) {
  std::vector<std::uint32_t> border = border_vertices(mesh);
  const float reach = weld_distance(mesh);
  std::stable_sort(border.begin(), border.end(), [&](std::uint32_t a, std::uint32_t b) {
    return mesh.vertices[a][0] < mesh.vertices[b][0];
  });
  for (std::size_t i = 0; i < border.size(); ++i)
    for (std::size_t j = i; j-- > 0;) {
      const auto &p = mesh.vertices[border[j]], &q = mesh.vertices[border[i]];
      if (q[0] - p[0] > reach) break;
      if (std::fabs(q[1] - p[1]) > reach || std::fabs(q[2] - p[2]) > reach) continue;
      mesh.vertices[border[i]] = p;
      break;
    }
}

// Whether bodies that are closed each touch in the same triangles, or are there twice.
bool bodies_coincide(const TriMesh& mesh, const MeshSummary& summary) {
  if (summary.components < 2) return false;
  TriMesh welded = weld(mesh);
  return drop_doubles(welded) > 0 || drop_touching(welded) > 0;
}

SurfaceMesh to_surface(const TriMesh& mesh) {
  std::vector<Point> points;
  for (const auto& v : mesh.vertices) points.emplace_back(v[0], v[1], v[2]);
  std::vector<std::vector<std::size_t>> faces;
  for (const Triangle& t : mesh.triangles) faces.push_back({t[0], t[1], t[2]});
  pmp::orient_polygon_soup(points, faces);  // where sheets touch, points become several
  SurfaceMesh surface;
  pmp::polygon_soup_to_polygon_mesh(points, faces, surface);
  return surface;
}

TriMesh to_mesh(const SurfaceMesh& surface) {
  TriMesh mesh;
  std::vector<std::uint32_t> ids(surface.number_of_vertices() +
                                 surface.number_of_removed_vertices());
  for (const auto v : surface.vertices()) {
    ids[v.idx()] = static_cast<std::uint32_t>(mesh.vertices.size());
    const Point& p = surface.point(v);
    mesh.vertices.push_back({float(p.x()), float(p.y()), float(p.z())});
  }
  for (const auto f : surface.faces()) {
    Triangle t{};
    std::size_t k = 0;
    for (const auto v : surface.vertices_around_face(surface.halfedge(f))) t[k++] = ids[v.idx()];
    mesh.triangles.push_back(t);
  }
  return mesh;
}

std::array<Point, 3> corners_of(const SurfaceMesh& surface, SurfaceMesh::Face_index f) {
  const auto h = surface.halfedge(f);
  const auto at = [&](auto half_edge) { return surface.point(surface.target(half_edge)); };
  return {at(surface.prev(h)), at(h), at(surface.next(h))};
}

Vec3 middle(const SurfaceMesh& surface, SurfaceMesh::Face_index f) {
  const auto [a, b, c] = corners_of(surface, f);
  const Point p = CGAL::centroid(a, b, c);
  return {p.x(), p.y(), p.z()};
}

// Where two surfaces that touch share one place: whether triangles lie on or cross each other
// there.
bool overlap_at(const Point& p, const std::array<Point, 2>& a, const std::array<Point, 2>& b) {
  const auto crosses = [&](const std::array<Point, 2>& u, const std::array<Point, 2>& v) {
    return CGAL::orientation(p, u[0], u[1], v[0]) * CGAL::orientation(p, u[0], u[1], v[1]) < 0 &&
           CGAL::do_intersect(Kernel::Triangle_3(p, u[0], u[1]), Kernel::Segment_3(v[0], v[1]));
  };
  if (CGAL::collinear(p, a[0], a[1]) || CGAL::collinear(p, b[0], b[1])) return false;
  if (!CGAL::coplanar(p, a[0], a[1], b[0]) || !CGAL::coplanar(p, a[0], a[1], b[1]))
    return crosses(a, b) || crosses(b, a);
  // Two triangles of one plane cross where their angles at p have a direction in common.
  const auto holds = [&](const std::array<Point, 2>& u, const Point& x) {
    return CGAL::coplanar_orientation(p, u[0], u[1], x) == CGAL::POSITIVE &&
           CGAL::coplanar_orientation(p, u[1], u[0], x) == CGAL::POSITIVE;
  };
  const auto along = [&](const Point& x, const Point& y) {
    return CGAL::collinear(p, x, y) && (x - p) * (y - p) > 0;
  };
  return holds(a, b[0]) || holds(a, b[1]) || holds(b, a[0]) || holds(b, a[1]) ||
         (along(a[0], b[0]) && along(a[1], b[1])) || (along(a[0], b[1]) && along(a[1], b[0]));
}

// Whether two triangles that CGAL reports only touch, in a corner or an edge of the same place.
// Neighbours in one surface always do: files have needles that lie on their neighbours.
bool touch_only(const SurfaceMesh& surface, SurfaceMesh::Face_index f, SurfaceMesh::Face_index g) {
  const auto corners = [&](SurfaceMesh::Face_index face) {
    std::vector<SurfaceMesh::Vertex_index> out;
    for (const auto v : surface.vertices_around_face(surface.halfedge(face))) out.push_back(v);
    return out;
  };
  std::vector<SurfaceMesh::Vertex_index> a = corners(f), b = corners(g);
  std::size_t shared = 0;  // places, which come first from here on
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = shared; j < 3; ++j) {
      if (a[i] == b[j]) return true;
      if (surface.point(a[i]) != surface.point(b[j])) continue;
      std::swap(a[i], a[shared]), std::swap(b[j], b[shared]);
      ++shared;
      break;
    }
  if (shared == 0 || shared == 3) return false;
  const auto at = [&](SurfaceMesh::Vertex_index v) { return surface.point(v); };
  const Point p = at(a[0]), q = at(a[1]), r = at(a[2]), s = at(b[2]);
  if (shared == 1) return !overlap_at(p, {q, r}, {at(b[1]), s});
  return CGAL::collinear(p, q, r) || !CGAL::coplanar(p, q, r, s) ||
         CGAL::coplanar_orientation(p, q, r, s) != CGAL::POSITIVE;
}

using FacePair = std::pair<SurfaceMesh::Face_index, SurfaceMesh::Face_index>;

// Pairs of triangles that cross, up to that many: ten thousand bodies in one place, which a file of
// a few hundred bytes may hold, have more than fit into memory.
std::vector<FacePair> crossing_pairs(const SurfaceMesh& surface, std::size_t most) {
  struct Enough {};
  std::vector<FacePair> pairs;
  const auto take = [&](const FacePair& pair) {
    if (touch_only(surface, pair.first, pair.second)) return;
    pairs.push_back(pair);
    if (pairs.size() == most) throw Enough();
  };
  try {
    pmp::self_intersections(surface, boost::make_function_output_iterator(take));
  } catch (const Enough&) {
  }
  return pairs;
}

// Throws unless the surface is free of self-intersections.
void refuse_self_intersections(const SurfaceMesh& surface, const std::string& name) {
  constexpr std::size_t kMostPairs = 100'000;
  const std::vector<FacePair> pairs = crossing_pairs(surface, kMostPairs);
  if (pairs.empty()) return;
  const Vec3 p = middle(surface, std::min_element(pairs.begin(), pairs.end())->first);
  throw Error(
      "mesh-crosses-itself",
      fmt::format("{}: the surface crosses itself near ({:.6g}, {:.6g}, {:.6g}) mm, {}{} pairs "
                  "of triangles in all; unite its bodies in CAD and export it again",
                  name, p.x, p.y, p.z, pairs.size(), pairs.size() < kMostPairs ? "" : " or more"));
}

// Where two triangles of one edge lie on each other there is no inside, and CGAL's orientation,
// which looks at the topmost edge, would have no answer.
void refuse_folds(const SurfaceMesh& surface, const std::string& name) {
  for (const auto edge : surface.edges()) {
    const auto h = surface.halfedge(edge);
    const Point &p = surface.point(surface.source(h)), &q = surface.point(surface.target(h));
    const Point& r = surface.point(surface.target(surface.next(h)));
    const Point& s = surface.point(surface.target(surface.next(surface.opposite(h))));
    if (CGAL::collinear(p, q, r) || CGAL::collinear(p, q, s)) continue;
    if (!CGAL::coplanar(p, q, r, s) || CGAL::coplanar_orientation(p, q, r, s) != CGAL::POSITIVE)
      continue;
    throw Error("mesh-folded",
                fmt::format("{}: two triangles lie on each other at the edge from ({:.6g}, {:.6g}, "
                            "{:.6g}) to ({:.6g}, {:.6g}, {:.6g}) mm, so that nothing is inside; "
                            "check the unit and the shape and export it again",
                            name, p.x(), p.y(), p.z(), q.x(), q.y(), q.z()));
  }
}

// Whether CGAL may never end. It finds by rays which body lies in which, and casts a new ray where
// one lies in the plane of a triangle. A triangle without area lies in one plane with every ray, so
// CGAL goes on for ever where the box of such a triangle holds the point.
bool rays_may_fail(const SurfaceMesh& surface) {
  const auto faces = surface.faces();
  return std::any_of(faces.begin(), faces.end(), [&](SurfaceMesh::Face_index f) {
    const auto [a, b, c] = corners_of(surface, f);
    return CGAL::collinear(a, b, c);
  });
}

// Turns components so that they bound a solid; what is in the way is found in the mesh afterwards.
TriMesh oriented(const TriMesh& mesh, const std::string& name) {
  SurfaceMesh surface = to_surface(mesh);
  pmp::stitch_borders(surface);
  TriMesh out = to_mesh(surface);
  if (!CGAL::is_closed(surface)) return out;
  refuse_self_intersections(surface, name);
  if (is_solid(out)) return out;
  refuse_folds(surface, name);
  if (check_mesh(out).components > 1 && rays_may_fail(surface)) return out;
  try {
    pmp::orient_to_bound_a_volume(surface);
  } catch (const CGAL::Failure_exception&) {  // needles alone at the topmost edge
    return out;
  }
  return to_mesh(surface);
}

// Closed surfaces whose volume is less than the rounding of their corners: triangles back to back,
// needles. No point is certainly inside them. Returns how many were dropped.
std::size_t drop_sheets(TriMesh& mesh) {
  const std::vector<std::uint32_t> opposite = find_opposites(mesh, 1);
  const double thinnest = weld_distance(mesh);
  std::vector<bool> taken(mesh.triangles.size()), flat(mesh.triangles.size());
  std::size_t sheets = 0;
  for (std::uint32_t first = 0; first < mesh.triangles.size(); ++first) {
    if (taken[first]) continue;
    const Vec3 from = corner(mesh, first, 0);
    std::vector<std::uint32_t> component{first};
    taken[first] = true;
    double area = 0, volume = 0;
    for (std::size_t i = 0; i < component.size(); ++i) {
      const Vec3 normal = area_normal(mesh, component[i]);
      area += 0.5 * length(normal);
      volume += dot(normal, corner(mesh, component[i], 0) - from) / 6;
      for (std::uint32_t h = 3 * component[i]; h < 3 * component[i] + 3; ++h) {
        if (!is_half_edge(opposite[h]) || taken[opposite[h] / 3]) continue;
        taken[opposite[h] / 3] = true;
        component.push_back(opposite[h] / 3);
      }
    }
    if (std::fabs(volume) > 0.5 * area * thinnest) continue;
    ++sheets;
    for (const std::uint32_t f : component) flat[f] = true;
  }
  if (sheets == 0) return 0;
  TriMesh rest;
  std::vector<std::uint32_t> new_index(mesh.vertices.size(), kUnused);
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    if (flat[f]) continue;
    Triangle t = mesh.triangles[f];
    for (std::uint32_t& v : t) {
      if (new_index[v] == kUnused) {
        new_index[v] = static_cast<std::uint32_t>(rest.vertices.size());
        rest.vertices.push_back(mesh.vertices[v]);
      }
      v = new_index[v];
    }
    rest.triangles.push_back(t);
  }
  mesh = std::move(rest);
  return sheets;
}

// How many triangles look the other way; both meshes have the same triangles in the same order.
std::size_t turned(const TriMesh& before, const TriMesh& after) {
  std::size_t count = 0;
  for (std::size_t f = 0; f < before.triangles.size() && f < after.triangles.size(); ++f)
    count += dot(area_normal(before, f), area_normal(after, f)) < 0;
  return count;
}

// Gives the triangles one orientation, outwards. Returns what was done to them in words.
std::string orient(TriMesh& mesh, const std::string& name) {
  TriMesh after = weld(oriented(mesh, name));
  require_solid(after, name);
  const std::size_t count = turned(mesh, after);
  const bool is_all = count == mesh.triangles.size();
  mesh = std::move(after);
  if (count == 0) return "";
  return is_all ? "it was inside out" : counted(count, "triangle turned", "triangles turned");
}

void require_triangles(const TriMesh& mesh, const std::string& name) {
  if (mesh.triangles.empty())
    throw Error("mesh-flat",
                name +
                    ": no triangle has an area that the precision of its corners can hold; "
                    "check the unit and export it again");
}

}  // namespace

std::string make_solid(TriMesh& mesh, const std::string& name) {
  const MeshSummary summary = check_mesh(mesh);
  if (summary.components == 0) require_solid(mesh, name);  // not a mesh at all
  std::vector<std::string> done;
  const auto step = [&](std::size_t count, const char* one, const char* many) {
    if (count > 0) done.push_back(counted(count, one, many));
  };
  const auto weld_all = [&](const char* one, const char* many) {
    TriMesh welded = weld(mesh);
    step(mesh.vertices.size() - welded.vertices.size(), one, many);
    step(mesh.triangles.size() - welded.triangles.size(), "triangle without area dropped",
         "triangles without area dropped");
    mesh = std::move(welded);
    require_triangles(mesh, name);
  };
  std::size_t sheets = summary.oriented ? drop_sheets(mesh) : 0;
  require_triangles(mesh, name);
  // Closed by indices, a mesh may still have vertices that share a place.
  if (!summary.oriented || summary.degenerate > 0 || bodies_coincide(mesh, summary)) {
    mesh.owners.clear(), mesh.colors.clear();
    weld_all("vertex welded", "vertices welded");
    if (!is_solid(mesh)) {
      join_borders(mesh);
      weld_all("vertex of an open edge welded", "vertices of open edges welded");
      step(drop_doubles(mesh), "double triangle dropped", "double triangles dropped");
      step(drop_touching(mesh), "", "triangles dropped where bodies touch");
      if (mesh.triangles.empty())
        throw Error("mesh-inverted",
                    name +
                        ": each of its bodies lies in one place with the same body turned inside "
                        "out, so that nothing is left; export one of them");
    }
    if (!is_solid(mesh)) {
      std::string change = orient(mesh, name);
      if (!change.empty()) done.push_back(std::move(change));
    }
    sheets += drop_sheets(mesh);
  }
  step(sheets, "sheet without thickness dropped", "sheets without thickness dropped");
  require_triangles(mesh, name);
  return fmt::format("{}", fmt::join(done, ", "));
}

void require_clean_bodies(const TriMesh& mesh, const std::string& name) {
  // CGAL takes longer, but knows all coordinates, and bodies that touch.
  if (!detail::is_sound(mesh, 1)) refuse_self_intersections(to_surface(mesh), name);
  const std::optional<MisplacedBody> body = find_misplaced_body(mesh);
  if (!body) return;
  const Vec3& p = body->place;
  const std::string place = fmt::format("({:.6g}, {:.6g}, {:.6g}) mm", p.x, p.y, p.z);
  if (body->within)
    throw Error("mesh-nested", fmt::format("{}: a body lies within another at {}; unite its bodies "
                                           "in CAD and export it again",
                                           name, place));
  throw Error("mesh-inverted",
              fmt::format("{}: the body at {} is inside out; turn it in CAD and export it again",
                          name, place));
}

}  // namespace mrsim
