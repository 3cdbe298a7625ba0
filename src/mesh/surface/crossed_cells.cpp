#include "mesh/surface/crossed_cells.h"

#include "mesh/solid/self_intersection.h"

#include <array>

namespace mrsim::detail {

std::vector<std::int32_t> crossed_cells(const DualSurface& surface, std::size_t cells,
                                        int threads) {
  if (surface.crowded().empty()) return {};
  std::vector<char> is_crowded(cells, 0);
  for (const std::int32_t c : surface.crowded()) is_crowded[static_cast<std::size_t>(c)] = 1;
  const BaseMesh& mesh = surface.mesh();
  const auto crowded_cell = [&](std::uint32_t v) {
    if (v >= surface.loops().size()) return -1;
    const std::int32_t c = surface.loops()[v].cell;
    return is_crowded[static_cast<std::size_t>(c)] ? c : -1;
  };
  std::vector<std::array<std::uint32_t, 3>> some;
  for (const auto& t : mesh.triangles)
    if (crowded_cell(t[0]) >= 0 || crowded_cell(t[1]) >= 0 || crowded_cell(t[2]) >= 0)
      some.push_back(t);
  std::vector<std::int32_t> bad;
  for (const auto& [i, j] : self_intersections(mesh.vertices, some, threads))
    for (const std::uint32_t k : {i, j})
      for (const std::uint32_t v : some[k])
        if (crowded_cell(v) >= 0) bad.push_back(crowded_cell(v));
  return bad;
}

}  // namespace mrsim::detail
