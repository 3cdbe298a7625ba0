#include "removal/history/cut_faces.h"

#include "core/numbers/rounding.h"
#include "core/numbers/vec.h"
#include "core/process/parallel.h"
#include "removal/part/block_index.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace mrsim {
namespace {

constexpr int kSide = 8;  // voxels of a leaf each way

std::uint8_t to_byte(double x) { return std::uint8_t(std::clamp(std::lround(x), 0L, 255L)); }

FaceSurface packed(double share, const Vec3& normal) {
  const double sum = std::abs(normal.x) + std::abs(normal.y) + std::abs(normal.z);
  double u = sum > 0 ? normal.x / sum : 0, v = sum > 0 ? normal.y / sum : 0;
  if (normal.z < 0) {
    const double folded = (1 - std::abs(v)) * (u < 0 ? -1 : 1);
    v = (1 - std::abs(u)) * (v < 0 ? -1 : 1);
    u = folded;
  }
  return {to_byte(255 * share), to_byte(127 * u + 127), to_byte(127 * v + 127)};
}

// Zero of a distance that has different signs at 0 and 1, by false position with halved ends.
template <typename Distance>
double crossing(const Distance& distance, double tolerance) {
  double a = 0, b = 1, fa = distance(a), fb = distance(b);
  if ((fa > 0) == (fb > 0)) return std::abs(fa) < std::abs(fb) ? a : b;
  double t = 0.5;
  for (int round = 0; round < 8; ++round) {
    t = fa == fb ? (a + b) / 2 : std::clamp(a + (b - a) * fa / (fa - fb), a, b);
    const double f = distance(t);
    if (std::abs(f) <= tolerance) break;
    if ((f > 0) == (fa > 0))
      a = t, fa = f, fb /= 2;
    else
      b = t, fb = f, fa /= 2;
  }
  return t;
}

// The faces of a square of columns.
class FaceMaker {
 public:
  FaceMaker(const PartField& field, const CutVolume& volume, std::int32_t inherited)
      : field_(field),
        volume_(volume),
        inherited_(inherited),
        tolerance_(volume.lattice.voxel * 1e-3) {}

  std::int32_t moment(std::size_t voxel) const { return moment_of(volume_.cut[voxel], inherited_); }
  /// The neighbour above a voxel along an axis that goes at another moment, if there is one.
  std::optional<std::size_t> neighbour(int x, int y, int z, int axis) const {
    const int at[3] = {x + (axis == 0), y + (axis == 1), z + (axis == 2)};
    if (at[axis] >= volume_.size[std::size_t(axis)]) return std::nullopt;
    const std::size_t other = volume_.index(at[0], at[1], at[2]);
    if (moment(other) == moment(volume_.index(x, y, z))) return std::nullopt;
    return other;
  }

  /// Goes from the voxel `low` at `from` to its neighbour `high` at `to`. `sweeps`: the candidates
  /// of the part there.
  void make(std::size_t low, std::size_t high, const Vec3& from, const Vec3& to,
            const Candidates& sweeps, FaceSurface& out, std::vector<LateSurface>& late,
            std::uint32_t face) const {
    const std::size_t first = moment(low) < moment(high) ? low : high;
    const std::int32_t owner = volume_.cut[first];
    out = owner == kNeverThere ? on_stock(from, to) : on_sweep(owner, from, to);
    if (std::max(moment(low), moment(high)) != kNeverGoes) return;
    const auto [surface, last] = at_end(from, to, sweeps);
    if (last != kStockOwner && moment_of(last, inherited_) > moment(first))
      late.push_back({face, moment_of(last, inherited_), surface});
    else
      out = surface;
  }

 private:
  FaceSurface on_stock(const Vec3& from, const Vec3& to) const {
    const StockSolid& solid = field_.solid();
    const double t =
        crossing([&](double s) { return solid.distance(lerp(from, to, s)); }, tolerance_);
    const Vec3 p = lerp(from, to, t);
    return packed(t, solid.gradient(p, solid.sample(p).patch));
  }
  FaceSurface on_sweep(std::int32_t owner, const Vec3& from, const Vec3& to) const {
    const SweepTable& sweeps = field_.sweeps();
    const std::size_t i = field_.candidate(owner);
    const double t =
        crossing([&](double s) { return sweeps.distance(i, lerp(from, to, s)); }, tolerance_);
    const Vec3 p = lerp(from, to, t);
    return packed(t, -sweeps.gradient(i, p, sweeps.patch(i, p)));
  }
  std::pair<FaceSurface, std::int32_t> at_end(const Vec3& from, const Vec3& to,
                                              const Candidates& sweeps) const {
    const double t = crossing(
        [&](double s) { return field_.sample(lerp(from, to, s), sweeps).distance; }, tolerance_);
    const Vec3 p = lerp(from, to, t);
    const FieldSample at = field_.sample(p, sweeps);
    return {packed(t, field_.gradient(p, at)), at.owner};
  }

  const PartField& field_;
  const CutVolume& volume_;
  std::int32_t inherited_;
  double tolerance_;
};

// Which sweeps can decide the part in a leaf.
class LeafCandidates {
 public:
  LeafCandidates(const PartField& field, const CutVolume& volume, int threads)
      : field_(field), volume_(volume), all_(field.all()) {
    if (volume.lattice.half_plane) return;
    index_.emplace(field, volume.lattice.voxel, reach(), std::numeric_limits<std::size_t>::max(),
                   threads);
  }

  Candidates of(int x, int y, int z) const {
    const Vec3 low = volume_.center(x, y, z);
    const double size = volume_.lattice.voxel * kSide;
    Box3 box = inflated({low, low + Vec3{size, size, size}}, reach() / 2);
    if (!index_) {
      box.lo.x = box.lo.y = -kInfinity;
      box.hi.x = box.hi.y = kInfinity;
      return field_.sweeps().expanded(all_, box);
    }
    const std::size_t block = index_->find(low + Vec3{size / 2, size / 2, size / 2});
    Candidates out;
    if (block < index_->size())
      field_.restrict_to(box, reach(), field_.sweeps().expanded(index_->sweeps(block), box), out);
    return out;
  }

 private:
  double reach() const { return 2 * volume_.lattice.voxel; }
  const PartField& field_;
  const CutVolume& volume_;
  Candidates all_;
  std::optional<BlockIndex> index_;  // in space
};

// Number of the first face of each column of voxels.
std::vector<std::uint32_t> first_faces(const FaceMaker& maker, const CutVolume& volume,
                                       int threads) {
  const std::size_t columns = std::size_t(volume.size[0]) * std::size_t(volume.size[1]);
  std::vector<std::uint32_t> first(columns + 1, 0);
  parallel_for(std::size_t(volume.size[0]), threads, [&](std::size_t x) {
    for (int y = 0; y < volume.size[1]; ++y) {
      std::uint32_t& count = first[x * std::size_t(volume.size[1]) + std::size_t(y) + 1];
      for (int z = 0; z < volume.size[2]; ++z)
        for (int axis = 0; axis < 3; ++axis)
          count += maker.neighbour(int(x), y, z, axis).has_value();
    }
  });
  for (std::size_t c = 0; c < columns; ++c) first[c + 1] += first[c];
  return first;
}

// The faces whose lower voxel lies in a leaf. `next`: number of the next face of each column.
void make_leaf(const FaceMaker& maker, const CutVolume& volume, const LeafCandidates& candidates,
               const std::array<int, 3>& low, std::vector<std::uint32_t>& next,
               std::vector<FaceSurface>& faces, std::vector<LateSurface>& late) {
  std::optional<Candidates> sweeps;
  const auto end = [&](std::size_t axis) { return std::min(low[axis] + kSide, volume.size[axis]); };
  for (int x = low[0]; x < end(0); ++x)
    for (int y = low[1]; y < end(1); ++y) {
      std::uint32_t& face = next[std::size_t(x) * std::size_t(volume.size[1]) + std::size_t(y)];
      for (int k = 3 * low[2]; k < 3 * end(2); ++k) {
        const int z = k / 3, axis = k % 3;
        const std::optional<std::size_t> other = maker.neighbour(x, y, z, axis);
        if (!other) continue;
        if (!sweeps) sweeps = candidates.of(low[0], low[1], low[2]);
        const Vec3 from = volume.center(x, y, z),
                   to = volume.center(x + (axis == 0), y + (axis == 1), z + (axis == 2));
        maker.make(volume.index(x, y, z), *other, from, to, *sweeps, faces[face], late, face);
        ++face;
      }
    }
}

}  // namespace

CutFaces make_cut_faces(const PartField& field, const CutVolume& volume, std::int32_t inherited,
                        int threads) {
  const FaceMaker maker(field, volume, inherited);
  const LeafCandidates candidates(field, volume, threads);
  std::vector<std::uint32_t> next = first_faces(maker, volume, threads);
  CutFaces out;
  out.faces.resize(next.back());
  const int across = (volume.size[0] + kSide - 1) / kSide,
            along = (volume.size[1] + kSide - 1) / kSide;
  std::vector<std::vector<LateSurface>> late(std::size_t(across) * std::size_t(along));
  parallel_for(late.size(), threads, [&](std::size_t tile) {
    const int x = int(tile) / along * kSide, y = int(tile) % along * kSide;
    for (int z = 0; z < volume.size[2]; z += kSide)
      make_leaf(maker, volume, candidates, {x, y, z}, next, out.faces, late[tile]);
  });
  for (const auto& found : late) out.late.insert(out.late.end(), found.begin(), found.end());
  std::sort(out.late.begin(), out.late.end(),
            [](const LateSurface& a, const LateSurface& b) { return a.face < b.face; });
  return out;
}

}  // namespace mrsim
