// A thousand random programs: lines, plunges, arcs and helices of flat, ball and bull-nose mills in
// a block. Every mesh is a closed 2-manifold, free of self-intersections by CGAL, and its vertices
// lie on the exact part.
#include "core/numbers/trig.h"
#include "core/numbers/units.h"
#include "core/numbers/vec.h"
#include "mesh/mesh_part.h"
#include "removal/part/part_field.h"
#include "support/cgal_mesh.h"
#include "support/random.h"
#include "support/shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace mrsim {
namespace {

using namespace mrsim::testing;

constexpr unsigned kPrograms = 360, kBatch = 30;

class Generator {
 public:
  explicit Generator(std::uint64_t seed) : random_(testing::salted(seed)) {}

  PartField part() {
    const StockShape stock = box_stock({0, 0, 0}, {whole(15, 30), whole(15, 30), whole(6, 12)});
    const double top = stock.box.hi.z;
    Tool tool;
    constexpr std::array kTypes{ToolType::endmill, ToolType::ballmill, ToolType::bullmill};
    tool.type = kTypes[pick(3)];
    tool.diameter = whole(2, 8);
    tool.corner_radius = tool.type == ToolType::bullmill ? tool.diameter / 4 : 0;
    const std::vector<Motion> motions = moves(top);
    return {StockSolid(stock), SweepTable(motions, std::span(&tool, 1))};
  }

 private:
  std::size_t pick(std::size_t count) { return random_() % count; }
  double whole(int low, int high) {
    return low + static_cast<double>(pick(static_cast<std::size_t>(high - low + 1)));
  }

  std::vector<Motion> moves(double top) {
    std::vector<Motion> out;
    Vec3 at{whole(-3, 30), whole(-3, 30), top + 2};
    const int count = static_cast<int>(whole(3, 25));
    for (int k = 0; k < count; ++k) {
      Motion m = pick(10) < 6 || at.z >= top ? line(at, top) : arc(at);
      m.tool = 0;
      m.line = k + 1;
      if (m.end == at) continue;
      out.push_back(m);
      at = m.end;
      if (at.z > top || at.z < 0.5) at.z = top - 1;
    }
    return out;
  }

  Motion line(const Vec3& from, double top) {
    Motion m;
    m.kind = MotionKind::line;
    m.start = from;
    const std::size_t kind = pick(10);
    m.end = kind == 2 ? Vec3{from.x, from.y, whole(1, static_cast<int>(top))}
                      : Vec3{whole(-3, 33), whole(-3, 33), from.z};
    if (kind < 2) m.end.z = whole(1, static_cast<int>(top) - 1) + 0.5 * whole(0, 1);
    return m;
  }

  Motion arc(const Vec3& from) {
    Motion m;
    m.kind = MotionKind::arc;
    m.start = from;
    m.radius = whole(2, 8);
    const double begin = whole(0, 7) * kPi / 4;
    m.center = from - m.radius * Vec3{std::cos(begin), std::sin(begin), 0};
    m.sweep = (pick(2) == 0 ? 1 : -1) * whole(1, 8) * kPi / 4;
    m.rise = pick(5) == 0 ? -whole(0, 2) : 0;
    const double end = begin + m.sweep;
    m.end = m.center + Vec3{m.radius * std::cos(end), m.radius * std::sin(end), m.rise};
    return m;
  }

  std::mt19937_64 random_;
};

void expect_sound(const PartField& part, double voxel, double tolerance, std::uint64_t seed) {
  MeshPlan options;
  options.tolerance = tolerance;
  options.threads = 1;
  TriMesh mesh;
  try {
    mesh = mesh_part(part, voxel, options);
  } catch (const Error& error) {
    ASSERT_EQ(error.code(), "part-empty") << seed;
    return;
  }
  testing::expect_sound(part, mesh, seed);
}

class RandomPrograms : public ::testing::TestWithParam<unsigned> {};

TEST_P(RandomPrograms, AreSound) {
  for (unsigned seed = GetParam(); seed < GetParam() + kBatch; ++seed) {
    const PartField part = Generator(seed).part();
    const bool with_tolerance = seed % 5 == 0;
    expect_sound(part, with_tolerance ? 0.5 : 0.4, with_tolerance ? 0.05 : 0, seed);
  }
}

INSTANTIATE_TEST_SUITE_P(Slow, RandomPrograms, ::testing::Range(0u, kPrograms, kBatch));

}  // namespace
}  // namespace mrsim
