// GLB: coordinates, nodes, what is refused.
#include "mesh/format/glb.h"

#include "core/process/memory_limit.h"
#include "core/text/bytes.h"
#include "mesh/solid/half_edges.h"
#include "support/mesh_asserts.h"
#include "support/mesh_files.h"

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using namespace mrsim::testing;

TEST(Glb, ReadsBackTheSamePlaces) {
  TriMesh m = format_part();
  m.legend = {{{20, 76, 168}, "+0.06 mm"}};
  for (const bool colored : {false, true}) {
    if (colored) m.colors.assign(m.vertices.size(), {20, 76, 168});
    const TriMesh back = parse_mesh(bytes_as(MeshFormat::glb, m), MeshFormat::glb, "part");
    expect_closed_manifold(back);
    ASSERT_EQ(back.triangles.size(), m.triangles.size());
    for (std::size_t f = 0; f < m.triangles.size(); ++f)
      for (int k = 0; k < 3; ++k) EXPECT_EQ(corner(back, f, k), corner(m, f, k));
    EXPECT_EQ(back.owners, m.owners);
    EXPECT_EQ(back.origin, m.origin);
    ASSERT_EQ(back.colors.size(), colored ? back.vertices.size() : 0);
    EXPECT_EQ(back.legend.size(), colored ? 1u : 0u);
    for (std::size_t k = 0; colored && k < 3; ++k)
      EXPECT_NEAR(back.colors[0][k], m.colors[0][k], 3);  // the file has 8 bits of linear light
  }
}

// Vertices a hundred-thousandth of the part's size from each other stay apart.
TEST(Glb, KeepsNearVerticesApart) {
  const TriMesh m = box_mesh({0.1, -20, 3}, {400.3, -19.9995, 3.0005});
  const TriMesh back = parse_mesh(bytes_as(MeshFormat::glb, m), MeshFormat::glb, "part");
  expect_closed_manifold(back);
  ASSERT_EQ(back.vertices.size(), m.vertices.size());
  for (std::size_t f = 0; f < m.triangles.size(); ++f)
    for (int k = 0; k < 3; ++k) EXPECT_EQ(corner(back, f, k), corner(m, f, k));
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
  EXPECT_EQ(parse_code("glTF", MeshFormat::glb), "glb-syntax");
  EXPECT_EQ(parse_code(tetrahedron_glb(R"([{"mesh":7}])"), MeshFormat::glb), "glb-syntax");
  EXPECT_EQ(parse_code(tetrahedron_glb(R"([{"children":[0]}])"), MeshFormat::glb), "glb-syntax");
  EXPECT_EQ(parse_code(tetrahedron_glb(R"([{}])"), MeshFormat::glb), "glb-empty");
  EXPECT_EQ(parse_code(tetrahedron_glb(R"([{"mesh":0}])",
                                       R"(,"extensionsRequired":["KHR_draco_mesh_compression"])"),
                       MeshFormat::glb),
            "glb-unsupported");
  for (const char* list : {R"("scale":[1,1])", R"("matrix":[1,0,0,0,0,1,0,0,0,0,1])",
                           R"("translation":[1,2,3,4])", R"("rotation":[])"})
    EXPECT_EQ(
        parse_code(tetrahedron_glb(std::string(R"([{"mesh":0,)") + list + "}]"), MeshFormat::glb),
        "glb-syntax")
        << list;
  std::string bad = tetrahedron_glb(R"([{"mesh":0}])");
  bad.back() = 9;
  EXPECT_EQ(parse_code(bad, MeshFormat::glb), "glb-index");
  bad.replace(bad.find("\"count\":4"), 9, "\"count\":9");
  EXPECT_EQ(parse_code(bad, MeshFormat::glb), "glb-truncated");
}

// Counts and indices: whole, however they are written, and within what a conversion is defined for.
TEST(Glb, RefusesNumbersThatAreNoCounts) {
  const auto with = [](const std::string& from, const std::string& to) {
    std::string nodes = R"([{"mesh":0,"name":"padding, that the length of the file stays"}])";
    std::string file = tetrahedron_glb(nodes);
    const std::size_t at = file.find(from), grown = to.size() - from.size();
    file.replace(at, from.size(), to);
    return file.erase(file.find("padding"), grown);
  };
  EXPECT_EQ(parse_code(with("\"mesh\":0", "\"mesh\":0.0"), MeshFormat::glb), "");
  for (const char* bad : {"1e300", "-1", "0.5", "1e19", "-1e300"})
    for (const std::string key : {"\"mesh\":", "\"POSITION\":", "\"scene\":", "\"nodes\":["})
      EXPECT_EQ(parse_code(with(key + "0", key + bad), MeshFormat::glb), "glb-syntax")
          << key << bad;
  for (const char* bad : {"1e300", "-4", "4.5", "4294967300.5"})
    EXPECT_EQ(parse_code(with("\"count\":4", std::string("\"count\":") + bad), MeshFormat::glb),
              "glb-syntax")
        << bad;
  EXPECT_EQ(parse_code(with("Type\":5126", "Type\":4294972422"), MeshFormat::glb), "glb-syntax");
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

TEST(Glb, CountsInstancesBeforeTheyAreAdded) {
  const MemoryLimit limit(std::size_t(1) << 30);
  EXPECT_EQ(parse_code(glb_of_instances(), MeshFormat::glb), "glb-too-large");
}

}  // namespace
}  // namespace mrsim
