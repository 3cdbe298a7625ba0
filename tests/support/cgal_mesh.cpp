#include "support/cgal_mesh.h"

#include "support/cgal_surface.h"

#include <iterator>

#include <CGAL/Kernel/global_functions_3.h>  // which distance.h of CGAL 5.5 uses and does not include
#include <CGAL/Polygon_mesh_processing/distance.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>

namespace mrsim::testing {

std::vector<std::pair<std::uint32_t, std::uint32_t>> meeting_faces(const TriMesh& mesh) {
  const SurfaceMesh m = to_cgal(mesh);
  std::vector<std::pair<SurfaceMesh::Face_index, SurfaceMesh::Face_index>> pairs;
  CGAL::Polygon_mesh_processing::self_intersections(m, std::back_inserter(pairs));
  return {pairs.begin(), pairs.end()};
}

double directed_hausdorff_by_cgal(const TriMesh& from, const TriMesh& to, double error) {
  return CGAL::Polygon_mesh_processing::bounded_error_Hausdorff_distance<CGAL::Sequential_tag>(
      to_cgal(from), to_cgal(to), error);
}

}  // namespace mrsim::testing
