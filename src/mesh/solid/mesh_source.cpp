#include "mesh/solid/mesh_source.h"

#include "core/process/error.h"

namespace mrsim {

const std::vector<ColorLabel>& MeshSource::legend() const {
  static const std::vector<ColorLabel> none;
  return none;
}

namespace {

template <class T>
void append(ScratchFile& file, std::span<const T> items) {
  file.append(items.data(), items.size_bytes());
}

template <class T>
void read(const ScratchFile& file, std::uint64_t& offset, std::size_t count, std::vector<T>& out) {
  out.resize(count);
  file.read(offset, out.data(), count * sizeof(T));
  offset += count * sizeof(T);
}

}  // namespace

void SpilledMesh::take(const MeshBlock& block) {
  MRSIM_ASSERT(block.owners.size() == block.triangles.size() && block.colors.empty());
  records_.push_back({file_.size(), block.points.size(), block.borrowed.size(),
                      block.triangles.size(), block.unfinished.size(), block.first_new});
  append(file_, block.points);
  append(file_, block.borrowed);
  append(file_, block.triangles);
  append(file_, block.owners);
  append(file_, block.unfinished);
  vertices_ += block.fresh().size();
  triangles_ += block.triangles.size();
}

void SpilledMesh::restart() {
  file_.clear();
  records_.clear();
  vertices_ = triangles_ = 0;
}

void SpilledMesh::for_each_block(const Body& body) const {
  std::vector<std::array<float, 3>> points;
  std::vector<std::uint32_t> borrowed, unfinished;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::int32_t> owners;
  for (const Record& record : records_) {
    std::uint64_t offset = record.offset;
    read(file_, offset, record.points, points);
    read(file_, offset, record.borrowed, borrowed);
    read(file_, offset, record.triangles, triangles);
    read(file_, offset, record.triangles, owners);
    read(file_, offset, record.unfinished, unfinished);
    body({points, borrowed, record.first_new, triangles, owners, {}, unfinished});
  }
}

}  // namespace mrsim
