// The stock that comments of CAM programs tell of.
#include "interp/support.h"

namespace mrsim {
namespace {

using namespace mrsim::testing;

constexpr const char* kOneCut = "T1 M6 (6MM ENDMILL)\nG0 X0 Y0 Z5\nG1 Z-1 F100\nX1\nG0 Z5\nM30\n";

// "0 0 -12 to 100 90 0"; "-": none is told.
std::string stock(const std::string& head, InterpOptions options = {}) {
  options.dialect = Dialect::fanuc;
  options.machine = MachineKind::mill;
  const Program p = read_text(head + kOneCut, options);
  if (!p.workpiece) return "-";
  const Vec3 &lo = p.workpiece->box.lo, &hi = p.workpiece->box.hi;
  return fmt::format("{:.6g} {:.6g} {:.6g} to {:.6g} {:.6g} {:.6g}", lo.x, lo.y, lo.z, hi.x, hi.y,
                     hi.z);
}

TEST(StockComment, CarbideCreatesStockIsRead) {
  EXPECT_EQ(stock("(stockMin:-50.00mm, -45.00mm, 0.00mm)\n(stockMax:50.00mm, 45.00mm, 12.70mm)\n"
                  "(STOCK/BLOCK,100.00, 90.00, 12.70,50.00, 45.00, 0.00)\nG21\n"),
            "-50 -45 0 to 50 45 12.7");
  EXPECT_EQ(stock("(STOCK/BLOCK, 100.00, 90.00, 12.00,0.00, 0.00, 12.00)\nG21\n"),
            "0 0 -12 to 100 90 0");
  EXPECT_EQ(stock("(stockMin:0.00mm, 0.00mm, -12.70mm)\n(stockMax:50.00mm, 45.00mm, 0.00mm)\n"
                  "G20\n"),
            "0 0 -12.7 to 50 45 0");
}

TEST(StockComment, VectricsStockIsRead) {
  const std::string size = "( Material Size)\n( X= 300.000, Y= 200.000, Z= 18.000)\n";
  const std::string z = "( Z Origin for Material  = Material Surface)\n";
  EXPECT_EQ(stock(size + z + "( XY Origin for Material = Bottom Left Corner)\n"),
            "0 0 -18 to 300 200 0");
  EXPECT_EQ(stock(size + z + "( XY Origin for Material = Top Right Corner)\n"),
            "-300 -200 -18 to 0 0 0");
  EXPECT_EQ(stock("( Material Size: X= 12.0, Y= 8.0, Z= 0.75)\n"
                  "( Z Origin for Material  = Machine Bed)\n"
                  "( XY Origin for Material = Center)\nG20\n"),
            "-152.4 -101.6 0 to 152.4 101.6 19.05");
  EXPECT_EQ(stock("(Material Size: X= 300, Y= 200, Z= 18)\n(Z Origin: Table Surface)\n"
                  "(XY Origin: Bottom Right Corner)\n"),
            "-300 0 0 to 0 200 18");
}

// Where something is missing nothing is guessed.
TEST(StockComment, AnIncompleteStockIsNotGuessed) {
  const std::string size = "( Material Size)\n( X= 300.000, Y= 200.000, Z= 18.000)\n";
  const std::string z = "( Z Origin for Material = Material Surface)\n";
  const std::string xy = "( XY Origin for Material = Bottom Left Corner)\n";
  EXPECT_EQ(stock(size), "-");
  EXPECT_EQ(stock(size + z), "-");
  EXPECT_EQ(stock(size + xy), "-");
  EXPECT_EQ(stock(z + xy), "-");
  EXPECT_EQ(stock(size + z + xy + "(      XY Origin Position  = X:0.000, Y:0.000)\n"),
            "0 0 -18 to 300 200 0");
  EXPECT_EQ(stock(size + z + xy + "(      XY Origin Position  = X:10.000, Y:0.000)\n"), "-");
  EXPECT_EQ(stock("(STOCK/BLOCK, 100, 90, 12)\n"), "-");
  EXPECT_EQ(stock("(stockMin:0.00mm, 0.00mm, -12.70mm)\n"), "-");
  EXPECT_EQ(stock("(stockMin:0mm, 0mm, 0mm)\n(stockMax:0mm, 0mm, 0mm)\n"), "-");
  EXPECT_EQ(stock("( X= 300.000, Y= 200.000, Z= 18.000)\n" + z + xy), "-");
}

// It stands about the zero of the first cut.
TEST(StockComment, LiesAtTheWorkOffset) {
  InterpOptions options;
  options.table.work.push_back({"G54", {10, 20, 30}});
  const std::string head = "(STOCK/BLOCK,100,90,12,0,0,12)\nG21 G54\n";
  EXPECT_EQ(stock(head, options), "10 20 18 to 110 110 30");
}

}  // namespace
}  // namespace mrsim
