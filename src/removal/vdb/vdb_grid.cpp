#include "removal/vdb/vdb_grid.h"

#include "core/process/parallel.h"
#include "removal/vdb/cut_grid.h"
#include "removal/vdb/voxel_hash.h"

#include <algorithm>
#include <functional>

#include <openvdb/io/Stream.h>

namespace mrsim {

namespace {

// Addresses that part the leaves into stretches of about as many; the last one has no end.
std::vector<const FloatLeaf*> stretches(
    const std::vector<std::pair<FloatLeaf*, OwnerLeaf*>>& leaves, std::size_t parts) {
  constexpr std::size_t kSome = 64;  // every so many-th is looked at
  std::vector<const FloatLeaf*> some, ends;
  for (std::size_t k = 0; k < leaves.size(); k += kSome) some.push_back(leaves[k].first);
  std::sort(some.begin(), some.end(), std::less<>());
  for (std::size_t part = 1; part < parts; ++part)
    ends.push_back(some.empty() ? nullptr : some[some.size() * part / parts]);
  return ends;
}

}  // namespace

// The leaves of the two trees lie side by side in memory. They are freed so, in the order in which
// they were made: a third of the time of one tree after the other. Each thread frees those of a
// stretch of memory, which mostly is the heap of one thread: two that free leaves of one heap wait
// for each other.
VdbGrid::~VdbGrid() {
  std::vector<FloatLeaf*> distances;
  std::vector<OwnerLeaf*> owners;
  parallel_for(2, threads, [&](std::size_t tree) {
    if (tree == 0)
      distance->tree().stealNodes(distances);
    else
      owner->tree().stealNodes(owners);
  });
  const auto parts = static_cast<std::size_t>(resolve_threads(threads));
  const std::vector<const FloatLeaf*> ends = stretches(leaves, parts);
  parallel_for(parts, threads, [&](std::size_t part) {
    const std::less<> before;
    for (const auto& [distance_leaf, owner_leaf] : leaves) {
      if (part > 0 && before(distance_leaf, ends[part - 1])) continue;
      if (part + 1 < parts && !before(distance_leaf, ends[part])) continue;
      delete distance_leaf, delete owner_leaf;
    }
  });
}

std::size_t VdbGrid::memory() const { return distance->memUsage() + owner->memUsage(); }

void VdbGrid::write(const PartField& field, const BlockIndex& index, const std::string& recipe,
                    std::ostream& out) const {
  openvdb::Int32Grid::Ptr cut;
  with_threads(threads,
               [&] { cut = make_cut_grid(field, index, distance->transform().copy(), threads); });
  openvdb::io::Stream archive(out);
  archive.setCompression(openvdb::io::COMPRESS_ZIP | openvdb::io::COMPRESS_ACTIVE_MASK);
  openvdb::MetaMap metadata;
  metadata.insertMeta(kRecipeMetadata, openvdb::StringMetadata(recipe));
  metadata.insertMeta(kVoxelsMetadata, openvdb::StringMetadata(voxel_hash(*distance)));
  archive.write(openvdb::GridCPtrVec{distance, owner, cut}, metadata);
}

}  // namespace mrsim
