#include "compare/step/shape.h"

#include <cstdint>
#include <string>

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_PrinterOStream.hxx>
#include <STEPControl_Reader.hxx>
#include <StepData_StepModel.hxx>
#include <StepShape_ShapeRepresentation.hxx>
#include <StepShape_SolidModel.hxx>
#include <TopExp_Explorer.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

namespace mrsim {
namespace {

// The library talks to stdout on its own account.
void silence() {
  Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_PrinterOStream));
}

std::string name_of(const Handle(StepData_StepModel) & model,
                    const Handle(Standard_Transient) & entity) {
  return "#" + std::to_string(model->IdentLabel(entity));
}

bool has_solid(const TopoDS_Shape& shape) {
  return !shape.IsNull() && TopExp_Explorer(shape, TopAbs_SOLID).More();
}

// A representation whose item is of a kind that Open CASCADE does not know.
bool lacks_an_item(const Handle(StepShape_ShapeRepresentation) & shape) {
  if (shape.IsNull() || shape->Items().IsNull()) return false;
  for (int i = 1; i <= shape->NbItems(); ++i)
    if (shape->ItemsValue(i).IsNull()) return true;
  return false;
}

// Every solid of the file must have become one: a nominal without one of its bodies is another.
void require_all_solids(STEPControl_Reader& reader) {
  const Handle(StepData_StepModel) model = reader.StepModel();
  const Handle(Transfer_TransientProcess) transfer =
      reader.WS()->TransferReader()->TransientProcess();
  int lost = 0;
  std::string first;
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const Handle(Standard_Transient) entity = model->Value(i);
    const bool is_solid = entity->IsKind(STANDARD_TYPE(StepShape_SolidModel));
    const bool is_lost =
        is_solid ? !has_solid(TransferBRep::ShapeResult(transfer, entity))
                 : lacks_an_item(Handle(StepShape_ShapeRepresentation)::DownCast(entity));
    if (is_lost && lost++ == 0) first = name_of(model, entity);
  }
  if (lost == 0) return;
  throw StepFault{"step-incomplete",
                  ": " + std::to_string(lost) + (lost == 1 ? " body" : " bodies") +
                      " of the file cannot be read, first " + first +
                      ": a shell that is open, a body that no product holds, or a kind that is "
                      "not known. Export it again"};
}

std::string faces_beside_solids(const TopoDS_Shape& shape) {
  int faces = 0;
  for (TopExp_Explorer face(shape, TopAbs_FACE, TopAbs_SOLID); face.More(); face.Next()) ++faces;
  if (faces == 0) return "";
  return std::to_string(faces) + (faces == 1 ? " face that bounds" : " faces that bound") +
         " no solid left out";
}

}  // namespace

StepShape read_step_shape(const char* path) {
  silence();
  STEPControl_Reader reader;
  if (reader.ReadFile(path) != IFSelect_RetDone)
    throw StepFault{"step-unreadable", " cannot be read as STEP: its data section is damaged"};
  reader.TransferRoots();
  require_all_solids(reader);
  StepShape out;
  out.shape = reader.OneShape();
  if (!has_solid(out.shape))
    throw StepFault{"step-no-solid",
                    " has no solid: surfaces or wires alone bound no part. "
                    "Export the body as a solid (AP203, AP214 or AP242)"};
  out.left_out = faces_beside_solids(out.shape);
  return out;
}

}  // namespace mrsim
