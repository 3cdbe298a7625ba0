#include "mesh/format/stl.h"

#include "mesh/solid/check.h"
#include "support/mesh_asserts.h"
#include "support/shapes.h"
#include "support/temp_folder.h"

#include <algorithm>
#include <cstdio>
#include <limits>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using testing::box_mesh;
using testing::bytes_of;
using testing::error_code;

std::string binary(const TriMesh& m) {
  return bytes_of([&](const ByteSink& out) { write_stl(m, out); });
}
std::string ascii(const TriMesh& m) {
  return bytes_of([&](const ByteSink& out) { write_stl_ascii(m, out); });
}
std::string code(const std::string& bytes) {
  return error_code([&] { parse_stl(bytes, "part.stl"); });
}
void patch(std::string& bytes, std::size_t at, const std::string& with) {
  std::copy(with.begin(), with.end(), bytes.begin() + std::ptrdiff_t(at));
}
const TriMesh kBox = box_mesh({0, -60, 0}, {100, 0, 10.1});

TEST(Stl, ReadsBackWhatItWrites) {
  for (const std::string& bytes : {binary(kBox), ascii(kBox)}) {
    const TriMesh back = parse_stl(bytes, "part.stl");
    EXPECT_EQ(back.vertices.size(), 8u);
    EXPECT_EQ(testing::corners_of(back), testing::corners_of(kBox));
    testing::expect_closed_manifold(back);
  }
}

TEST(Stl, StreamGivesTheSameBytesOnAnyNumberOfThreads) {
  const testing::TempFolder temporary;
  const std::string path = temporary.path("stream.stl");
  for (const int threads : {1, 2}) {
    DraftFile draft(path);
    StlStream stream(draft, threads);
    stream.take(whole_block(box_mesh({0, 0, 0}, {1, 1, 1})));
    stream.restart();
    MeshBlock first = whole_block(kBox), second = first;
    first.triangles = first.triangles.first(5);
    second.triangles = second.triangles.subspan(5);
    stream.take(first);
    stream.take(second);
    stream.finish();
    draft.publish();
    EXPECT_EQ(read_file(path), binary(kBox));
  }
}

TEST(Stl, HasTheSizeOfItsTriangles) { EXPECT_EQ(binary(kBox).size(), 84u + 12 * 50); }

TEST(Stl, TakesABinaryFileThatBeginsWithSolid) {
  std::string bytes = binary(kBox);
  patch(bytes, 0, "solid part");
  EXPECT_EQ(parse_stl(bytes, "part.stl").triangles.size(), 12u);
}

TEST(Stl, TakesAnAsciiFileWithOddSpacingAndCase) {
  const std::string text =
      "\n  SOLID a name with facet in it\r\nfacet normal nan nan nan outer loop vertex 0 0 0\r\n"
      "vertex\t1e0 +0 -0.0 vertex 0 1 1.e-300 endloop endfacet ENDSOLID\n"
      "solid\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
      "endfacet\nendsolid";
  const TriMesh m = parse_stl(text, "part.stl");
  EXPECT_EQ(m.triangles.size(), 2u);
  EXPECT_EQ(m.vertices.size(), 3u);
}

TEST(Stl, RefusesAHeaderThatClaimsMoreThanThereIs) {
  std::string bytes = binary(kBox);
  patch(bytes, 80, "\xff\xff\xff\xff");
  EXPECT_EQ(code(bytes), "stl-truncated");
  patch(bytes, 80, std::string("\x0d\0\0\0", 4));
  EXPECT_EQ(code(bytes), "stl-truncated");
}

TEST(Stl, RefusesAHeaderThatClaimsLessThanThereIs) {
  std::string bytes = binary(kBox);
  patch(bytes, 80, std::string("\x05\0\0\0", 4));
  EXPECT_EQ(code(bytes), "stl-size");
}

TEST(Stl, RefusesEveryTruncation) {
  for (const std::string& bytes : {binary(kBox), ascii(kBox)})
    for (std::size_t n = 0; n + 20 < bytes.size(); n += 7) {
      const std::string c = code(bytes.substr(0, n));
      EXPECT_TRUE(c == "stl-truncated" || c == "stl-empty" || c == "stl-syntax") << n << " " << c;
    }
}

TEST(Stl, TellsAsciiFromBinaryWhenConfused) {
  std::string cut = binary(kBox).substr(0, 300);
  patch(cut, 0, "solid");
  EXPECT_EQ(code(cut), "stl-truncated");
  EXPECT_EQ(code("solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 zero"), "stl-syntax");
  EXPECT_EQ(code("G0 X0 Y0\nM30\n"), "stl-syntax");
  EXPECT_EQ(code(std::string(200, 'x')), "stl-truncated");
}

TEST(Stl, RefusesNumbersThatAreNone) {
  TriMesh bad = kBox;
  bad.vertices[3][1] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(code(binary(bad)), "stl-nan");
  EXPECT_EQ(code(ascii(bad)), "stl-nan");
  bad.vertices[3][1] = std::numeric_limits<float>::infinity();
  EXPECT_EQ(code(binary(bad)), "stl-nan");
}

TEST(Stl, RefusesEmptyFiles) {
  EXPECT_EQ(code(""), "stl-empty");
  EXPECT_EQ(code("solid\nendsolid\n"), "stl-empty");
  EXPECT_EQ(code(std::string(84, '\0')), "stl-empty");
}

TEST(Stl, LeavesOutTrianglesOfTwoCorners) {
  TriMesh m = kBox;
  m.triangles.push_back({0, 1, 1});
  EXPECT_EQ(parse_stl(binary(m), "part.stl").triangles.size(), 12u);
}

TEST(Stl, MessagesNameTheFileAndTheRemedy) {
  try {
    parse_stl(binary(kBox).substr(0, 400), "block.stl");
    FAIL();
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("block.stl"), std::string::npos);
    EXPECT_NE(std::string(e.what()).find("12 triangles"), std::string::npos);
  }
}

}  // namespace
}  // namespace mrsim
