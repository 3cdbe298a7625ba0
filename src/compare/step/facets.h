// Facets of a shape's solids, with the distance that was found between facets and faces.
#pragma once

#include <cstdint>
#include <vector>

class TopoDS_Shape;

namespace mrsim {

struct SolidFacets {
  std::vector<float> points;             ///< x, y, z in mm; faces that meet repeat their points
  std::vector<std::uint32_t> triangles;  ///< three points each, counter-clockwise from outside
  double deviation = 0;                  ///< mm: the largest at samples of faces and edges
};

/// Facets within `deflection` mm of the faces, as far as that can be had. Throws StepFault
/// "step-open" for a face without facets.
SolidFacets make_solid_facets(const TopoDS_Shape& shape, double deflection);

}  // namespace mrsim
