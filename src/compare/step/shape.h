// The shape in a STEP file, whole or not at all: Open CASCADE leaves out what it cannot read and
// says nothing.
#pragma once

#include <string>

#include <TopoDS_Shape.hxx>

namespace mrsim {

/// Why a file gives no facets; never leaves the module.
struct StepFault {
  const char* code;
  std::string text;  ///< stands behind the name of the file
};

struct StepShape {
  TopoDS_Shape shape;    ///< mm
  std::string left_out;  ///< what bounds no solid, in words; empty where all does
};

/// Throws StepFault, too where one of the file's solids did not become one.
StepShape read_step_shape(const char* path);

}  // namespace mrsim
