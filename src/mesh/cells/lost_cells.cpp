#include "mesh/cells/lost_cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

namespace mrsim::detail {
namespace {

// A sample lies in a wall along an axis if cells are no wider than it; in a wall or pin that is
// turned, if they are a little narrower.
constexpr double kOfThickness = 0.7;
// What is much thinner than others waits: beside these it may be a corner of theirs.
constexpr double kOfThickest = 0.4;
// Nodes that may be added, and bytes that each of them takes in the end.
constexpr double kMostLostNodes = 2'400'000, kLostNodeMemory = 1500;
// Up to which share of the most nodes there are more for what is lost, and the share of those left.
constexpr double kFullOctree = 0.75, kLostShare = 0.8;

double width(const CellOctree& tree, std::int32_t cell) {
  const Box3 box = tree.box(cell);
  return box.hi.x - box.lo.x;
}

// Nodes that come of splitting all about a place that is lost: it stands for a square of a voxel,
// or for as much of a pin. The sides of what is found are split on until they are within the
// tolerance: in all, six times as many as the cells that a single sheet passes.
double nodes_about(double voxel, double goal) {
  constexpr double kBesideSheet = 6;
  const double halvings = std::max(0.0, std::ceil(std::log2(voxel / goal)));
  return kBesideSheet * 8 / 3 * std::pow(4.0, halvings);
}

// The width (mm) that each leaf about some features is to be split to.
using Goals = std::unordered_map<std::int32_t, double>;

// The walls and gaps between two owners. Where only a part of one were drawn, its torn border would
// fail, and be split until the rest of it is there.
struct LostWall {
  double thickness = 0;  // mm, the largest: lines through a pin's corner see less of it
  std::vector<const ThinFeature*> places;
};

std::vector<LostWall> lost_walls(std::span<const FoundThin> lost, double tolerance) {
  std::map<std::pair<std::int32_t, std::int32_t>, LostWall> by_owners;
  for (const auto& [feature, block] : lost) {
    if (!(feature.thickness > tolerance)) continue;
    LostWall& wall = by_owners[{feature.owner[0], feature.owner[1]}];
    wall.places.push_back(&feature);
  }
  std::vector<LostWall> walls;
  for (auto& [owners, wall] : by_owners) {
    for (const ThinFeature* place : wall.places)
      wall.thickness = std::max(wall.thickness, place->thickness);
    walls.push_back(std::move(wall));
  }
  std::stable_sort(walls.begin(), walls.end(),
                   [](const LostWall& a, const LostWall& b) { return a.thickness > b.thickness; });
  return walls;
}

// The leaves about a place. Most features lie on an edge of the grid, which up to four leaves
// share.
std::array<std::int32_t, 8> leaves_about(const CellOctree& tree, const ThinFeature& feature,
                                         std::int32_t near) {
  const double beside = 0.25 * std::min(feature.thickness, tree.lattice().voxel());
  std::array<std::int32_t, 8> leaves;
  for (int k = 0; k < 8; ++k) {
    const Vec3 offset{k & 1 ? beside : -beside, k & 2 ? beside : -beside, k & 4 ? beside : -beside};
    near = leaves[static_cast<std::size_t>(k)] = tree.locate(feature.place + offset, near);
  }
  return leaves;
}

// How many lost places lie about each leaf.
std::unordered_map<std::int32_t, std::size_t> places_in_leaves(const CellOctree& tree,
                                                               std::span<const LostWall> walls) {
  std::unordered_map<std::int32_t, std::size_t> count;
  std::int32_t near = 0;
  for (const LostWall& wall : walls)
    for (const ThinFeature* place : wall.places) {
      near = tree.locate(place->place, near);
      ++count[near];
    }
  return count;
}

Goals wanted_widths(const CellOctree& tree, std::span<const FoundThin> lost, double tolerance,
                    double room) {
  const double voxel = tree.lattice().voxel();
  const std::vector<LostWall> walls = lost_walls(lost, tolerance);
  const auto places = places_in_leaves(tree, walls);
  Goals goals;
  std::int32_t near = 0;
  double thickest = 0;
  for (const LostWall& wall : walls) {
    if (wall.thickness < kOfThickest * thickest) break;
    const double wished = kOfThickness * wall.thickness;
    Goals added;
    for (const ThinFeature* feature : wall.places)
      for (const std::int32_t leaf : leaves_about(tree, *feature, near)) {
        // What is lost in cells as narrow as that needs narrower ones.
        added.emplace(leaf, std::min(wished, 0.5 * width(tree, leaf)));
        near = leaf;
      }
    double more = 0;
    for (const auto& [leaf, goal] : added) {
      const auto known = goals.find(leaf);
      if (known != goals.end() && known->second <= goal) continue;
      const auto here = places.find(leaf);
      const std::size_t count = here == places.end() ? 1 : here->second;
      more += static_cast<double>(count) * nodes_about(voxel, goal);
    }
    if (more > room) continue;
    room -= more;
    thickest = std::max(thickest, wall.thickness);
    for (const auto& [leaf, goal] : added) {
      const auto [at, is_new] = goals.try_emplace(leaf, goal);
      at->second = std::min(at->second, goal);
    }
  }
  return goals;
}

}  // namespace

double room_for_lost(std::size_t nodes, double most, double memory) {
  const double room = std::min(kMostLostNodes, memory / kLostNodeMemory);
  if (most == 0) return room;
  return std::min(room, kLostShare * (kFullOctree * most - static_cast<double>(nodes)));
}

std::size_t split_lost(CellOctree& tree, std::span<const FoundThin> lost, double tolerance,
                       double room) {
  const Goals goals = wanted_widths(tree, lost, tolerance, room);
  std::vector<std::pair<std::int32_t, double>> pending(goals.begin(), goals.end()), next;
  std::sort(pending.begin(), pending.end());
  std::size_t count = 0;
  while (!pending.empty()) {
    std::vector<std::int32_t> cells;
    for (const auto& [cell, goal] : pending)
      if (tree.node(cell).child < 0 && width(tree, cell) > goal) cells.push_back(cell);
    count += tree.split(std::move(cells));
    next.clear();
    for (const auto& [cell, goal] : pending) {
      const std::int32_t child = tree.node(cell).child;
      for (std::int32_t k = 0; child >= 0 && k < 8; ++k)
        if (tree.is_mixed(child + k) && !tree.node(child + k).plain &&
            width(tree, child + k) > goal)
          next.emplace_back(child + k, goal);
    }
    std::swap(pending, next);
  }
  return count;
}

}  // namespace mrsim::detail
