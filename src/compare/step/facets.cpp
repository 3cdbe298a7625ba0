#include "compare/step/facets.h"

#include "compare/step/face_mesh.h"
#include "compare/step/shape.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <IMeshTools_Parameters.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>

namespace mrsim {
namespace {

constexpr double kAngle = 0.2;       // radians between neighbouring chords of an edge at most
constexpr double kInnerAngle = 0.5;  // between facets, which are divided further
constexpr double kInnerShare = 16;   // of the deflection: what facets may miss before
constexpr int kChordRounds = 3;      // of finer chords
constexpr double kFiner = 0.3;       // deflection of a round, of the one before

// Edges end at their chords; within a face facets may miss it by `inner` times as much. At 1 Open
// CASCADE looks for itself how far they do.
void divide_edges(const TopoDS_Shape& solid, double deflection, double inner) {
  IMeshTools_Parameters wish;
  wish.Deflection = deflection;
  wish.DeflectionInterior = inner * deflection;
  wish.Angle = kAngle;
  wish.AngleInterior = kInnerAngle;
  wish.ControlSurfaceDeflection = inner > 1 ? Standard_False : Standard_True;
  BRepTools::Clean(solid);
  const BRepMesh_IncrementalMesh mesher(solid, wish);
}

// The largest distance between an edge's curve and its chords, as far as samples show it.
double deviation_of(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  TopLoc_Location place;
  const Handle(Poly_Triangulation) facets = BRep_Tool::Triangulation(face, place);
  if (facets.IsNull() || BRep_Tool::Degenerated(edge)) return 0;
  const Handle(Poly_PolygonOnTriangulation) chords =
      BRep_Tool::PolygonOnTriangulation(edge, facets, place);
  if (chords.IsNull() || !chords->HasParameters()) return 0;
  const BRepAdaptor_Curve curve(edge);
  const auto node = [&](int i) {
    return facets->Node(chords->Node(i)).Transformed(place.Transformation()).XYZ();
  };
  double worst = 0;
  for (int i = 1; i < chords->NbNodes(); ++i)
    for (const double share : {0.25, 0.5, 0.75}) {
      const double t = chords->Parameter(i) * (1 - share) + chords->Parameter(i + 1) * share;
      worst = std::max(worst, distance_from_segment(curve.Value(t).XYZ(), node(i), node(i + 1)));
    }
  return worst;
}

double edge_deviation(const TopoDS_Shape& solid) {
  double worst = 0;
  for (TopExp_Explorer face(solid, TopAbs_FACE); face.More(); face.Next())
    for (TopExp_Explorer edge(face.Current(), TopAbs_EDGE); edge.More(); edge.Next())
      worst =
          std::max(worst, deviation_of(TopoDS::Edge(edge.Current()), TopoDS::Face(face.Current())));
  return worst;
}

FaceMesh mesh_of(const TopoDS_Face& face) {
  TopLoc_Location place;
  const Handle(Poly_Triangulation) facets = BRep_Tool::Triangulation(face, place);
  if (facets.IsNull())
    throw StepFault{"step-open", " has a face that Open CASCADE cannot tessellate"};
  FaceMesh mesh;
  for (int i = 1; i <= facets->NbNodes(); ++i) {
    mesh.points.push_back(facets->Node(i).Transformed(place.Transformation()).XYZ());
    mesh.places.push_back(facets->HasUVNodes() ? facets->UVNode(i).XY() : gp_XY());
  }
  for (int i = 1; i <= facets->NbTriangles(); ++i) {
    int a = 0, b = 0, c = 0;
    facets->Triangle(i).Get(a, b, c);
    mesh.triangles.push_back({std::uint32_t(a - 1), std::uint32_t(b - 1), std::uint32_t(c - 1)});
  }
  return mesh;
}

// A reversed face turns its triangles.
void append(const FaceMesh& mesh, bool is_reversed, SolidFacets& out) {
  const auto first = static_cast<std::uint32_t>(out.points.size() / 3);
  for (const gp_XYZ& p : mesh.points)
    out.points.insert(out.points.end(), {float(p.X()), float(p.Y()), float(p.Z())});
  for (auto [a, b, c] : mesh.triangles) {
    if (is_reversed) std::swap(b, c);
    out.triangles.insert(out.triangles.end(), {a + first, b + first, c + first});
  }
}

// Whether each side of a triangle is a side of exactly one other, in the other direction. Points at
// the same place count as one.
bool is_closed(const SolidFacets& facets) {
  using Point = std::array<float, 3>;
  std::map<Point, std::uint32_t> places;
  std::vector<std::uint32_t> new_index(facets.points.size() / 3);
  for (std::size_t i = 0; i < new_index.size(); ++i) {
    const Point p{facets.points[3 * i], facets.points[3 * i + 1], facets.points[3 * i + 2]};
    new_index[i] = places.emplace(p, std::uint32_t(places.size())).first->second;
  }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> sides, turned;
  for (std::size_t t = 0; t < facets.triangles.size(); t += 3) {
    const std::uint32_t k[3] = {new_index[facets.triangles[t]], new_index[facets.triangles[t + 1]],
                                new_index[facets.triangles[t + 2]]};
    if (k[0] == k[1] || k[1] == k[2] || k[2] == k[0]) continue;
    for (int i = 0; i < 3; ++i) {
      sides.emplace_back(k[i], k[(i + 1) % 3]);
      turned.emplace_back(k[(i + 1) % 3], k[i]);
    }
  }
  std::sort(sides.begin(), sides.end());
  std::sort(turned.begin(), turned.end());
  return sides == turned && std::adjacent_find(sides.begin(), sides.end()) == sides.end();
}

// Open CASCADE's facets, divided further where they may miss their face by more than `inner` 1.
SolidFacets facets_of(const TopoDS_Shape& solid, double deflection, double inner) {
  SolidFacets out;
  double asked = deflection;
  for (int round = 0; round < kChordRounds; ++round, asked *= kFiner) {
    divide_edges(solid, asked, inner);
    out.deviation = edge_deviation(solid);
    if (out.deviation <= deflection) break;
  }
  for (TopExp_Explorer at(solid, TopAbs_FACE); at.More(); at.Next()) {
    const TopoDS_Face face = TopoDS::Face(at.Current());
    FaceMesh mesh = mesh_of(face);
    const BRepAdaptor_Surface surface(face, Standard_False);
    if (surface.GetType() != GeomAbs_Plane) {
      if (inner > 1) refine(surface, deflection, mesh);
      out.deviation = std::max(out.deviation, deviation_of(surface, mesh));
    }
    append(mesh, face.Orientation() == TopAbs_REVERSED, out);
  }
  return out;
}

// Where two sheets of a face lie closer together than the deflection, new points may fall on old
// ones: then facets stay as Open CASCADE makes them.
void add_solid(const TopoDS_Shape& solid, double deflection, SolidFacets& out) {
  SolidFacets facets = facets_of(solid, deflection, kInnerShare);
  if (!is_closed(facets)) facets = facets_of(solid, deflection, 1);
  const auto first = static_cast<std::uint32_t>(out.points.size() / 3);
  out.points.insert(out.points.end(), facets.points.begin(), facets.points.end());
  for (const std::uint32_t corner : facets.triangles) out.triangles.push_back(corner + first);
  out.deviation = std::max(out.deviation, facets.deviation);
}

}  // namespace

SolidFacets make_solid_facets(const TopoDS_Shape& shape, double deflection) {
  SolidFacets out;
  for (TopExp_Explorer solid(shape, TopAbs_SOLID); solid.More(); solid.Next())
    add_solid(solid.Current(), deflection, out);
  return out;
}

}  // namespace mrsim
