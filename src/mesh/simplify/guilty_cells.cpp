#include "mesh/simplify/guilty_cells.h"

#include <algorithm>
#include <cmath>

namespace mrsim::detail {
namespace {

constexpr double kMissed = 1e-4;  ///< mm: a vertex farther off its face has missed a crease
constexpr int kCreaseCells = 8;   ///< on both sides of one that has missed it

int longest_axis(const Vec3& v) {
  const Vec3 size{std::abs(v.x), std::abs(v.y), std::abs(v.z)};
  return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
}

// A crease that a cell has missed, and that finer cells beside it have shown, goes on in the next
// cells along it, one round for each.
void add_ahead(const ExactField& field, const CellOctree& tree, const FieldSample& face,
               std::vector<std::int32_t>& cells) {
  for (std::size_t k = 0, count = cells.size(); k < count; ++k) {
    const std::int32_t c = cells[k];
    const Box3 box = tree.box(c);
    const Vec3 center = 0.5 * (box.lo + box.hi);
    const FieldSample other = field.sample(center, tree.candidates(c));
    const int axis =
        longest_axis(cross(field.gradient(center, face), field.gradient(center, other)));
    for (const int way : {-1, 1})
      for (int step = 1; step <= kCreaseCells; ++step) {
        Vec3 p = center;
        component(p, axis) += way * step * (box.hi.x - box.lo.x);
        const std::int32_t next = tree.locate(p, c);
        if (!tree.node(next).signs_differ || tree.node(next).size != tree.node(c).size) break;
        cells.push_back(next);
      }
  }
}

}  // namespace

std::vector<std::int32_t> guilty_cells(const ExactField& field, const CellOctree& tree,
                                       const DualSurface& surface, const LabelledMesh& mesh,
                                       std::size_t t, bool ahead) {
  std::vector<std::int32_t> cells;
  const FieldSample& face = mesh.faces[mesh.labels[t]];
  const std::vector<Loop>& loops = surface.loops();
  for (const std::uint32_t v : mesh.triangles[t])
    if (v < loops.size() && std::abs(field.patch_distance(mesh.vertices[v], face)) > kMissed)
      cells.push_back(loops[v].cell);
  if (!cells.empty()) {
    if (ahead) add_ahead(field, tree, face, cells);
    return cells;
  }
  const Crossing& c = at(surface.crossings(), surface.mesh().crossings[t]);
  std::int32_t largest = 0;
  for (const std::int32_t cell : c.edge.cells) largest = std::max(largest, tree.node(cell).size);
  for (const std::int32_t cell : c.edge.cells)
    if (tree.node(cell).size == largest) cells.push_back(cell);
  return cells;
}

}  // namespace mrsim::detail
