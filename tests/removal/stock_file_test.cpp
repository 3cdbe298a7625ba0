#include "removal/part/stock_file.h"

#include "core/numbers/vec.h"
#include "removal/part/recipe_codec.h"
#include "removal/part/stock_grid.h"
#include "removal/vdb/grid_surface.h"
#include "removal/vdb/grids.h"
#include "removal/vdb/level_set.h"
#include "support/error_code.h"
#include "support/random.h"
#include "support/temp_folder.h"

#include <fstream>
#include <random>
#include <sstream>

#include <gtest/gtest.h>
#include <openvdb/io/Stream.h>
#include <openvdb/tools/LevelSetSphere.h>

namespace mrsim {
namespace {

StockRecipe recipe_of_a_slot() {
  StockRecipe recipe;
  recipe.voxel = 0.5;
  recipe.shape.box = {{0, 0, 0}, {20, 10, 5}};
  recipe.shape.description = "box";
  recipe.shape.history.files = {"a.MPF"};
  Tool tool;
  tool.id = "1";
  tool.diameter = 4;
  tool.shank = {{4, 4, 10}};
  recipe.shape.history.tools = {tool};
  Motion m;
  m.kind = MotionKind::line;
  m.start = {-5, 5, 3};
  m.end = {25, 5, 3};
  m.tool = 0;
  m.line = 7;
  recipe.shape.history.motions = {m};
  return recipe;
}

std::string saved(const StockRecipe& recipe) {
  const Stock stock = carve(recipe.shape, recipe.shape.history.motions, recipe.shape.history.tools,
                            {.voxel = recipe.voxel});
  std::string bytes;
  write_vdb(stock, recipe, [&](const void* data, std::size_t size) {
    bytes.append(static_cast<const char*>(data), size);
  });
  return bytes;
}

std::string code_of(std::string_view bytes) {
  return testing::error_code([&] { read_vdb(bytes, "a.vdb"); });
}

// What a program does that reads the file and writes it again, with or without a change.
std::string rewritten(const std::string& bytes, bool changed, bool with_metadata = true) {
  openvdb::initialize();
  std::istringstream in(bytes);
  openvdb::io::Stream archive(in);
  const openvdb::GridPtrVecPtr grids = archive.getGrids();
  if (changed) {
    const auto distance = openvdb::gridPtrCast<openvdb::FloatGrid>((*grids)[0]);
    auto leaf = distance->tree().beginLeaf();
    const openvdb::Index first = leaf->cbeginValueOn().pos();
    leaf->setValueOnly(first, leaf->getValue(first) + 0.125f);
  }
  std::ostringstream out;
  openvdb::io::Stream again(out);
  again.setCompression(openvdb::io::COMPRESS_NONE);
  again.write(*grids, with_metadata ? *archive.getMetadata() : openvdb::MetaMap());
  return out.str();
}

LevelSetSurface surface_in(const std::string& bytes) {
  const testing::TempFolder temporary;
  const std::string path = temporary.path("a.vdb");
  std::ofstream(path, std::ios::binary) << bytes;
  return read_level_set(path);
}

TEST(StockFile, KeepsTheRecipe) {
  const StockRecipe recipe = recipe_of_a_slot();
  const std::string bytes = saved(recipe);
  const VdbFile file = read_vdb(bytes, "a.vdb");
  ASSERT_TRUE(file.recipe);
  EXPECT_FALSE(file.rewritten);
  EXPECT_EQ(encode_recipe(*file.recipe), encode_recipe(recipe));
  EXPECT_EQ(bytes, saved(*file.recipe));  // and so the bytes, no random identifier among them
}

TEST(StockFile, IsStillOursWhenAnotherProgramHasWrittenItAgain) {
  const StockRecipe recipe = recipe_of_a_slot();
  const std::string bytes = rewritten(saved(recipe), false);
  const VdbFile file = read_vdb(bytes, "a.vdb");
  ASSERT_TRUE(file.recipe);
  EXPECT_TRUE(file.rewritten);
  EXPECT_EQ(encode_recipe(*file.recipe), encode_recipe(recipe));
  EXPECT_EQ(surface_in(bytes).hash, file.voxels);
}

TEST(StockFile, TellsThatItsVoxelsHaveBeenChanged) {
  const std::string bytes = rewritten(saved(recipe_of_a_slot()), true);
  EXPECT_NE(surface_in(bytes).hash, read_vdb(bytes, "a.vdb").voxels);
}

TEST(StockFile, OthersHaveNoRecipe) {
  const std::string bytes = rewritten(saved(recipe_of_a_slot()), false, false);
  EXPECT_FALSE(read_vdb(bytes, "a.vdb").recipe);
}

// A slot of 4 by 2 mm through 20 x 10 x 5 mm: 1000 - 160 mm^3 but for the edges.
TEST(LevelSet, SurfaceIsClosedAndHasTheVolumeOfThePart) {
  const LevelSetSurface found = surface_in(saved(recipe_of_a_slot()));
  EXPECT_EQ(found.grid, "distance");
  EXPECT_EQ(found.voxel, 0.5);
  double volume = 0;
  for (const auto& t : found.surface.triangles) {
    Vec3 corner[3];
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& v = found.surface.vertices[t[k]];
      corner[k] = {v[0], v[1], v[2]};
    }
    volume += dot(corner[0], cross(corner[1], corner[2])) / 6;
  }
  // 230 mm of edges lose or gain at most a quarter of a voxel's section each.
  EXPECT_NEAR(volume, 840, 230 * 0.5 * 0.5 / 4);
}

TEST(LevelSet, SheetsOfRoundingAreNoSurface) {
  openvdb::initialize();
  const auto grid = openvdb::FloatGrid::create(1);
  grid->setGridClass(openvdb::GRID_LEVEL_SET);
  auto voxels = grid->getAccessor();
  for (int x = 2; x < 10; ++x)
    for (int y = 2; y < 10; ++y)
      for (int z = 2; z < 10; ++z) {
        const bool inside = std::min({x, y, z}) > 2 && std::max({x, y, z}) < 9;
        voxels.setValue({x, y, z}, inside ? -0.5f : 0.5f);
      }
  const std::size_t triangles = surface_of(*grid).triangles.size();
  ASSERT_GT(triangles, 0u);
  voxels.setValue({0, 0, 0}, -1e-27f);  // a cube of 1e-27 mm about the origin
  const TriMesh found = surface_of(*grid);
  EXPECT_EQ(found.triangles.size(), triangles);
  for (const auto& t : found.triangles)
    for (const std::uint32_t v : t) EXPECT_GT(found.vertices[v][0], 1);
}

TEST(LevelSet, FileWithoutOneIsRefused) {
  openvdb::initialize();
  const auto code_of = [](const openvdb::GridPtrVec& grids) -> std::string {
    std::ostringstream out;
    openvdb::io::Stream(out).write(grids);
    try {
      surface_in(out.str());
    } catch (const Error& error) {
      return error.code();
    }
    return "";
  };
  EXPECT_EQ(code_of({openvdb::Int32Grid::create(1)}), "vdb-unreadable");
  EXPECT_EQ(code_of({openvdb::FloatGrid::create(1)}), "vdb-unreadable");  // nowhere zero
  EXPECT_EQ(code_of({openvdb::FloatGrid::create(1), openvdb::FloatGrid::create(2)}),
            "vdb-unreadable");
  const openvdb::FloatGrid::Ptr ball =
      openvdb::tools::createLevelSetSphere<openvdb::FloatGrid>(2, {}, 0.5f);
  ball->setName("ball");
  EXPECT_EQ(code_of({openvdb::FloatGrid::create(1), ball}), "");
  EXPECT_EQ(code_of({ball, ball->deepCopy()}), "vdb-unreadable");
  EXPECT_THROW(read_level_set("/no/such/file.vdb"), Error);
}

TEST(StockFile, OpensInOpenVdb) {
  openvdb::initialize();
  std::istringstream in(saved(recipe_of_a_slot()));
  openvdb::io::Stream archive(in);
  const auto grids = archive.getGrids();
  ASSERT_EQ(grids->size(), 3u);
  const auto distance = openvdb::gridPtrCast<openvdb::FloatGrid>((*grids)[0]);
  ASSERT_TRUE(distance);
  EXPECT_EQ(distance->getName(), "distance");
  EXPECT_GT(distance->activeVoxelCount(), 1000u);
  EXPECT_EQ(openvdb::gridPtrCast<openvdb::Int32Grid>((*grids)[1])->activeVoxelCount(),
            distance->activeVoxelCount());
}

TEST(StockFile, CutTellsWhenEachVoxelWasRemoved) {
  openvdb::initialize();
  StockRecipe recipe = recipe_of_a_slot();
  recipe.shape.history.motions.push_back(recipe.shape.history.motions[0]);
  recipe.shape.history.motions[1].start.z = recipe.shape.history.motions[1].end.z = 2;
  std::istringstream in(saved(recipe));
  openvdb::io::Stream archive(in);
  const auto cut = openvdb::gridPtrCast<openvdb::Int32Grid>((*archive.getGrids())[2]);
  ASSERT_TRUE(cut);
  EXPECT_EQ(cut->getName(), "cut");
  EXPECT_EQ(cut->activeVoxelCount(), 40u * 20u * 10u);  // the stock, by voxel centres
  const openvdb::Int32Grid::Accessor at(cut->tree());
  const auto value = [&](double x, double y, double z) {
    return at.getValue(openvdb::Coord::round(cut->worldToIndex({x, y, z})));
  };
  EXPECT_EQ(value(10, 5, 4), 0);
  EXPECT_EQ(value(10, 5, 2.5), 1);
  EXPECT_EQ(value(10, 5, 1), -1);
  EXPECT_EQ(value(10, 8.5, 4), -1);
  EXPECT_EQ(value(10, 5, 8), -2);
  EXPECT_EQ(value(10, -5, 4), -2);
  EXPECT_LT(cut->tree().leafCount(), 4u * 8u * 8u);
}

TEST(StockFile, RefusesWhatIsDamaged) {
  const std::string bytes = saved(recipe_of_a_slot());
  for (std::size_t size = 0; size < bytes.size(); size += 97)
    EXPECT_NE(code_of(bytes.substr(0, size)), "") << size;
  std::mt19937_64 random(testing::salted(1));
  for (int i = 0; i < 300; ++i) {
    std::string bad = bytes;
    bad[random() % bad.size()] ^= static_cast<char>(1 + random() % 255);
    EXPECT_NE(code_of(bad), "");
  }
  EXPECT_EQ(code_of(""), "vdb-unreadable");
  EXPECT_EQ(code_of(std::string(1000, 'x')), "vdb-unreadable");
}

TEST(RecipeCodec, ChecksEveryCount) {
  const std::string bytes = encode_recipe(recipe_of_a_slot());
  std::mt19937_64 random(testing::salted(2));
  for (int i = 0; i < 20000;
       ++i) {  // whatever the bytes: a recipe or an Error, never more memory than there are bytes
    std::string bad = bytes.substr(0, random() % 2 ? bytes.size() : random() % bytes.size());
    for (int k = 0; k < 4 && !bad.empty(); ++k)
      bad[random() % bad.size()] = static_cast<char>(random());
    try {
      decode_recipe(bad, "a.vdb");
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), "vdb-damaged");
    }
  }
}

}  // namespace
}  // namespace mrsim
