// Meshes kept in a file while they are made, as runs in slabs do: the same files as from memory,
// also where the tiles have to be made again.
#include "core/numbers/vec.h"
#include "mesh/format/mesh_io.h"
#include "mesh/mesh_part.h"
#include "mesh/solid/check.h"
#include "mesh/solid/mesh_block.h"
#include "mesh/solid/mesh_source.h"
#include "mesh/tiles/uniform.h"
#include "removal/part/part_field.h"
#include "support/crossed_slots.h"
#include "support/moves.h"
#include "support/shapes.h"
#include "support/temp_folder.h"

#include <cstdint>
#include <set>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using namespace mrsim::testing;

// `around`: mm of stock beside the slots.
PartField crossed_part(double around) {
  const StockShape stock = testing::box_stock(
      {-around, -around, 0}, {kCrossedSize[0] + around, kCrossedSize[1] + around, kCrossedSize[2]});
  Tool tool;
  tool.type = ToolType::endmill;
  tool.diameter = kCrossedMill;
  std::vector<Motion> motions;
  for (const auto& s : crossed_slots()) {
    Motion m;
    m.kind = MotionKind::line;
    m.tool = 0;
    m.line = static_cast<std::int32_t>(motions.size()) + 1;
    m.start = {s[0], s[1], s[4]}, m.end = {s[2], s[3], s[4]};
    motions.push_back(m);
  }
  return {StockSolid(stock), SweepTable(motions, std::span(&tool, 1))};
}

std::string encoded(const MeshSource& mesh, MeshFormat format, bool ascii) {
  std::string out;
  MeshFileOptions options;
  options.ascii = ascii;
  encode_mesh(mesh, format, options, [&](const void* data, std::size_t size) {
    out.append(static_cast<const char*>(data), size);
  });
  return out;
}

/// Counts how often the mesh began anew.
class CountingSpill final : public MeshSink {
 public:
  void take(const MeshBlock& block) override {
    ++blocks;
    spilled.take(block);
  }
  void restart() override {
    ++restarts;
    blocks = 0;
    spilled.restart();
  }
  TempFolder temporary;
  SpilledMesh spilled{temporary.folder().string()};
  int blocks = 0, restarts = 0;
};

TEST(Slabs, TilesThatAreMadeAgainGiveTheSameFilesOnAnyThreads) {
  const PartField part = crossed_part(0);
  for (const int threads : {1, 2}) {
    MeshPlan options;
    options.threads = threads;
    MeshReport report;
    const TriMesh whole = mesh_part(part, kCrossedVoxel, options, &report);
    EXPECT_EQ(report.passes, 2u);
    const MeshSummary summary = check_mesh(whole);
    EXPECT_TRUE(summary.closed && summary.oriented && summary.manifold) << summary.first_fault;
    CountingSpill slabs;
    mesh_part(part, kCrossedVoxel, options, slabs);
    EXPECT_EQ(slabs.restarts, 1);
    EXPECT_GT(slabs.blocks, 0);
    ASSERT_EQ(slabs.spilled.triangles(), whole.triangles.size());
    for (const char* name : {"a.stl", "a.ply", "a.obj", "a.off", "a.3mf"})
      for (const bool ascii : {false, true}) {
        const MeshFormat format = mesh_format_of(name);
        EXPECT_TRUE(encoded(slabs.spilled, format, ascii) ==
                    encoded(MemoryMesh(whole), format, ascii))
            << name << (ascii ? ", text" : "") << ", threads " << threads;
      }
  }
}

// A tile with cells that were split meets one without: both must see the creases that end on faces
// with four crossings.
TEST(Slabs, TilesThatWereSplitMeetTheOthers) {
  constexpr int kHalvings = 3;
  std::set<detail::CellPlace> split;  // about the border of two tiles
  for (std::int32_t x = 55; x < 67; ++x)
    for (std::int32_t y = 20; y < 80; ++y)
      for (std::int32_t z = 0; z < 20; ++z)
        split.insert({{x << kHalvings, y << kHalvings, z << kHalvings}, 1 << kHalvings});
  for (const double around : {20.0, 30.0}) {
    std::size_t cells[2];
    for (const bool is_split : {false, true}) {
      MeshReport report;
      MeshCollector mesh;
      detail::mesh_uniform(crossed_part(around), kCrossedVoxel, kHalvings, {}, mesh, report,
                           is_split ? split : std::set<detail::CellPlace>());
      const MeshSummary summary = check_mesh(mesh.mesh());
      EXPECT_TRUE(summary.closed && summary.oriented && summary.manifold) << summary.first_fault;
      cells[is_split] = report.cells;
    }
    EXPECT_GT(cells[1], cells[0] + 100);
  }
}

// Three slots narrower than a voxel: two pieces of surface in one cell have their vertices in the
// same corner of the part. Then they go between their crossings.
TEST(Slabs, PiecesInOneCellDoNotTouch) {
  const StockShape stock =
      box_stock({0, 0, 0}, {53.956341099692509, 40.307636285433546, 4.5330535713583231});
  Tool tool;
  tool.type = ToolType::bullmill;
  tool.diameter = 0.28352510700933636;
  tool.corner_radius = 0.2 * tool.diameter;
  std::vector<Motion> motions;
  for (const auto& [start, end] : {std::pair<Vec3, Vec3>{{34.37, 11.03, 2.26}, {36.41, 3.13, 1.82}},
                                   {{33.4, 10.39, 0.69}, {42.39, 4.73, 0.25}},
                                   {{29.84, 6.67, 2.38}, {35.67, 11.33, 2.38}}}) {
    Motion m = testing::line(start, end);
    m.tool = 0;
    m.line = static_cast<std::int32_t>(motions.size()) + 1;
    motions.push_back(m);
  }
  const PartField part(StockSolid(stock), SweepTable(motions, std::span(&tool, 1)));
  const MeshSummary summary = check_mesh(mesh_part(part, 0.59493110422044992));
  EXPECT_TRUE(summary.closed && summary.oriented && summary.manifold) << summary.first_fault;
}

}  // namespace
}  // namespace mrsim
