#include "removal/vdb/turned_carver.h"

#include <cmath>

namespace mrsim {

std::vector<LeafPair> TurnedCarver::carve(const std::array<std::int32_t, 3>& at) {
  const openvdb::Coord origin(at[0], at[1], at[2]);
  std::vector<LeafPair> leaves;
  if (!meets_surface(origin)) return leaves;
  sort_columns(origin);
  for (int z = 0; z < kBlockVoxels; z += kLeafVoxels) {
    find_material(origin.offsetBy(0, 0, z));
    for (int i = 0; i < kLeafVoxels; ++i) carve_layer(origin.offsetBy(0, 0, z), i);
    for (LeafPair& leaf : slab_) {
      if (leaf.distance && !leaf.distance->isEmpty()) leaves.push_back(std::move(leaf));
      leaf = {};
    }
  }
  return leaves;
}

bool TurnedCarver::meets_surface(const openvdb::Coord& origin) const {
  const double half = 0.5 * (kBlockVoxels - 1) * voxel_;
  const double x = std::abs(lattice_position(voxel_, origin.x(), kLatticeShift.x) + half),
               y = std::abs(lattice_position(voxel_, origin.y(), kLatticeShift.y) + half);
  const double near_x = std::max(x - half, 0.0), near_y = std::max(y - half, 0.0);
  const double far_x = x + half, far_y = y + half;
  const double low = std::sqrt(near_x * near_x + near_y * near_y) - voxel_;
  const double high = std::sqrt(far_x * far_x + far_y * far_y) + voxel_;
  for (int z = 0; z < kBlockVoxels; ++z) {
    const std::vector<Interval>& list = layers_.at(origin.z() + z).intervals;
    double from = 0;
    for (const Interval& in : list) {
      if (in.region == ExactField::Region::mixed && from <= high && in.end >= low) return true;
      from = in.end;
    }
  }
  return false;
}

// Sorts into buckets first; insertion then has little left to move.
void TurnedCarver::sort_columns(const openvdb::Coord& origin) {
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (std::size_t x = 0; x < kSide; ++x)
    for (std::size_t y = 0; y < kSide; ++y) {
      const double px = lattice_position(voxel_, origin.x() + static_cast<int>(x), kLatticeShift.x),
                   py = lattice_position(voxel_, origin.y() + static_cast<int>(y), kLatticeShift.y);
      const double rho = std::sqrt(px * px + py * py);
      rho_[x * kSide + y] = rho;
      least = std::min(least, rho), most = std::max(most, rho);
    }
  const double scale = (kColumns - 1) / (most - least);
  const auto bucket = [&](double rho) { return static_cast<std::size_t>((rho - least) * scale); };
  std::array<std::uint32_t, kColumns + 1> place{};
  for (const double rho : rho_) ++place[bucket(rho) + 1];
  for (std::size_t b = 1; b <= kColumns; ++b) place[b] += place[b - 1];
  for (std::size_t i = 0; i < kColumns; ++i) {
    const std::size_t x = i / kSide, y = i % kSide;
    columns_[place[bucket(rho_[i])]++] = {
        rho_[i], static_cast<std::uint16_t>(x / kLeafVoxels * kSlabSide + y / kLeafVoxels),
        static_cast<std::uint16_t>((x % kLeafVoxels * kLeafVoxels + y % kLeafVoxels) *
                                   kLeafVoxels)};
  }
  for (std::size_t i = 1; i < kColumns; ++i) {
    const Column c = columns_[i];
    std::size_t k = i;
    for (; k > 0 && c.rho < columns_[k - 1].rho; --k) columns_[k] = columns_[k - 1];
    columns_[k] = c;
  }
}

void TurnedCarver::carve_layer(const openvdb::Coord& slab, int z) {
  const TurnLayers::Layer& layer = layers_.at(slab.z() + z);
  std::span<const Column> columns = columns_;
  for (const Interval& in : layer.intervals) {
    const auto end = std::partition_point(columns.begin(), columns.end(),
                                          [&](const Column& c) { return c.rho <= in.end; });
    auto within = columns.first(static_cast<std::size_t>(end - columns.begin()));
    columns = columns.subspan(within.size());
    while (in.region == ExactField::Region::mixed && !within.empty()) {
      const std::size_t some = std::min(within.size(), PointColumns::kMost);
      evaluate(slab, z, within.first(some), layer, in);
      within = within.subspan(some);
    }
  }
}

void TurnedCarver::evaluate(const openvdb::Coord& slab, int z, std::span<const Column> columns,
                            const TurnLayers::Layer& layer, const Interval& in) {
  const double height = lattice_position(voxel_, slab.z() + z, kLatticeShift.z);
  points_.count = (columns.size() + 7) / 8 * 8;
  for (std::size_t k = 0; k < points_.count; ++k) {
    points_.x[k] = columns[std::min(k, columns.size() - 1)].rho, points_.y[k] = 0;
    points_.z[k] = height;
    points_.least[k] = std::numeric_limits<double>::infinity(), points_.nearest[k] = 0;
  }
  least_of(field_.sweeps().turn_tree().turns(), {layer.members.data() + in.first, in.count},
           layer.sides, points_);
  combine_stock(in.in_stock);
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const Column& c = columns[k];
    if (!slab_[c.leaf].distance) open_leaf(slab, c.leaf);
    store(views_[c.leaf], k, c.offset + static_cast<std::size_t>(z), 1);
  }
}

// What is certain of all layers of a slab.
void TurnedCarver::find_material(const openvdb::Coord& slab) {
  Stretch nowhere;
  nowhere.from.fill(std::numeric_limits<double>::infinity()), nowhere.to.fill(0);
  material_.clear();
  for (std::size_t z = 0; z < kLeafVoxels; ++z) {
    double from = -1;
    std::size_t count = 0;
    for (const Interval& in : layers_.at(slab.z() + static_cast<int>(z)).intervals) {
      if (in.region == ExactField::Region::material) {
        if (count == material_.size()) material_.push_back(nowhere);
        material_[count].from[z] = from, material_[count].to[z] = in.end, ++count;
      }
      from = in.end;
    }
  }
}

void TurnedCarver::open_leaf(const openvdb::Coord& slab, std::size_t leaf) {
  const std::size_t x0 = leaf / kSlabSide * kLeafVoxels, y0 = leaf % kSlabSide * kLeafVoxels;
  slab_[leaf] = new_leaf(slab.offsetBy(static_cast<int>(x0), static_cast<int>(y0), 0));
  views_[leaf] = LeafView(slab_[leaf]);
  const float inside = -static_cast<float>(band_);
  for (const Stretch& s : material_)
    for (std::size_t i = 0; i < kLeafVoxels * kLeafVoxels; ++i) {
      const double rho = rho_[(x0 + i / kLeafVoxels) * kSide + y0 + i % kLeafVoxels];
      float* row = views_[leaf].distance + i * kLeafVoxels;
      for (std::size_t z = 0; z < kLeafVoxels; ++z)
        row[z] = ((rho > s.from[z]) & (rho <= s.to[z])) ? inside : row[z];
    }
}

}  // namespace mrsim
