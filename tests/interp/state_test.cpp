// What is in force at the start, and what a block leaves behind.
#include "interp/support.h"

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr Dialect kAll[] = {Dialect::sinumerik, Dialect::iso, Dialect::codesys, Dialect::fanuc};

std::string xyz(const Vec3& p) {
  return fmt::format("{},{},{}", number_text(p.x), number_text(p.y), number_text(p.z));
}

// The ends of all motions, "a" before arcs.
std::string ends(const Program& p) {
  std::string out;
  for (const Motion& m : p.motions)
    out +=
        (out.empty() ? "" : " ") + std::string(m.kind == MotionKind::arc ? "a" : "") + xyz(m.end);
  return out;
}

TEST(Start, IncrementsAndArcsCountFromIt) {
  for (const Dialect d : kAll) {
    InterpOptions options = at_origin(d);
    options.start = Vec3{10, 20, 30};
    EXPECT_EQ(ends(read_text("G91 G1 X1 F5\n", options)), "11,20,30");
    const Program arc = read_text("G2 X20 Y20 I5 F5\n", options);
    ASSERT_EQ(codes(arc), "") << listing(arc);
    expect_near(arc.motions[0].center, {15, 20, 30});
  }
}

}  // namespace
}  // namespace mrsim
