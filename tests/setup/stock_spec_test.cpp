#include "setup/stock_spec.h"

#include "support/error_code.h"

#include <gtest/gtest.h>

namespace mrsim {
namespace {

std::string complaint(const std::string& spec) {
  return testing::usage_fault("stock-spec", [&] { parse_stock_spec(spec); });
}

TEST(StockSpec, ReadsTheThreeForms) {
  const StockShape box = parse_stock_spec("box:0,-60,0,100,0,10").value();
  EXPECT_EQ(box.kind, StockShape::Kind::box);
  EXPECT_EQ(box.box, (Box3{{0, -60, 0}, {100, 0, 10}}));
  EXPECT_EQ(box.description, "box 100 x 60 x 10 mm");
  const StockShape bar = parse_stock_spec("cylinder:50,0,51").value();
  EXPECT_EQ(bar.kind, StockShape::Kind::cylinder);
  EXPECT_EQ(bar.outer_radius, 25);
  EXPECT_EQ(bar.box, (Box3{{-25, -25, 0}, {25, 25, 51}}));
  EXPECT_EQ(bar.description, "cylinder d 50 x 51 mm");
  const StockShape tube = parse_stock_spec("tube: 50, 20.5 ,-1,51").value();
  EXPECT_EQ(tube.kind, StockShape::Kind::tube);
  EXPECT_EQ(tube.inner_radius, 10.25);
  EXPECT_EQ(tube.description, "tube d 50 / 20.5 x 52 mm");
}

TEST(StockSpec, LengthsMayHaveTheirUnit) {
  const StockShape box = parse_stock_spec("box:0,0,-1/2in,4in,50.8mm,0").value();
  EXPECT_EQ(box.box, (Box3{{0, 0, -12.7}, {101.6, 50.8, 0}}));
}

TEST(StockSpec, AnotherWordBeforeNumbersIsNoFile) {
  for (const char* spec : {"block:0,0,-10,100,60,0", "BOX:0,0,0,1,1,1", "cyl:50,0,20"})
    EXPECT_NE(complaint(spec).find("is no form of stock"), std::string::npos) << spec;
  EXPECT_FALSE(parse_stock_spec("C:/parts/block.stl"));
  EXPECT_FALSE(parse_stock_spec("a:b,c.stl"));
}

TEST(StockSpec, LeavesFileNamesAlone) {
  EXPECT_FALSE(parse_stock_spec("block.stl"));
  EXPECT_FALSE(parse_stock_spec("box"));
  EXPECT_FALSE(parse_stock_spec("boxes:1"));
  EXPECT_FALSE(parse_stock_spec(""));
}

TEST(StockSpec, SaysWhatIsWrong) {
  const auto mentions = [](const std::string& spec, const std::string& what) {
    return complaint(spec).find(what) != std::string::npos;
  };
  EXPECT_TRUE(mentions("box:0,0,0,1,1", "6 numbers are needed, there are 5"));
  EXPECT_TRUE(mentions("box:", "\"\" is not a number"));
  EXPECT_TRUE(mentions("box:0,0,0,1,1,1,", "\"\" is not a number"));
  EXPECT_TRUE(mentions("box:0,0,0,1,one,1", "\"one\" is not a number"));
  EXPECT_TRUE(mentions("box:0,0,0,1,-1,1", "y0 = 0 must be less than y1 = -1"));
  EXPECT_TRUE(mentions("box:0,0,0,1,nan,1", "\"nan\""));
  EXPECT_TRUE(mentions("cylinder:0,0,1", "must be above 0"));
  EXPECT_TRUE(mentions("cylinder:5,1,1", "z0 = 1 must be less than z1 = 1"));
  EXPECT_TRUE(mentions("tube:20,20,0,1", "bore = 20 must be less than diameter = 20"));
  EXPECT_TRUE(mentions("tube:20,0,0,1", "cylinder:"));
  EXPECT_TRUE(mentions("cylinder:1e9,0,1", "beyond"));
  EXPECT_TRUE(mentions("tube:20,10,0", "write tube:diameter,bore,z0,z1"));
}

}  // namespace
}  // namespace mrsim
