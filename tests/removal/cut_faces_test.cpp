// Faces between voxels that go at different moments: moments, places and normals of single cuts.
#include "removal/history/cut_faces.h"

#include "core/numbers/vec.h"
#include "removal/history/removed_volumes.h"
#include "support/moves.h"
#include "support/shapes.h"
#include "support/tools.h"

#include <cmath>
#include <map>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using namespace testing;

Vec3 unpacked(const FaceSurface& s) {
  double x = (s.u - 127) / 127.0, y = (s.v - 127) / 127.0;
  const double z = 1 - std::abs(x) - std::abs(y);
  if (z < 0) {
    const double folded = (1 - std::abs(y)) * (x < 0 ? -1 : 1);
    y = (1 - std::abs(x)) * (y < 0 ? -1 : 1);
    x = folded;
  }
  return normalized(Vec3{x, y, z});
}

// A face with what the order of the list leaves to be known.
struct Seen {
  Vec3 place, normal;
  std::int32_t birth = 0, death = 0;
};

struct FacesScene {
  PartField field;
  CutVolume volume;
  CutFaces faces;

  FacesScene(const StockShape& stock, const std::vector<Motion>& motions, const Tool& tool,
             double voxel, int inherited = 0, int threads = 2)
      : field(StockSolid(stock), SweepTable(motions, std::span(&tool, 1))),
        volume(make_cut_volume(field, history_lattice(field, voxel), motions.size(), threads)),
        faces(make_cut_faces(field, volume, inherited, threads)) {}

  std::vector<Seen> seen(int inherited = 0) const {
    std::vector<Seen> out;
    const auto [nx, ny, nz] = volume.size;
    for (int x = 0; x < nx; ++x)
      for (int y = 0; y < ny; ++y)
        for (int z = 0; z < nz; ++z)
          for (int axis = 0; axis < 3; ++axis) {
            const int a = x + (axis == 0), b = y + (axis == 1), c = z + (axis == 2);
            if (a == nx || b == ny || c == nz) continue;
            const auto moment = [&](int i, int j, int k) {
              return moment_of(volume.cut[volume.index(i, j, k)], inherited);
            };
            const std::int32_t low = moment(x, y, z), high = moment(a, b, c);
            if (low == high) continue;
            const FaceSurface& s = faces.faces.at(out.size());
            out.push_back({lerp(volume.center(x, y, z), volume.center(a, b, c), s.share / 255.0),
                           unpacked(s), std::min(low, high), std::max(low, high)});
          }
    return out;
  }
};

const StockShape kPlate = box_stock({0, 0, -10}, {40, 30, 0});

TEST(CutFaces, EachStepBetweenMomentsHasOneFace) {
  const FacesScene scene(kPlate, {line({-5, 15, -3}, {20, 15, -3})}, endmill(8), 0.5);
  EXPECT_EQ(scene.seen().size(), scene.faces.faces.size());
  EXPECT_TRUE(scene.faces.late.empty());
}

TEST(CutFaces, PlacesAndNormalsAreThoseOfTheMotion) {
  const FacesScene scene(kPlate, {line({-5, 15, -3}, {20, 15, -3})}, endmill(8), 0.5);
  std::map<std::int32_t, int> floors;
  for (const Seen& f : scene.seen()) {
    if (f.birth == 1) {
      // The floor at z = -3, or the wall: 4 mm from the path.
      const double across =
          f.place.x < 20 ? std::abs(f.place.y - 15) : std::hypot(f.place.x - 20, f.place.y - 15);
      const bool is_floor = std::abs(f.place.z + 3) < 0.01 && f.normal.z > 0.99;
      EXPECT_TRUE(is_floor || (std::abs(across - 4) < 0.01 && std::abs(f.normal.z) < 0.02))
          << f.place.x << " " << f.place.y << " " << f.place.z;
      floors[f.death] += is_floor;
    } else {
      // A side of the block.
      const Vec3 from = f.place - Vec3{20, 15, -5};
      EXPECT_TRUE(std::abs(std::abs(from.x) - 20) < 0.01 ||
                  std::abs(std::abs(from.y) - 15) < 0.01 || std::abs(std::abs(from.z) - 5) < 0.01);
      EXPECT_GT(dot(f.normal, from), 0);
    }
  }
  EXPECT_NEAR(floors[kNeverGoes] * 0.25, 20 * 8 + 3.14159 * 16 / 2, 4);
}

TEST(CutFaces, ALaterSkimMovesTheFacesThatStay) {
  // The second pass takes a fifth of a voxel: no voxel goes by it, and its floor is what stays.
  const std::vector<Motion> moves{line({-5, 15, -3}, {45, 15, -3}),
                                  line({45, 15, -3.1}, {-5, 15, -3.1})};
  const FacesScene scene(kPlate, moves, endmill(8), 0.5);
  const std::vector<Seen> seen = scene.seen();
  ASSERT_GT(scene.faces.late.size(), 1000u);
  for (const LateSurface& late : scene.faces.late) {
    const Seen& face = seen[late.face];
    EXPECT_EQ(late.moment, 2);
    EXPECT_EQ(face.birth, 1);
    EXPECT_NEAR(face.place.z, -3, 0.01);
    EXPECT_NEAR((late.surface.share - scene.faces.faces[late.face].share) / 255.0 * 0.5, -0.1,
                0.01);
  }
}

TEST(CutFaces, InheritedCutsAreOverWhenThePlayBegins) {
  const std::vector<Motion> moves{line({-5, 8, -3}, {45, 8, -3}), line({-5, 22, -3}, {45, 22, -3})};
  const FacesScene scene(kPlate, moves, endmill(6), 0.5, 1);
  int old_floor = 0, new_floor = 0;
  for (const Seen& f : scene.seen(1)) {
    EXPECT_LE(f.birth, 1);
    if (std::abs(f.place.z + 3) > 0.01 || f.normal.z < 0.9) continue;
    (f.place.y < 15 ? old_floor : new_floor) += 1;
    EXPECT_EQ(f.birth, f.place.y < 15 ? 0 : 1);
  }
  EXPECT_GT(old_floor, 500);
  EXPECT_GT(new_floor, 500);
}

TEST(CutFaces, FacesAreTheSameOnAnyNumberOfThreads) {
  const std::vector<Motion> moves{line({-5, 8, -3}, {45, 20, -4}),
                                  line({45, 22, -3}, {-5, 12, -3.2})};
  const FacesScene one(kPlate, moves, ballmill(6), 0.5, 0, 1),
      four(kPlate, moves, ballmill(6), 0.5, 0, 4);
  ASSERT_EQ(one.faces.faces.size(), four.faces.faces.size());
  for (std::size_t i = 0; i < one.faces.faces.size(); ++i) {
    EXPECT_EQ(one.faces.faces[i].share, four.faces.faces[i].share);
    EXPECT_EQ(one.faces.faces[i].u, four.faces.faces[i].u);
  }
  EXPECT_EQ(one.faces.late.size(), four.faces.late.size());
}

}  // namespace
}  // namespace mrsim
