#include "mesh/cells/doubtful_edges.h"

#include "core/numbers/vec.h"
#include "mesh/cells/cells.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace mrsim::detail {
namespace {

constexpr double kEven =
    0.3;  ///< of a voxel: the largest second difference of distances that run evenly

// A part of a cell in voxels, both ends included.
struct DoubtfulPart {
  std::int32_t lo[3], hi[3];
  std::int32_t side(int axis) const { return hi[axis] - lo[axis] + 1; }
};

// Finds the doubtful edges of the voxel lattice in a cell. It splits the cell into eighths and
// drops those that the surface does not pass. Whether distances run evenly across an edge takes the
// points beside its ends, too: the points beside a part are sampled as far as they lie in the cell.
class DoubtfulSearch {
 public:
  DoubtfulSearch(const ExactField& field, const Lattice& lattice,
                 std::span<const std::uint32_t> candidates, const LatticePoint& origin,
                 std::int32_t voxels, bool alike, std::vector<VoxelEdge>& out)
      : field_(field),
        lattice_(lattice),
        origin_(origin),
        voxels_(voxels),
        alike_(alike),
        out_(out),
        descent_(field.descent(position(voxels / 2, voxels / 2, voxels / 2), candidates)) {}

  void look() { look({{0, 0, 0}, {voxels_, voxels_, voxels_}}, 1); }

 private:
  static constexpr std::int32_t kSampled = 4;  // voxels to a side
  static constexpr std::size_t kMostPoints = (kSampled + 3) * (kSampled + 3) * (kSampled + 3);

  void look(const DoubtfulPart& part, std::size_t tier) {
    DoubtfulPart near = part;
    for (int a = 0; a < 3; ++a) {
      near.lo[a] = std::max(part.lo[a] - 1, 0);
      near.hi[a] = std::min(part.hi[a] + 1, voxels_);
    }
    const Box3 box = inflated(Box3{position(near.lo[0], near.lo[1], near.lo[2]),
                                   position(near.hi[0], near.hi[1], near.hi[2])},
                              kQuantum);
    const std::int32_t size = part.hi[0] - part.lo[0];
    const bool last = size <= kSampled;
    if (descent_->enter(tier, box, kSurfaceBand, last) != ExactField::Region::mixed) return;
    if (last || descent_->is_short(tier)) {
      descent_->candidates(tier, left_);
      if (is_alone(box, left_)) return;
    }
    if (last) return look_closely(part, near, left_);
    for (int k = 0; k < 8; ++k) {
      DoubtfulPart eighth = part;
      for (int a = 0; a < 3; ++a) (k >> a & 1 ? eighth.lo : eighth.hi)[a] = part.lo[a] + size / 2;
      look(eighth, tier + 1);
    }
  }

  // Only one owner can decide d in the box: no edge in it has ends with different owners.
  bool is_alone(const Box3& box, std::span<const std::uint32_t> candidates) const {
    static thread_local Candidates sweeps;
    const double room = 0.5 * length(box.hi - box.lo) + kSurfaceBand;
    const bool near_stock = std::abs(field_.sample(0.5 * (box.lo + box.hi), {}).distance) <= room;
    return !alike_ && field_.expand_packs(box, kSurfaceBand, candidates, sweeps) &&
           sweeps.size() + near_stock <= 1;
  }

  LatticePoint point(std::int32_t x, std::int32_t y, std::int32_t z) const {
    const std::int32_t step = lattice_.per_voxel();
    return {origin_.x + x * step, origin_.y + y * step, origin_.z + z * step};
  }
  Vec3 position(std::int32_t x, std::int32_t y, std::int32_t z) const {
    return lattice_.position(point(x, y, z));
  }

  // d at the points of a part, and what decides it.
  struct Samples {
    DoubtfulPart range;
    std::int32_t stride[3];
    double d[kMostPoints];
    std::uint32_t deciders[kMostPoints];

    std::int32_t id(const std::int32_t (&at)[3]) const {
      std::int32_t i = 0;
      for (int a = 0; a < 3; ++a) i += (at[a] - range.lo[a]) * stride[a];
      return i;
    }
  };
  void sample(const DoubtfulPart& range, std::span<const std::uint32_t> candidates,
              Samples& out) const {
    Vec3 points[kMostPoints];
    std::size_t count = 0;
    for (std::int32_t x = range.lo[0]; x <= range.hi[0]; ++x)
      for (std::int32_t y = range.lo[1]; y <= range.hi[1]; ++y)
        for (std::int32_t z = range.lo[2]; z <= range.hi[2]; ++z)
          points[count++] = position(x, y, z);
    field_.distances({points, count}, candidates, out.d, out.deciders);
    out.range = range;
    out.stride[0] = range.side(1) * range.side(2);
    out.stride[1] = range.side(2);
    out.stride[2] = 1;
  }

  // Samples the part alone first. Only where an edge in it may be doubtful are the points beside
  // the part sampled as well.
  void look_closely(const DoubtfulPart& part, const DoubtfulPart& near,
                    std::span<const std::uint32_t> candidates) const {
    Samples samples;
    sample(part, candidates, samples);
    const std::size_t before = out_.size();
    add_doubtful(part, samples);
    if (out_.size() == before) return;
    out_.resize(before);
    sample(near, candidates, samples);
    add_doubtful(part, samples);
  }

  void add_doubtful(const DoubtfulPart& part, const Samples& samples) const {
    for (std::int32_t x = part.lo[0]; x < part.hi[0]; ++x)
      for (std::int32_t y = part.lo[1]; y < part.hi[1]; ++y)
        for (std::int32_t z = part.lo[2]; z < part.hi[2]; ++z)
          for (int axis = 0; axis < 3; ++axis)
            if (is_doubtful(samples, {x, y, z}, axis)) out_.push_back({point(x, y, z), axis});
  }
  bool is_doubtful(const Samples& s, const std::int32_t (&at)[3], int axis) const {
    const std::int32_t step = s.stride[axis], i = s.id(at), j = i + step;
    const double* d = s.d;
    if (is_inside(d[i]) != is_inside(d[j])) return alike_;
    if (s.deciders[i] == s.deciders[j] || std::abs(d[i]) + std::abs(d[j]) > lattice_.voxel())
      return false;
    const bool is_known = at[axis] > s.range.lo[axis] && at[axis] + 2 <= s.range.hi[axis];
    return !is_known || !run_evenly({d[i - step], d[i], d[j], d[j + step]}, lattice_.voxel());
  }

  const ExactField& field_;
  const Lattice& lattice_;
  LatticePoint origin_;
  std::int32_t voxels_;
  bool alike_;
  std::vector<VoxelEdge>& out_;
  std::unique_ptr<ExactField::Descent> descent_;
  Candidates left_;
};

}  // namespace

bool run_evenly(const std::array<double, 4>& d, double voxel) {
  const double rise = d[2] - d[1];
  for (const double next : {d[1] - d[0], d[3] - d[2]})
    if (!(next * rise >= 0 && std::abs(next - rise) <= kEven * voxel)) return false;
  return true;
}

std::vector<VoxelEdge> doubtful_inside(const ExactField& field, const Lattice& lattice,
                                       std::span<const std::uint32_t> candidates,
                                       const LatticePoint& origin, std::int32_t voxels,
                                       bool alike) {
  std::vector<VoxelEdge> out;
  DoubtfulSearch(field, lattice, candidates, origin, voxels, alike, out).look();
  return out;
}

}  // namespace mrsim::detail
