// Every format written by mrsim and read back by mrsim; formats_foreign_test.cpp reads them with
// other people's readers.
#include "core/process/memory_limit.h"
#include "mesh/format/mesh_io.h"
#include "mesh/format/obj.h"
#include "mesh/format/off.h"
#include "mesh/format/ply.h"
#include "mesh/solid/weld.h"
#include "support/mesh_asserts.h"
#include "support/mesh_files.h"
#include "support/shapes.h"
#include "support/temp_folder.h"

#include <algorithm>
#include <filesystem>
#include <limits>

#include <gtest/gtest.h>
#include <unistd.h>

namespace mrsim {
namespace {

using namespace mrsim::testing;

constexpr MeshFormat kFormats[] = {MeshFormat::obj, MeshFormat::off, MeshFormat::ply,
                                   MeshFormat::threemf};

TEST(MeshFormats, ReadBackWhatTheyWrite) {
  const TriMesh m = format_part();
  for (const MeshFormat format : kFormats)
    for (const ColorBy color : {ColorBy::none, ColorBy::line, ColorBy::tool}) {
      const TriMesh back = parse_mesh(bytes_as(format, m, color), format, "part");
      EXPECT_EQ(back.vertices, m.vertices) << int(format);
      EXPECT_EQ(back.triangles, m.triangles) << int(format);
      if (format == MeshFormat::off) continue;  // which has no owners
      EXPECT_EQ(back.owners, m.owners) << int(format);
      EXPECT_EQ(back.origin, m.origin) << int(format);
    }
}

TEST(MeshFormats, KeepVertexColours) {
  TriMesh m = format_part();
  for (std::size_t v = 0; v < m.vertices.size(); ++v)
    m.colors.push_back({std::uint8_t(v), std::uint8_t(2 * v), 200});
  for (const MeshFormat format : {MeshFormat::obj, MeshFormat::ply})
    EXPECT_EQ(parse_mesh(bytes_as(format, m), format, "part").colors, m.colors) << int(format);
}

TEST(Ply, KeepsTheLegendOfItsColours) {
  TriMesh m = format_part();
  m.legend = {{{20, 76, 168}, "+0.06 mm and more"}, {{1, 2, 3}, "two\nlines"}};
  EXPECT_TRUE(parse_mesh(bytes_as(MeshFormat::ply, m), MeshFormat::ply, "part").legend.empty());
  m.colors.assign(m.vertices.size(), {20, 76, 168});
  const TriMesh back = parse_mesh(bytes_as(MeshFormat::ply, m), MeshFormat::ply, "part");
  ASSERT_EQ(back.legend.size(), 2u);
  EXPECT_EQ(back.legend[0], m.legend[0]);
  EXPECT_EQ(back.legend[1].text, "two lines");
  EXPECT_EQ(back.origin, m.origin);
}

TEST(MeshFormats, WriteTheSameBytesEveryTime) {
  const TriMesh m = format_part();
  for (const MeshFormat format : kFormats)
    EXPECT_EQ(bytes_as(format, m, ColorBy::line), bytes_as(format, m, ColorBy::line));
}

TEST(MeshFormats, SurviveEveryTruncation) {
  for (const MeshFormat format :
       {MeshFormat::obj, MeshFormat::off, MeshFormat::ply, MeshFormat::threemf, MeshFormat::glb}) {
    const std::string bytes = bytes_as(format, format_part(), ColorBy::tool);
    for (std::size_t n = 0; n + 1 < bytes.size(); n += 1 + bytes.size() / 300) {
      const std::string c = parse_code(bytes.substr(0, n), format);
      // A text file may end behind a whole line: then it is a smaller mesh, which is open.
      EXPECT_TRUE(!c.empty() || format == MeshFormat::obj) << int(format) << " " << n;
    }
  }
}

TEST(MeshFormats, SurviveEveryFlippedByte) {
  for (const MeshFormat format :
       {MeshFormat::obj, MeshFormat::off, MeshFormat::ply, MeshFormat::threemf, MeshFormat::glb}) {
    const std::string bytes = bytes_as(format, format_part(), ColorBy::tool);
    for (std::size_t n = 0; n < bytes.size(); n += 1 + bytes.size() / 500) {
      std::string bad = bytes;
      bad[n] = char(bad[n] ^ 0x41);
      try {
        const TriMesh m = parse_mesh(bad, format, "part");
        for (const auto& t : m.triangles)
          for (const std::uint32_t v : t) ASSERT_LT(v, m.vertices.size());
      } catch (const Error&) {
      }
    }
  }
}

TEST(Obj, ReadsWhatOtherProgramsWrite) {
  const char* cube =
      "mtllib x.mtl\no Cube\nv 0 0 0 # c\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\n"
      "v 0 1 1\nvn 0 0 1\nvt 0.5 0.5\ns off\nf 4//1 3//1 2//1 1//1\nf -4/1 -3/1 -2/1 -1/1\n"
      "f 1 2 6 5\nf 2 3 \\\n 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
  const TriMesh m = parse_obj(cube, "cube.obj");
  expect_closed_manifold(m);
  EXPECT_DOUBLE_EQ(check_mesh(m).volume, 1);
  EXPECT_EQ(m.triangles.size(), 12u);
}

TEST(Obj, TakesConcavePolygonsApart) {
  // An L standing up: volume 3, and a fan from any corner of the 6-gon but two would be wrong.
  const char* shape =
      "v 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nv 0 0 0\nv 2 0 0\n"
      "v 2 1 1\nv 1 1 1\nv 1 2 1\nv 0 2 1\nv 0 0 1\nv 2 0 1\n"
      "f 7 8 9 10 11 12\nf 6 5 4 3 2 1\nf 1 2 8 7\nf 2 3 9 8\nf 3 4 10 9\nf 4 5 11 10\n"
      "f 5 6 12 11\nf 6 1 7 12\n";
  const TriMesh m = parse_obj(shape, "l.obj");
  expect_closed_manifold(m);
  EXPECT_DOUBLE_EQ(check_mesh(m).volume, 3);
  EXPECT_DOUBLE_EQ(check_mesh(m).area, 14);
}

TEST(Obj, RefusesWhatIsWrong) {
  const auto refused = [](const char* text) { return parse_code(text, MeshFormat::obj); };
  EXPECT_EQ(refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n"), "obj-index");
  EXPECT_EQ(refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -4\n"), "obj-index");
  EXPECT_EQ(refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 99999999999999\n"), "obj-index");
  EXPECT_EQ(refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 0\n"), "obj-syntax");
  EXPECT_EQ(refused("v 0 0 nan\n"), "obj-syntax");
  EXPECT_EQ(refused("v 0 0\n"), "obj-syntax");
  EXPECT_EQ(refused("v 0 0 1e99\n"), "obj-syntax");
  EXPECT_EQ(refused(""), "obj-empty");
  EXPECT_EQ(refused("solid\n"), "obj-empty");
}

TEST(Ply, ReadsTextAndBigEndian) {
  const std::string head =
      "ply\r\nformat ascii 1.0\r\ncomment x\r\nelement vertex 3\r\n"
      "property double x\r\nproperty double y\r\nproperty double z\r\n"
      "property float quality\r\nelement face 1\r\n"
      "property list uchar uint vertex_index\r\nproperty list uchar float "
      "texcoord\r\nend_header\r\n";
  const TriMesh m =
      parse_ply(head + "0 0 0 9\r\n1 0 0 9\r\n0 1e0 0 9\r\n3 0 1 2 2 0.5 0.5\r\n", "a.ply");
  EXPECT_EQ(m.triangles.size(), 1u);
  std::string big =
      "ply\nformat binary_big_endian 1.0\nelement vertex 3\nproperty float x\n"
      "property float y\nproperty float z\nelement face 1\n"
      "property list uchar ushort vertex_indices\nend_header\n";
  for (const float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f})
    for (int i = 3; i >= 0; --i) big += char(std::bit_cast<std::uint32_t>(x) >> (8 * i));
  big += std::string("\3\0\0\0\1\0\2", 7);
  EXPECT_EQ(corners_of(parse_ply(big, "b.ply")), corners_of(m));
}

TEST(Ply, RefusesCountsThatTheFileCannotHold) {
  std::string bytes = bytes_as(MeshFormat::ply, format_part());
  const std::string count = "element vertex 120";
  const std::size_t at = bytes.find(count);
  ASSERT_NE(at, bytes.npos);
  bytes.replace(at, count.size(), "element vertex 4000000000");
  EXPECT_EQ(parse_code(bytes, MeshFormat::ply), "ply-truncated");
  EXPECT_EQ(
      parse_code("ply\nformat ascii 1.0\nelement nothing 9000000000000000000\nelement face 2\n"
                 "property list int int vertex_indices\nend_header\n2147483647 1 2 3\n",
                 MeshFormat::ply),
      "ply-truncated");
}

TEST(Off, RefusesCountsThatTheFileCannotHold) {
  EXPECT_EQ(parse_code("OFF\n4000000000 1 0\n0 0 0\n", MeshFormat::off), "off-truncated");
  EXPECT_EQ(parse_code("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4000000000 0 1 2\n", MeshFormat::off),
            "off-truncated");
  EXPECT_EQ(parse_code("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", MeshFormat::off), "off-index");
  EXPECT_EQ(parse_code("OFF\n3 1 0\n0 0 0\n1 0 inf\n0 1 0\n3 0 1 2\n", MeshFormat::off), "off-nan");
  EXPECT_EQ(parse_code("OFF\n-3 1 0\n", MeshFormat::off), "off-syntax");
}

TEST(MeshFormats, AskForMemoryWhereTheWholeMeshIsWritten) {
  const TriMesh m = format_part();
  const auto written = [&](MeshFormat format) {
    return error_code([&] {
      bytes_of([&](const ByteSink& out) { encode_mesh(MemoryMesh(m), format, {}, out); });
    });
  };
  const MemoryLimit limit(1);
  EXPECT_EQ(written(MeshFormat::glb), "memory");
  EXPECT_EQ(written(MeshFormat::ply), "");
}

TEST(MeshFormats, AskForTheMemoryOfWhatTheyRead) {
  const TriMesh m = sphere_mesh(200, 10);
  std::vector<std::pair<MeshFormat, std::string>> files;
  for (const MeshFormat format :
       {MeshFormat::obj, MeshFormat::off, MeshFormat::ply, MeshFormat::threemf, MeshFormat::glb})
    files.push_back({format, bytes_as(format, m)});
  for (const bool ascii : {false, true})
    files.push_back({MeshFormat::stl, bytes_of([&](const ByteSink& out) {
                       encode_mesh(MemoryMesh(m), MeshFormat::stl, {.ascii = ascii}, out);
                     })});
  const MemoryLimit limit(1);
  for (const auto& [format, bytes] : files)
    EXPECT_EQ(parse_code(bytes, format), "memory") << int(format);
}

TEST(MeshFormats, RefuseCoordinatesBeyondTenKilometres) {
  for (const MeshFormat format : kFormats) {
    TriMesh box = box_mesh({0, 0, 0}, {1, 2, 3});
    box.vertices[7] = {1e7F, 1e7F, 1e7F};
    EXPECT_EQ(parse_code(bytes_as(format, box), format), "") << int(format);
    box.vertices[7] = {1e38F, 1e7F, 1e7F};
    EXPECT_TRUE(parse_code(bytes_as(format, box), format).ends_with("-too-far")) << int(format);
  }
}

TEST(MeshFormats, WeldFilesThatRepeatTheirVertices) {
  const TriMesh box = box_mesh({0, 0, 0}, {1, 2, 3});
  TriMesh soup;
  for (const auto& t : box.triangles) {
    for (const std::uint32_t v : t) soup.vertices.push_back(box.vertices[v]);
    const auto n = std::uint32_t(soup.vertices.size());
    soup.triangles.push_back({n - 3, n - 2, n - 1});
  }
  for (const MeshFormat format : kFormats) {
    const TriMesh back = parse_mesh(bytes_as(format, soup), format, "part");
    EXPECT_EQ(back.vertices.size(), 8u);
    expect_closed_manifold(back);
  }
}

// Some editors put it before every text.
TEST(MeshFormats, TakeTextsWithTheMarkOfUtf8) {
  const std::string mark = "\xef\xbb\xbf", stl =
                                               "solid\nfacet normal 0 0 0\nouter loop\nvertex 0 0 "
                                               "0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
                                               "endfacet\nendsolid";
  EXPECT_EQ(parse_code(mark + stl, MeshFormat::stl), "");
  const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  EXPECT_EQ(parse_mesh(mark + obj, MeshFormat::obj, "m").vertices.size(), 3u);
  EXPECT_EQ(parse_code(mark + bytes_as(MeshFormat::off, format_part()), MeshFormat::off), "");
}

TEST(MeshFile, FormatsAreToldByExtension) {
  EXPECT_EQ(mesh_format_of("a/b.c/part.STL"), MeshFormat::stl);
  EXPECT_EQ(mesh_format_of("x.3mf"), MeshFormat::threemf);
  EXPECT_EQ(error_code([] { mesh_format_of("a.stl/part"); }), "mesh-format");
  EXPECT_EQ(error_code([] { mesh_format_of("part.step"); }), "mesh-format");
}

TEST(MeshFile, IsWrittenWholeAndReadBack) {
  const testing::TempFolder temporary;
  const std::filesystem::path& folder = temporary.folder();
  for (const char* end : {".stl", ".obj", ".ply", ".off", ".3mf"}) {
    const std::string path = (folder / "part").string() + end;
    save_mesh(path, format_part());
    EXPECT_EQ(corners_of(load_mesh(path)), corners_of(format_part())) << end;
  }
  save_mesh((folder / "part.glb").string(), format_part());
  EXPECT_EQ(error_code([&] { save_mesh((folder / "none.stl").string(), {}); }), "mesh-empty");
  EXPECT_FALSE(std::filesystem::exists(folder / "none.stl"));
  EXPECT_EQ(error_code([&] { save_mesh((folder / "no/part.stl").string(), format_part()); }),
            "output-folder");
  EXPECT_EQ(error_code([&] { load_mesh((folder / "gone.stl").string()); }), "file-missing");
}

}  // namespace
}  // namespace mrsim
