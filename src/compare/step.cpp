// STEP files through Open CASCADE, the only source that sees it.
#include "core/text_io.h"
#include "mesh/check.h"
#include <mrsim/solid_files.h>

#include <cmath>

#include <fmt/format.h>

#ifdef MRSIM_HAS_STEP

#include "mesh/weld.h"

#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_PrinterOStream.hxx>
#include <Poly_Triangulation.hxx>
#include <STEPControl_Reader.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <UnitsMethods.hxx>

namespace mrsim {
namespace {

constexpr double kAngle = 0.2;  // radians between neighbouring facets at most

// The library talks to stdout on its own account.
void silence() {
  Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_PrinterOStream));
}

TopoDS_Shape read_shape(const std::string& path) {
  // Looked at first: the library's messages for files that are not STEP say little.
  const std::string head = read_file(path).substr(0, 4096);
  if (head.find("ISO-10303-21") == std::string::npos)
    throw Error("step-unreadable", path + " is not a STEP file: it has no ISO-10303-21 header");
  silence();
  STEPControl_Reader reader;
  if (reader.ReadFile(path.c_str()) != IFSelect_RetDone)
    throw Error("step-unreadable", path + " cannot be read as STEP: its data section is damaged");
  reader.TransferRoots();
  return reader.OneShape();
}

// Triangles of one face; a reversed face turns them.
void add_face(const TopoDS_Face& face, const std::string& path, Welder& welder, TriMesh& mesh) {
  TopLoc_Location place;
  const Handle(Poly_Triangulation) facets = BRep_Tool::Triangulation(face, place);
  if (facets.IsNull())
    throw Error("step-open", path + " has a face that Open CASCADE cannot tessellate");
  std::vector<std::uint32_t> index;
  for (int i = 1; i <= facets->NbNodes(); ++i) {
    const gp_Pnt p = facets->Node(i).Transformed(place.Transformation());
    index.push_back(welder.add({float(p.X()), float(p.Y()), float(p.Z())}));
  }
  for (int i = 1; i <= facets->NbTriangles(); ++i) {
    int a = 0, b = 0, c = 0;
    facets->Triangle(i).Get(a, b, c);
    if (face.Orientation() == TopAbs_REVERSED) std::swap(b, c);
    const std::array<std::uint32_t, 3> t{index[std::size_t(a - 1)], index[std::size_t(b - 1)],
                                         index[std::size_t(c - 1)]};
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) mesh.triangles.push_back(t);
  }
}

TriMesh tessellate(const TopoDS_Shape& shape, const std::string& path, double deflection) {
  Welder welder;
  TriMesh mesh;
  bool any = false;
  for (TopExp_Explorer solid(shape, TopAbs_SOLID); solid.More(); solid.Next()) {
    any = true;
    BRepMesh_IncrementalMesh mesher(solid.Current(), deflection, Standard_False, kAngle);
    for (TopExp_Explorer face(solid.Current(), TopAbs_FACE); face.More(); face.Next())
      add_face(TopoDS::Face(face.Current()), path, welder, mesh);
  }
  if (!any)
    throw Error("step-no-solid", path +
                                     " has no solid: surfaces or wires alone bound no part. "
                                     "Export the body as a solid (AP203, AP214 or AP242)");
  mesh.vertices = welder.take();
  return mesh;
}

}  // namespace

TriMesh read_step(const std::string& path, double deflection) {
  if (!(deflection > 0) || !std::isfinite(deflection))
    throw Error("deflection-invalid", "the deflection of a STEP file is a length above 0 mm",
                Error::Kind::usage);
  TriMesh mesh;
  try {
    mesh = tessellate(read_shape(path), path, deflection);
  } catch (const Standard_Failure& failure) {
    throw Error("step-unreadable",
                fmt::format("{}: Open CASCADE gave up ({})", path, failure.GetMessageString()));
  }
  const MeshSummary summary = check_mesh(mesh);
  if (!summary.closed || !summary.oriented)
    throw Error("step-open", path + ": the solids' faces do not join: " + summary.first_fault);
  return mesh;
}

}  // namespace mrsim

#else

namespace mrsim {

TriMesh read_step(const std::string& path, double) {
  throw Error("step-unsupported",
              path +
                  ": this mrsim was built without Open CASCADE (MRSIM_STEP) and reads no STEP; "
                  "export the model as STL or 3MF");
}

}  // namespace mrsim

#endif
