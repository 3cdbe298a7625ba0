// The border of the module that reads STEP files through Open CASCADE.
#include "compare/step/module.h"

#include "compare/step/facets.h"
#include "compare/step/shape.h"

#include <exception>
#include <new>
#include <string>
#include <utility>

#include <Standard_Failure.hxx>

namespace mrsim {
namespace {

// What StepFacets points into.
struct OwnedFacets : StepFacets {
  SolidFacets facets;
  std::string text_data;
};

StepFault gave_up(const char* why) {
  return {"step-unreadable", ": Open CASCADE gave up (" + std::string(why) + ")"};
}

// Every exception but that of memory becomes a StepFault.
void read_facets(const char* path, double deflection, OwnedFacets& out) {
  try {
    const StepShape shape = read_step_shape(path);
    out.facets = make_solid_facets(shape.shape, deflection);
    out.text_data = shape.left_out;
  } catch (const StepFault&) {
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
    out->points = out->facets.points.data();
    out->point_count = out->facets.points.size() / 3;
    out->triangles = out->facets.triangles.data();
    out->triangle_count = out->facets.triangles.size() / 3;
    out->deviation = out->facets.deviation;
  } catch (StepFault& fault) {
    out->text_data = std::move(fault.text);
    out->code = fault.code;
  } catch (...) {
    delete out;
    throw;
  }
  out->text = out->text_data.c_str();
  return out;
}

}  // namespace
}  // namespace mrsim

#define MRSIM_MODULE_API __attribute__((visibility("default")))

extern "C" {

MRSIM_MODULE_API mrsim::ReadStepFacets mrsim_read_step_facets_2;
MRSIM_MODULE_API mrsim::FreeStepFacets mrsim_free_step_facets_2;

const mrsim::StepFacets* mrsim_read_step_facets_2(const char* path, double deflection) noexcept {
  try {
    return mrsim::make_facets(path, deflection);
  } catch (...) {  // std::bad_alloc
    return nullptr;
  }
}

void mrsim_free_step_facets_2(const mrsim::StepFacets* facets) noexcept {
  delete static_cast<const mrsim::OwnedFacets*>(facets);
}

}  // extern "C"
