#include "mesh/solid/pieces.h"

#include "core/numbers/vec.h"
#include "mesh/solid/check.h"
#include "mesh/solid/mesh_audit.h"
#include "mesh/solid/mesh_source.h"
#include "support/mesh_asserts.h"
#include "support/shapes.h"

#include <optional>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using namespace mrsim::testing;

// A box with a cavity in which a ball lies, and a small box beside it.
TriMesh nested() {
  TriMesh m = box_mesh({20, 0, 0}, {21, 1, 1});
  m = joined(m, box_mesh({0, 0, 0}, {10, 10, 10}));
  m = joined(m, flipped(box_mesh({1, 1, 1}, {9, 9, 9})));
  m = joined(m, sphere_mesh(40, 2, {5, 5, 5}));
  m.owners.resize(m.triangles.size());
  for (std::size_t f = 0; f < m.owners.size(); ++f) m.owners[f] = int(f);
  return m;
}

TEST(Pieces, AreFoundWithVolumeAndPlace) {
  const std::vector<Piece> pieces = find_pieces(nested());
  ASSERT_EQ(pieces.size(), 3u);
  EXPECT_NEAR(pieces[0].volume, 1000 - 512, 1e-9);
  EXPECT_EQ(pieces[0].components.size(), 2u);
  EXPECT_EQ(pieces[0].triangles, 24u);
  EXPECT_NEAR(distance(pieces[0].center, {5, 5, 5}), 0, 1e-9);
  EXPECT_NEAR(pieces[1].volume, 33.5, 0.6);
  EXPECT_NEAR(pieces[2].volume, 1, 1e-9);
  EXPECT_NEAR(distance(pieces[2].center, {20.5, 0.5, 0.5}), 0, 1e-9);
  EXPECT_EQ(describe_piece(pieces[2]),
            "detached piece of 1 mm3 at (20.5, 0.5, 0.5) mm, 1 x 1 x 1 mm");
}

TEST(Pieces, CanBeTakenOut) {
  const TriMesh m = nested();
  const std::vector<Piece> pieces = find_pieces(m);
  MeshAudit audit;
  audit.take(whole_block(m));
  const TriMesh largest = collected(PieceOfMesh(audit, MemoryMesh(m), pieces[0]));
  EXPECT_EQ(largest.triangles.size(), 24u);
  EXPECT_EQ(largest.vertices.size(), 16u);
  EXPECT_EQ(largest.owners.front(), 12);
  EXPECT_NEAR(check_mesh(largest).volume, 488, 1e-9);
}

TEST(Pieces, OneSolidIsOnePiece) {
  EXPECT_EQ(find_pieces(tube_mesh(64, 10, 5, 0, 7)).size(), 1u);
  EXPECT_TRUE(find_pieces({}).empty());
}

TEST(Pieces, BodiesThatContradictThoseAroundThemAreFound) {
  EXPECT_FALSE(find_misplaced_body(nested()));
  const TriMesh solid = box_mesh({0, 0, 0}, {10, 10, 10}), inner = box_mesh({1, 1, 1}, {2, 2, 2});
  std::optional<MisplacedBody> found = find_misplaced_body(joined(solid, inner));
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->within);
  EXPECT_LT(distance(found->place, {1.5, 1.5, 1.5}), 1);
  EXPECT_FALSE(find_misplaced_body(joined(solid, flipped(inner))));
  found = find_misplaced_body(joined(solid, flipped(box_mesh({20, 0, 0}, {21, 1, 1}))));
  ASSERT_TRUE(found);
  EXPECT_FALSE(found->within);
  // A cavity within a cavity.
  found = find_misplaced_body(joined(inner, solid));  // in any order
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->within);
  EXPECT_TRUE(find_misplaced_body(joined(nested(), flipped(box_mesh({1.5, 1.5, 1.5}, {2, 2, 2})))));
}

// Skins of an onion: asking each one about all others takes 10 s here.
TEST(Pieces, OfManyNestedBodiesAreFoundInTime) {
  constexpr int kSkins = 5000;
  TriMesh m;
  for (int i = 0; i < kSkins; ++i) {
    const double s = 1 + 0.01 * i;
    TriMesh skin = box_mesh({-s, -s, -s}, {s, s, s});
    if (i % 2 == 0) skin = flipped(skin);
    const auto first = std::uint32_t(m.vertices.size());
    m.vertices.insert(m.vertices.end(), skin.vertices.begin(), skin.vertices.end());
    for (const auto& t : skin.triangles)
      m.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  EXPECT_FALSE(find_misplaced_body(m));
  const std::vector<Piece> pieces = find_pieces(m);
  ASSERT_EQ(pieces.size(), std::size_t(kSkins / 2));
  for (const Piece& piece : pieces) {
    ASSERT_EQ(piece.components.size(), 2u);
    ASSERT_EQ(piece.components[0], piece.components[1] + 1);
  }
}

// Rings: the box of each one holds all smaller ones, none of which lies in it.
TEST(Pieces, ThatOnlyBoxesHoldAreNotNested) {
  TriMesh m;
  for (int i = 0; i < 40; ++i) {
    const double s = 100 - i;
    m = joined(m, tube_mesh(16, 2 * s, 2 * s - 1, -s, s));
  }
  EXPECT_FALSE(find_misplaced_body(m));
  EXPECT_EQ(find_pieces(m).size(), 40u);
}

}  // namespace
}  // namespace mrsim
