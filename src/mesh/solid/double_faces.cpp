#include "mesh/solid/double_faces.h"

#include "mesh/solid/weld.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <vector>

namespace mrsim {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

Triangle least_first(Triangle t) {
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

}  // namespace

std::size_t drop_doubles(TriMesh& mesh) {
  std::set<Triangle> seen;
  return std::erase_if(mesh.triangles,
                       [&](const Triangle& t) { return !seen.insert(least_first(t)).second; });
}

std::size_t drop_touching(TriMesh& mesh) {
  std::vector<Triangle> all;
  all.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) all.push_back(least_first(t));
  std::sort(all.begin(), all.end());
  const std::size_t dropped = std::erase_if(mesh.triangles, [&](const Triangle& t) {
    return std::binary_search(all.begin(), all.end(), least_first({t[0], t[2], t[1]}));
  });
  if (dropped > 0) drop_unused_vertices(mesh);
  return dropped;
}

}  // namespace mrsim
