#include "mesh/draw/palette.h"

#include "support/shapes.h"

#include <set>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

TriMesh part() {
  TriMesh m = testing::box_mesh({0, 0, 0}, {1, 1, 1});
  m.owners = {-1, -1, 4, 4, 7, 7, 9, 9, 12, 12, -1, 4};
  m.origin.files = {"data/PRIMER_2F.MPF", "sub.spf"};
  m.origin.tools = {"4", ""};
  m.origin.origins = {{4, 0, 13, 0}, {7, 0, 14, 0}, {9, 1, 2, 1}};  // 12 is not known
  return m;
}

TEST(Palette, LinesHaveAColourEach) {
  const FacePalette p = make_palette(part(), ColorBy::line);
  ASSERT_EQ(p.entries.size(), 5u);
  EXPECT_EQ(p.entries[0].label, "stock");
  EXPECT_EQ(p.entries[0].color, kStockColor);
  EXPECT_EQ(p.entries[1].label, "PRIMER_2F.MPF:13");
  EXPECT_EQ(p.entries[2].label, "PRIMER_2F.MPF:14");
  EXPECT_EQ(p.entries[3].label, "sub.spf:2");
  EXPECT_EQ(p.entries[4].label, "motion 12");
  std::set<Rgb> colors;
  for (const PaletteEntry& e : p.entries) colors.insert(e.color);
  EXPECT_EQ(colors.size(), 5u);
  EXPECT_EQ(p.index, (std::vector<std::uint32_t>{0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 0, 1}));
}

TEST(Palette, ToolsJoinTheirLines) {
  const FacePalette p = make_palette(part(), ColorBy::tool);
  ASSERT_EQ(p.entries.size(), 4u);
  EXPECT_EQ(p.entries[1].label, "tool 4");
  EXPECT_EQ(p.entries[1].owner, 4);
  EXPECT_EQ(p.entries[2].label, "tool");
  EXPECT_EQ(p.index[4], 1u);
}

TEST(Palette, NothingToTellIsNoPalette) {
  EXPECT_TRUE(make_palette(part(), ColorBy::none).index.empty());
  TriMesh m = part();
  m.owners.clear();
  EXPECT_TRUE(make_palette(m, ColorBy::tool).entries.empty());
}

TEST(Palette, LabelsOwners) {
  const TriMesh m = part();
  EXPECT_EQ(owner_label(m.origin, 4), "PRIMER_2F.MPF:13, tool 4");
  EXPECT_EQ(owner_label(m.origin, 9), "sub.spf:2");
  EXPECT_EQ(owner_label(m.origin, -1), "stock");
}

}  // namespace
}  // namespace mrsim
