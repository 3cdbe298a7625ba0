// Triangles on one face of a solid, divided until they are near it: Open CASCADE takes the wanted
// distance as advice (a sphere ends at twice of it, an extruded spline at sixty times), and its
// time grows with the square of the triangles of a face.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <gp_XY.hxx>
#include <gp_XYZ.hxx>

class BRepAdaptor_Surface;

namespace mrsim {

struct FaceMesh {
  std::vector<gp_XYZ> points;  ///< mm, on the face
  std::vector<gp_XY> places;   ///< the same points in the surface's parameters
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// Halves sides whose middle lies farther than about `distance` mm from the face, again and again.
/// Sides at the border of the face stay: the neighbour has them, too.
void refine(const BRepAdaptor_Surface& face, double distance, FaceMesh& mesh);

/// The largest height in mm of the face over the triangles, at seven places of each.
double deviation_of(const BRepAdaptor_Surface& face, const FaceMesh& mesh);

double distance_from_segment(const gp_XYZ& p, const gp_XYZ& a, const gp_XYZ& b);

}  // namespace mrsim
