// The module that reads STEP files through Open CASCADE, the only source that sees it.
#include "compare/step/module.h"

#include <exception>
#include <new>
#include <string>
#include <utility>
#include <vector>

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

namespace mrsim {
namespace {

constexpr double kAngle = 0.2;  // radians between neighbouring facets at most

// A file that gives no facets; never leaves the module.
struct Fault {
  const char* code;
  std::string text;
};

// What StepFacets points into.
struct OwnedFacets : StepFacets {
  std::vector<float> point_data;
  std::vector<std::uint32_t> triangle_data;
  std::string text_data;
};

// The library talks to stdout on its own account.
void silence() {
  Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_PrinterOStream));
}

TopoDS_Shape read_shape(const char* path) {
  silence();
  STEPControl_Reader reader;
  if (reader.ReadFile(path) != IFSelect_RetDone)
    throw Fault{"step-unreadable", " cannot be read as STEP: its data section is damaged"};
  reader.TransferRoots();
  return reader.OneShape();
}

// Facets of one face; a reversed face turns them.
void add_face(const TopoDS_Face& face, OwnedFacets& out) {
  TopLoc_Location place;
  const Handle(Poly_Triangulation) facets = BRep_Tool::Triangulation(face, place);
  if (facets.IsNull()) throw Fault{"step-open", " has a face that Open CASCADE cannot tessellate"};
  const std::size_t first = out.point_data.size() / 3;
  for (int i = 1; i <= facets->NbNodes(); ++i) {
    const gp_Pnt p = facets->Node(i).Transformed(place.Transformation());
    out.point_data.insert(out.point_data.end(), {float(p.X()), float(p.Y()), float(p.Z())});
  }
  for (int i = 1; i <= facets->NbTriangles(); ++i) {
    int a = 0, b = 0, c = 0;
    facets->Triangle(i).Get(a, b, c);
    if (face.Orientation() == TopAbs_REVERSED) std::swap(b, c);
    for (const int corner : {a, b, c})
      out.triangle_data.push_back(std::uint32_t(first + std::size_t(corner - 1)));
  }
}

void tessellate(const TopoDS_Shape& shape, double deflection, OwnedFacets& out) {
  bool any = false;
  for (TopExp_Explorer solid(shape, TopAbs_SOLID); solid.More(); solid.Next()) {
    any = true;
    BRepMesh_IncrementalMesh mesher(solid.Current(), deflection, Standard_False, kAngle);
    for (TopExp_Explorer face(solid.Current(), TopAbs_FACE); face.More(); face.Next())
      add_face(TopoDS::Face(face.Current()), out);
  }
  if (!any)
    throw Fault{"step-no-solid",
                " has no solid: surfaces or wires alone bound no part. "
                "Export the body as a solid (AP203, AP214 or AP242)"};
}

Fault gave_up(const char* why) {
  return {"step-unreadable", ": Open CASCADE gave up (" + std::string(why) + ")"};
}

// Every exception but that of memory becomes a Fault.
void read_facets(const char* path, double deflection, OwnedFacets& out) {
  try {
    tessellate(read_shape(path), deflection, out);
  } catch (const Fault&) {
    throw;
  } catch (const Standard_Failure& failure) {
    throw gave_up(failure.GetMessageString());
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw gave_up(error.what());
  } catch (...) {
    throw gave_up("for no reason that it tells");
  }
}

OwnedFacets* make_facets(const char* path, double deflection) {
  auto* out = new OwnedFacets;
  try {
    read_facets(path, deflection, *out);
    out->points = out->point_data.data();
    out->point_count = out->point_data.size() / 3;
    out->triangles = out->triangle_data.data();
    out->triangle_count = out->triangle_data.size() / 3;
  } catch (Fault& fault) {
    out->text_data = std::move(fault.text);
    out->code = fault.code;
    out->text = out->text_data.c_str();
  } catch (...) {
    delete out;
    throw;
  }
  return out;
}

}  // namespace
}  // namespace mrsim

#define MRSIM_MODULE_API __attribute__((visibility("default")))

extern "C" {

MRSIM_MODULE_API mrsim::ReadStepFacets mrsim_read_step_facets_1;
MRSIM_MODULE_API mrsim::FreeStepFacets mrsim_free_step_facets_1;

const mrsim::StepFacets* mrsim_read_step_facets_1(const char* path, double deflection) noexcept {
  try {
    return mrsim::make_facets(path, deflection);
  } catch (...) {  // std::bad_alloc
    return nullptr;
  }
}

void mrsim_free_step_facets_1(const mrsim::StepFacets* facets) noexcept {
  delete static_cast<const mrsim::OwnedFacets*>(facets);
}

}  // extern "C"
