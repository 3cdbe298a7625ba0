#include "mesh/simplify/simplify.h"

#include "core/numbers/vec.h"
#include "core/process/parallel.h"
#include "mesh/simplify/vertex_remover.h"

#include <algorithm>
#include <numeric>

namespace mrsim::detail {
namespace {

constexpr std::size_t kBlocks = 8;        ///< parts of the mesh that are worked on at once
constexpr std::size_t kLeastBlock = 256;  ///< vertices that are worth a block

// Slices of equally many vertices across the longest side, in the order of the vertices.
std::vector<std::vector<std::uint32_t>> slices(const std::vector<Vec3>& vertices, const Box3& box,
                                               std::size_t count) {
  const Vec3 size = box.hi - box.lo;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  std::vector<double> places;
  for (const Vec3& p : vertices) places.push_back(component(p, axis));
  std::vector<double> sorted = places;
  std::sort(sorted.begin(), sorted.end());
  std::vector<double> bounds;
  for (std::size_t k = 1; k < count; ++k) bounds.push_back(sorted[k * sorted.size() / count]);
  std::vector<std::vector<std::uint32_t>> out(count);
  for (std::uint32_t v = 0; v < places.size(); ++v)
    out[static_cast<std::size_t>(std::upper_bound(bounds.begin(), bounds.end(), places[v]) -
                                 bounds.begin())]
        .push_back(v);
  return out;
}

}  // namespace

MeshSimplifier::MeshSimplifier(const ExactField& field, const CellOctree& tree,
                               const LabelledMesh& mesh, const SimplifyLimits& limits, int threads)
    : field_(field), tree_(tree), mesh_(mesh), limits_(limits), threads_(threads) {}

MeshSimplifier::~MeshSimplifier() = default;

void MeshSimplifier::find_blocks() {
  by_blocks_ = std::make_unique<CollapsedMesh>(mesh_);
  Box3 box;
  for (const Vec3& p : mesh_.vertices) extend(box, p);
  most_ = mesh_.vertices.empty() ? 0 : length(box.hi - box.lo);
  const std::size_t count = std::min(kBlocks, mesh_.vertices.size() / kLeastBlock);
  if (count > 1) blocks_ = slices(mesh_.vertices, box, count);
  measured_.resize(blocks_.size() + 1);
  by_blocks_->block.resize(mesh_.vertices.size());
  for (std::size_t k = 0; k < blocks_.size(); ++k)
    for (const std::uint32_t v : blocks_[k]) by_blocks_->block[v] = static_cast<std::uint8_t>(k);
}

// Brings the blocks up to date in which other vertices are locked than before.
void MeshSimplifier::simplify_blocks(const std::vector<char>& locked) {
  std::vector<char> changed;
  if (!by_blocks_) {
    find_blocks();
    changed.assign(blocks_.size(), 1);
  } else {
    changed.assign(blocks_.size(), 0);
    for (std::size_t v = 0; v < locked.size() && !blocks_.empty(); ++v)
      if (locked[v] != by_blocks_->locked[v]) changed[by_blocks_->block[v]] = 1;
    by_blocks_->restore(changed);
  }
  by_blocks_->locked = locked;
  parallel_for(blocks_.size(), threads_, [&](std::size_t k) {
    if (changed[k])
      remove_vertices(field_, tree_, limits_, blocks_[k], most_, *by_blocks_, measured_[k]);
  });
}

LabelledMesh MeshSimplifier::simplified(const std::vector<char>& locked) {
  simplify_blocks(locked);
  CollapsedMesh whole = *by_blocks_;
  whole.block.clear();
  std::vector<std::uint32_t> all(mesh_.vertices.size());
  std::iota(all.begin(), all.end(), 0u);
  remove_vertices(field_, tree_, limits_, all, most_, whole, measured_.back());
  return whole.compact();
}

}  // namespace mrsim::detail
