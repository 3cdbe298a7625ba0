// The border between the library and the module that reads STEP files.
//
// The module, <folder of the library>/mrsim/step.so, is linked against Open CASCADE and against
// nothing of mrsim. The library opens it when the first STEP file is read, so that all other
// runs do not pay for it: binding the 60 000 symbols of Open CASCADE takes 30 ms. Only plain
// data and no exception crosses the border; memory goes back to its owner.
#pragma once

#include <cstddef>
#include <cstdint>

namespace mrsim {

/// The facets of all faces of a file's solids, or why there are none. The module owns what the
/// pointers show.
struct StepFacets {
  const float* points = nullptr;  // x, y, z in mm; faces that meet repeat their points
  std::size_t point_count = 0;
  const std::uint32_t* triangles = nullptr;  // three points each, counter-clockwise from outside
  std::size_t triangle_count = 0;
  const char* code = nullptr;  // of the Error to throw; nullptr when the file was read
  // Its text, to stand behind the name of the file; of a file that was read what was left out, if
  // anything.
  const char* text = nullptr;
  double deviation = 0;  // mm: the largest distance from the faces that was found
};

/// Facets of the file `path`, wanted within `deflection` mm of the exact faces; nullptr when memory
/// ran out.
using ReadStepFacets = const StepFacets*(const char* path, double deflection) noexcept;
using FreeStepFacets = void(const StepFacets*) noexcept;

/// The module exports both under these names; the number is raised when this header changes.
constexpr const char* kReadStepFacets = "mrsim_read_step_facets_2";
constexpr const char* kFreeStepFacets = "mrsim_free_step_facets_2";

}  // namespace mrsim
