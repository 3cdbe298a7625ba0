// Every format written by mrsim and read back by mrsim; formats_foreign_test.cpp reads them with
// other people's readers.
#include "core/bytes.h"
#include "core/memory_limit.h"
#include "core/zip.h"
#include "mesh/format/glb.h"
#include "mesh/format/mesh_io.h"
#include "mesh/format/obj.h"
#include "mesh/format/off.h"
#include "mesh/format/ply.h"
#include "mesh/format/threemf.h"
#include "mesh/solid/half_edges.h"
#include "mesh/solid/weld.h"
#include "support/mesh_asserts.h"
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

TriMesh part() {
  TriMesh m = tube_mesh(30, 10, 5, 0.1, 7);
  for (std::size_t f = 0; f < m.triangles.size(); ++f) m.owners.push_back(int(f / 40) * 3 - 1);
  m.origin.files = {"data/PRIMER_2F.MPF", "a & <b>.spf"};
  m.origin.tools = {"4", "T \"7\""};
  for (int owner = 2; owner < 17; owner += 3)
    m.origin.origins.push_back({owner, owner % 2, 10 + owner, (owner + 1) % 2});
  return m;
}

std::string bytes_as(MeshFormat format, const TriMesh& m, ColorBy color = ColorBy::none) {
  return bytes_of([&](const ByteSink& out) {
    if (format == MeshFormat::obj) write_obj(m, out);
    if (format == MeshFormat::off) write_off(m, out);
    if (format == MeshFormat::ply) write_ply(m, color, out);
    if (format == MeshFormat::threemf) write_3mf(m, color, out);
    if (format == MeshFormat::glb) write_glb(m, {.color = color}, out);
  });
}
std::string code(const std::string& bytes, MeshFormat format) {
  return error_code([&] { parse_mesh(bytes, format, "part"); });
}
constexpr MeshFormat kFormats[] = {MeshFormat::obj, MeshFormat::off, MeshFormat::ply,
                                   MeshFormat::threemf};

TEST(MeshFormats, ReadBackWhatTheyWrite) {
  const TriMesh m = part();
  for (const MeshFormat format : kFormats)
    for (const ColorBy color : {ColorBy::none, ColorBy::line, ColorBy::tool}) {
      const TriMesh back = parse_mesh(bytes_as(format, m, color), format, "part");
      EXPECT_EQ(back.vertices, m.vertices) << int(format);
      EXPECT_EQ(back.triangles, m.triangles) << int(format);
      if (!keeps_owners(format)) continue;
      EXPECT_EQ(back.owners, m.owners) << int(format);
      EXPECT_EQ(back.origin, m.origin) << int(format);
    }
}

TEST(MeshFormats, KeepVertexColours) {
  TriMesh m = part();
  for (std::size_t v = 0; v < m.vertices.size(); ++v)
    m.colors.push_back({std::uint8_t(v), std::uint8_t(2 * v), 200});
  for (const MeshFormat format : {MeshFormat::obj, MeshFormat::ply})
    EXPECT_EQ(parse_mesh(bytes_as(format, m), format, "part").colors, m.colors) << int(format);
}

TEST(Ply, KeepsTheLegendOfItsColours) {
  TriMesh m = part();
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
  const TriMesh m = part();
  for (const MeshFormat format : kFormats)
    EXPECT_EQ(bytes_as(format, m, ColorBy::line), bytes_as(format, m, ColorBy::line));
}

TEST(MeshFormats, SurviveEveryTruncation) {
  for (const MeshFormat format :
       {MeshFormat::obj, MeshFormat::off, MeshFormat::ply, MeshFormat::threemf, MeshFormat::glb}) {
    const std::string bytes = bytes_as(format, part(), ColorBy::tool);
    for (std::size_t n = 0; n + 1 < bytes.size(); n += 1 + bytes.size() / 300) {
      const std::string c = code(bytes.substr(0, n), format);
      // A text file may end behind a whole line: then it is a smaller mesh, which is open.
      EXPECT_TRUE(!c.empty() || format == MeshFormat::obj) << int(format) << " " << n;
    }
  }
}

TEST(MeshFormats, SurviveEveryFlippedByte) {
  for (const MeshFormat format :
       {MeshFormat::obj, MeshFormat::off, MeshFormat::ply, MeshFormat::threemf, MeshFormat::glb}) {
    const std::string bytes = bytes_as(format, part(), ColorBy::tool);
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
  const auto refused = [](const char* text) { return code(text, MeshFormat::obj); };
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
  std::string bytes = bytes_as(MeshFormat::ply, part());
  const std::string count = "element vertex 120";
  const std::size_t at = bytes.find(count);
  ASSERT_NE(at, bytes.npos);
  bytes.replace(at, count.size(), "element vertex 4000000000");
  EXPECT_EQ(code(bytes, MeshFormat::ply), "ply-truncated");
  EXPECT_EQ(code("ply\nformat ascii 1.0\nelement nothing 9000000000000000000\nelement face 2\n"
                 "property list int int vertex_indices\nend_header\n2147483647 1 2 3\n",
                 MeshFormat::ply),
            "ply-truncated");
}

TEST(Off, RefusesCountsThatTheFileCannotHold) {
  EXPECT_EQ(code("OFF\n4000000000 1 0\n0 0 0\n", MeshFormat::off), "off-truncated");
  EXPECT_EQ(code("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4000000000 0 1 2\n", MeshFormat::off),
            "off-truncated");
  EXPECT_EQ(code("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", MeshFormat::off), "off-index");
  EXPECT_EQ(code("OFF\n3 1 0\n0 0 0\n1 0 inf\n0 1 0\n3 0 1 2\n", MeshFormat::off), "off-nan");
  EXPECT_EQ(code("OFF\n-3 1 0\n", MeshFormat::off), "off-syntax");
}

std::string package(const std::string& model) {
  return detail::zip({{"_rels/.rels", "<R/>"}, {"3d/3DModel.model", model}});
}

TEST(Glb, ReadsBackWithinItsSteps) {
  TriMesh m = part();
  m.legend = {{{20, 76, 168}, "+0.06 mm"}};
  for (const bool colored : {false, true}) {
    if (colored) m.colors.assign(m.vertices.size(), {20, 76, 168});
    const TriMesh back = parse_mesh(bytes_as(MeshFormat::glb, m), MeshFormat::glb, "part");
    expect_closed_manifold(back);
    ASSERT_EQ(back.triangles.size(), m.triangles.size());
    for (std::size_t f = 0; f < m.triangles.size(); ++f)
      for (int k = 0; k < 3; ++k)
        EXPECT_LE(distance(corner(back, f, k), corner(m, f, k)), glb_max_error(m) + 1e-6);
    EXPECT_EQ(back.owners, m.owners);
    EXPECT_EQ(back.origin, m.origin);
    ASSERT_EQ(back.colors.size(), colored ? back.vertices.size() : 0);
    EXPECT_EQ(back.legend.size(), colored ? 1u : 0u);
    for (std::size_t k = 0; colored && k < 3; ++k)
      EXPECT_NEAR(back.colors[0][k], m.colors[0][k], 3);  // the file has 8 bits of linear light
  }
}

// A GLB with one triangle mesh of a tetrahedron and `nodes`.
std::string tetrahedron_glb(const std::string& nodes, const std::string& more = "") {
  std::string binary;
  for (const float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f})
    detail::store(binary, x);
  for (const int i : {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}) binary += char(i);
  std::string json =
      R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":)" + nodes +
      R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],"accessors":[)"
      R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},)"
      R"({"bufferView":1,"componentType":5121,"count":12,"type":"SCALAR"}],"bufferViews":[)"
      R"({"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":12}],)"
      R"("buffers":[{"byteLength":60}])" +
      more + "}";
  json.resize((json.size() + 3) / 4 * 4, ' ');
  std::string out;
  for (const std::size_t n :
       {std::size_t(0x46546c67), std::size_t(2), 28 + json.size() + binary.size(), json.size(),
        std::size_t(0x4e4f534a)})
    detail::store(out, std::uint32_t(n));
  out += json;
  detail::store(out, std::uint32_t(binary.size()));
  detail::store(out, std::uint32_t(0x004e4942));
  return out + binary;
}

TEST(Glb, AppliesNodesAndTurnsMetresWithYUp) {
  const auto read = [](const std::string& nodes) {
    return parse_mesh(tetrahedron_glb(nodes), MeshFormat::glb, "part");
  };
  // Corner (0, 1, 0) m stands upright at z = 1000 mm.
  TriMesh m = read(R"([{"mesh":0}])");
  expect_closed_manifold(m);
  EXPECT_EQ(m.vertices[2], (std::array<float, 3>{0, 0, 1000}));
  m = read(R"([{"children":[1],"translation":[0,0,2]},{"mesh":0,"scale":[2,3,-1]}])");
  expect_closed_manifold(m);  // mirrored, and turned back
  const MeshSummary s = check_mesh(m);
  EXPECT_NEAR(s.volume, 6e9 / 6, 1e3);
  EXPECT_EQ(s.bounds.lo.y, -2000);
  m = read(R"([{"mesh":0,"matrix":[0,1,0,0,-1,0,0,0,0,0,1,0,5,0,0,1]}])");
  EXPECT_EQ(check_mesh(m).bounds.lo.x, 4000);
}

TEST(Glb, RefusesWhatIsWrong) {
  EXPECT_EQ(code("glTF", MeshFormat::glb), "glb-syntax");
  EXPECT_EQ(code(tetrahedron_glb(R"([{"mesh":7}])"), MeshFormat::glb), "glb-syntax");
  EXPECT_EQ(code(tetrahedron_glb(R"([{"children":[0]}])"), MeshFormat::glb), "glb-syntax");
  EXPECT_EQ(code(tetrahedron_glb(R"([{}])"), MeshFormat::glb), "glb-empty");
  EXPECT_EQ(code(tetrahedron_glb(R"([{"mesh":0}])",
                                 R"(,"extensionsRequired":["KHR_draco_mesh_compression"])"),
                 MeshFormat::glb),
            "glb-unsupported");
  std::string bad = tetrahedron_glb(R"([{"mesh":0}])");
  bad.back() = 9;
  EXPECT_EQ(code(bad, MeshFormat::glb), "glb-index");
  bad.replace(bad.find("\"count\":4"), 9, "\"count\":9");
  EXPECT_EQ(code(bad, MeshFormat::glb), "glb-truncated");
}

TEST(ThreeMf, AppliesUnitsComponentsAndTransforms) {
  const std::string object =
      "<object id=\"1\"><mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"1\" y=\"0\" "
      "z=\"0\"/><vertex x=\"0\" y=\"1\" z=\"0\"/><vertex x=\"0\" y=\"0\" z=\"1\"/></vertices>"
      "<triangles><triangle v1=\"0\" v2=\"2\" v3=\"1\"/><triangle v1=\"0\" v2=\"1\" v3=\"3\"/>"
      "<triangle v1=\"1\" v2=\"2\" v3=\"3\"/><triangle v1=\"2\" v2=\"0\" v3=\"3\"/></triangles>"
      "</mesh></object>";
  const std::string model =
      "<?xml version=\"1.0\"?><!-- x --><model unit=\"inch\"><resources>" + object +
      "<object id='7'><components><component objectid=\"1\" transform=\"2 0 0 0 1 0 0 0 1 0 0 "
      "0\"/></components></object></resources><build><item objectid=\"7\" transform=\"-1 0 0 0 1 0 "
      "0 0 1 10 0 0\"/><item objectid=\"1\"/></build></model>";
  const TriMesh m = parse_3mf(package(model), "t.3mf");
  expect_closed_manifold(m);
  EXPECT_NEAR(check_mesh(m).volume, 3 * 25.4 * 25.4 * 25.4 / 6, 0.01);
  EXPECT_NEAR(check_mesh(m).bounds.hi.x, 254, 1e-4);
  EXPECT_NEAR(check_mesh(m).bounds.lo.x, 0, 1e-4);
}

TEST(ThreeMf, RefusesBombsAndLoops) {
  const auto refused = [](const std::string& model) {
    return code(package(model), MeshFormat::threemf);
  };
  EXPECT_EQ(refused("<model><resources><object id=\"1\"><components><component objectid=\"1\"/>"
                    "<component objectid=\"1\"/></components></object></resources><build><item "
                    "objectid=\"1\"/></build></model>"),
            "3mf-too-large");
  EXPECT_EQ(refused("<!DOCTYPE x [<!ENTITY a \"b\">]><model/>"), "3mf-xml");
  EXPECT_EQ(refused("<model><resources><object id=\"1\""), "3mf-xml");
  EXPECT_EQ(refused("<model><build><item objectid=\"5\"/></build></model>"), "3mf-index");
  EXPECT_EQ(refused("<model/>"), "3mf-empty");
  // A directory that claims 3 GB in a few bytes is refused before anything is unpacked.
  std::string bomb = package(std::string(5000, ' '));
  const std::size_t entry = bomb.find("PK\1\2", bomb.find("PK\1\2") + 1);
  for (int i = 0; i < 4; ++i) bomb[entry + 24 + std::size_t(i)] = "\0\0\0\xc0"[i];
  EXPECT_EQ(code(bomb, MeshFormat::threemf), "3mf-too-large");
  EXPECT_EQ(code("PK", MeshFormat::threemf), "3mf-zip");
}

// 60 000 instances of 3 000 points, of which a triangle uses three.
std::string glb_of_instances() {
  constexpr std::size_t kNodes = 60000, kPoints = 3000;
  std::string nodes, list;
  for (std::size_t i = 0; i < kNodes; ++i) {
    nodes += i > 0 ? ",{\"mesh\":0}" : "{\"mesh\":0}";
    list += (i > 0 ? "," : "") + std::to_string(i);
  }
  std::string json =
      "{\"asset\":{\"version\":\"2.0\"},\"scenes\":[{\"nodes\":[" + list + "]}],\"nodes\":[" +
      nodes +
      "],\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"indices\":1}]}],"
      "\"buffers\":[{\"byteLength\":36012}],\"bufferViews\":[{\"buffer\":0,\"byteLength\":36000},"
      "{\"buffer\":0,\"byteOffset\":36000,\"byteLength\":12}],\"accessors\":[{\"bufferView\":0,"
      "\"componentType\":5126,\"count\":3000,\"type\":\"VEC3\"},{\"bufferView\":1,"
      "\"componentType\":5125,\"count\":3,\"type\":\"SCALAR\"}]}";
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const std::string binary(12 * kPoints + 12, '\0');
  std::string out = "glTF";
  for (const std::size_t word : {std::size_t(2), 28 + json.size() + binary.size(), json.size()})
    detail::store(out, std::uint32_t(word));
  out += "JSON" + json;
  detail::store(out, std::uint32_t(binary.size()));
  return out + std::string("BIN\0", 4) + binary;
}

TEST(MeshFormats, CountInstancesBeforeTheyAreAdded) {
  const MemoryLimit limit(std::size_t(1) << 30);
  EXPECT_EQ(code(glb_of_instances(), MeshFormat::glb), "glb-too-large");
  std::string object = "<object id=\"1\"><mesh><vertices>", build;
  for (int i = 0; i < 3000; ++i) object += "<vertex x=\"0\" y=\"0\" z=\"0\"/>";
  object +=
      "</vertices><triangles><triangle v1=\"0\" v2=\"1\" v3=\"2\"/></triangles></mesh></object>";
  for (int i = 0; i < 60000; ++i) build += "<item objectid=\"1\"/>";
  EXPECT_EQ(code(package("<model><resources>" + object + "</resources><build>" + build +
                         "</build></model>"),
                 MeshFormat::threemf),
            "3mf-too-large");
}

TEST(MeshFormats, AskForMemoryWhereTheWholeMeshIsWritten) {
  const TriMesh m = part();
  const auto written = [&](MeshFormat format) {
    return error_code([&] {
      bytes_of([&](const ByteSink& out) { encode_mesh(MemoryMesh(m), format, {}, out); });
    });
  };
  const MemoryLimit limit(1);
  EXPECT_EQ(written(MeshFormat::glb), "memory");
  EXPECT_EQ(written(MeshFormat::ply), "");
}

TEST(MeshFormats, RefuseCoordinatesBeyondTenKilometres) {
  for (const MeshFormat format : kFormats) {
    TriMesh box = box_mesh({0, 0, 0}, {1, 2, 3});
    box.vertices[7] = {1e7F, 1e7F, 1e7F};
    EXPECT_EQ(code(bytes_as(format, box), format), "") << int(format);
    box.vertices[7] = {1e38F, 1e7F, 1e7F};
    EXPECT_TRUE(code(bytes_as(format, box), format).ends_with("-too-far")) << int(format);
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

TEST(MeshFile, FormatsAreToldByExtension) {
  EXPECT_EQ(mesh_format_of("a/b.c/part.STL"), MeshFormat::stl);
  EXPECT_EQ(mesh_format_of("x.3mf"), MeshFormat::threemf);
  EXPECT_EQ(error_code([] { mesh_format_of("a.stl/part"); }), "mesh-format");
  EXPECT_EQ(error_code([] { mesh_format_of("part.step"); }), "mesh-format");
}

TEST(MeshFile, IsWrittenWholeAndReadBack) {
  const TempFolder temporary;
  const std::filesystem::path& folder = temporary.folder();
  for (const char* end : {".stl", ".obj", ".ply", ".off", ".3mf"}) {
    const std::string path = (folder / "part").string() + end;
    save_mesh(path, part());
    EXPECT_EQ(corners_of(load_mesh(path)), corners_of(part())) << end;
  }
  save_mesh((folder / "part.glb").string(), part());
  EXPECT_EQ(error_code([&] { save_mesh((folder / "none.stl").string(), {}); }), "mesh-empty");
  EXPECT_FALSE(std::filesystem::exists(folder / "none.stl"));
  EXPECT_EQ(error_code([&] { save_mesh((folder / "no/part.stl").string(), part()); }),
            "output-folder");
  EXPECT_EQ(error_code([&] { load_mesh((folder / "gone.stl").string()); }), "file-missing");
}

}  // namespace
}  // namespace mrsim
