// What other people's programs make of the files that mrsim writes: OpenMesh for STL, OBJ, PLY and
// OFF, lib3mf for 3MF, and the rules of glTF for GLB.
#include "core/text/bytes.h"
#include "mesh/format/glb.h"
#include "mesh/format/mesh_io.h"
#include "mesh/solid/half_edges.h"
#include "support/mesh_asserts.h"
#include "support/shapes.h"
#include "support/temp_folder.h"

#include <cmath>
#include <filesystem>

#include <Model/COM/NMR_DLLInterfaces.h>
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

namespace mrsim {
namespace {

using namespace mrsim::testing;
using Json = nlohmann::json;

class Foreign : public testing::TempFolderTest {};

TriMesh part() {
  TriMesh m = tube_mesh(64, 10, 5, 0.1, 7);
  for (std::size_t f = 0; f < m.triangles.size(); ++f) m.owners.push_back(int(f / 100) - 1);
  m.origin.files = {"PRIMER_2F.MPF"};
  m.origin.tools = {"4"};
  for (int owner = 0; owner < 5; ++owner) m.origin.origins.push_back({owner, 0, 10 + owner, 0});
  return m;
}

TEST_F(Foreign, OpenMeshReadsTheSameSolid) {
  const TriMesh m = part();
  for (const bool ascii : {false, true})
    for (const ColorBy color : {ColorBy::none, ColorBy::line})
      for (const char* end : {".stl", ".obj", ".ply", ".off"}) {
        SCOPED_TRACE(std::string(end) + (color == ColorBy::none ? " plain" : " coloured"));
        save_mesh(path("part") + end, m, {color, ascii});
        OpenMesh::TriMesh_ArrayKernelT<> other;
        ASSERT_TRUE(OpenMesh::IO::read_mesh(other, path("part") + end));
        EXPECT_EQ(other.n_vertices(), m.vertices.size());
        ASSERT_EQ(other.n_faces(), m.triangles.size());
        for (const auto edge : other.edges()) EXPECT_FALSE(other.is_boundary(edge));
        std::size_t f = 0;
        for (const auto face : other.faces()) {
          Vec3 sum, wanted;
          for (const auto v : other.fv_range(face)) {
            const auto p = other.point(v);
            sum += Vec3{p[0], p[1], p[2]};
          }
          for (int k = 0; k < 3; ++k) wanted += corner(m, f, k);
          EXPECT_NEAR(distance(sum, wanted), 0, 1e-4);
          ++f;
        }
      }
}

TEST_F(Foreign, Lib3mfReadsTheSameSolidWithoutWarnings) {
  using namespace NMR;
  const TriMesh m = part();
  save_mesh(path("part.3mf"), m, {ColorBy::tool, false});
  PLib3MFModel* model = nullptr;
  PLib3MFModelReader* reader = nullptr;
  PLib3MFModelResourceIterator* objects = nullptr;
  PLib3MFModelResource* object = nullptr;
  BOOL has_next = 0;
  ASSERT_EQ(lib3mf_createmodel(&model), 0);
  ASSERT_EQ(lib3mf_model_queryreader(model, "3mf", &reader), 0);
  ASSERT_EQ(lib3mf_reader_readfromfileutf8(reader, path("part.3mf").c_str()), 0);
  DWORD warnings = 0, vertices = 0, triangles = 0;
  ASSERT_EQ(lib3mf_reader_getwarningcount(reader, &warnings), 0);
  EXPECT_EQ(warnings, 0u);
  ASSERT_EQ(lib3mf_model_getmeshobjects(model, &objects), 0);
  ASSERT_EQ(lib3mf_resourceiterator_movenext(objects, &has_next), 0);
  ASSERT_TRUE(has_next);
  ASSERT_EQ(lib3mf_resourceiterator_getcurrent(objects, &object), 0);
  ASSERT_EQ(lib3mf_meshobject_getvertexcount(object, &vertices), 0);
  ASSERT_EQ(lib3mf_meshobject_gettrianglecount(object, &triangles), 0);
  ASSERT_EQ(vertices, m.vertices.size());
  ASSERT_EQ(triangles, m.triangles.size());
  for (DWORD i = 0; i < vertices; ++i) {
    MODELMESHVERTEX v;
    ASSERT_EQ(lib3mf_meshobject_getvertex(object, i, &v), 0);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(v.m_fPosition[k], m.vertices[i][k], 1e-5);
  }
  for (DWORD i = 0; i < triangles; ++i) {
    MODELMESHTRIANGLE t;
    ASSERT_EQ(lib3mf_meshobject_gettriangle(object, i, &t), 0);
    for (int k = 0; k < 3; ++k) EXPECT_EQ(t.m_nIndices[k], m.triangles[i][k]);
  }
  for (PLib3MFBase* p : {object, objects, reader, model}) lib3mf_release(p);
}

// A GLB file taken apart by the rules of glTF 2.0.
struct Glb {
  Json json;
  std::string binary;

  explicit Glb(const std::string& bytes) {
    const auto word = [&](std::size_t at) { return detail::load<std::uint32_t>(&bytes[at]); };
    EXPECT_EQ(bytes.substr(0, 4), "glTF");
    EXPECT_EQ(word(4), 2u);
    EXPECT_EQ(word(8), bytes.size());
    const std::size_t json_size = word(12);
    EXPECT_EQ(bytes.substr(16, 4), "JSON");
    EXPECT_EQ(json_size % 4, 0u);
    json = Json::parse(bytes.substr(20, json_size));
    EXPECT_EQ(bytes.substr(24 + json_size, 4), std::string("BIN\0", 4));
    binary = bytes.substr(28 + json_size);
    EXPECT_EQ(word(20 + json_size), binary.size());
    EXPECT_EQ(json["buffers"][0]["byteLength"], binary.size());
  }

  // Value k of item i of an accessor, checked to lie in its view.
  double value(int accessor, std::size_t i, std::size_t k) const {
    const Json& a = json["accessors"][std::size_t(accessor)];
    const Json& view = json["bufferViews"][a["bufferView"].get<std::size_t>()];
    const int type = a["componentType"];
    const std::size_t size = type == 5120 || type == 5121 ? 1 : type == 5123 ? 2 : 4;
    const std::size_t parts = a["type"] == "SCALAR" ? 1 : a["type"] == "VEC3" ? 3 : 4;
    const std::size_t stride = view.value("byteStride", size * parts);
    const std::size_t offset = i * stride + k * size;
    EXPECT_LE(offset + size, view["byteLength"].get<std::size_t>());
    EXPECT_EQ(stride % 4 == 0 || parts == 1, true);
    const char* at = &binary[view["byteOffset"].get<std::size_t>() + offset];
    const bool normalized = a.value("normalized", false);
    if (type == 5120) return detail::load<std::int8_t>(at) / (normalized ? 127.0 : 1);
    if (type == 5121) return detail::load<std::uint8_t>(at) / (normalized ? 255.0 : 1);
    if (type == 5123) return detail::load<std::uint16_t>(at);
    if (type == 5125) return detail::load<std::uint32_t>(at);
    return detail::load<float>(at);
  }

  // Position of a vertex in mm, Z up again.
  Vec3 position(int accessor, std::size_t i) const {
    const Json& node = json["nodes"][0];
    double world[3] = {};
    for (std::size_t row = 0; row < 3; ++row)
      for (std::size_t column = 0; column < 4; ++column)
        world[row] += node["matrix"][4 * column + row].get<double>() *
                      (column < 3 ? value(accessor, i, column) : 1);
    return {1000 * world[0], -1000 * world[2], 1000 * world[1]};
  }
};

TEST_F(Foreign, GlbKeepsTheRulesOfGltf) {
  const TriMesh m = part();
  MeshFileOptions options;
  options.color = ColorBy::line;
  const Glb glb(bytes_of([&](const ByteSink& out) { write_glb(m, options, out); }));
  EXPECT_EQ(glb.json["asset"]["version"], "2.0");
  EXPECT_EQ(glb.json["extensionsRequired"], Json::array({"KHR_mesh_quantization"}));
  EXPECT_EQ(glb.json["scenes"][0]["nodes"], Json::array({0}));
  const Json& primitive = glb.json["meshes"][0]["primitives"][0];
  EXPECT_EQ(primitive["material"], 0);
  EXPECT_TRUE(glb.json["materials"][0].is_object());
  const int indices = primitive["indices"];
  const int positions = primitive["attributes"]["POSITION"];
  const int normals = primitive["attributes"]["NORMAL"];
  const int owners = primitive["attributes"]["_OWNER"];
  const int colors = primitive["attributes"]["COLOR_0"];
  const auto count = [&](int a) {
    return glb.json["accessors"][std::size_t(a)]["count"].get<std::size_t>();
  };
  ASSERT_EQ(count(indices), 3 * m.triangles.size());
  for (const int a : {normals, owners, colors}) EXPECT_EQ(count(a), count(positions));
  for (std::size_t h = 0; h < count(indices); ++h) {
    const auto v = std::size_t(glb.value(indices, h, 0));
    ASSERT_LT(v, count(positions));
    const Vec3 exact = corner(m, h / 3, int(h % 3));
    EXPECT_LE(distance(glb.position(positions, v), exact), 1e-12);
    EXPECT_EQ(glb.value(owners, v, 0), m.owners[h / 3]);
    const Vec3 n{glb.value(normals, v, 0), glb.value(normals, v, 1), glb.value(normals, v, 2)};
    EXPECT_NEAR(length(n), 1, 0.02);
    EXPECT_GT(dot(n, normalized(area_normal(m, h / 3))), 0.9);
    EXPECT_EQ(glb.value(colors, v, 3), 1);
  }
  const Json& limits = glb.json["accessors"][std::size_t(positions)];
  const Box3 box = check_mesh(m).bounds;
  EXPECT_EQ(limits["min"], Json::array({box.lo.x, box.lo.y, box.lo.z}));
  EXPECT_EQ(limits["max"], Json::array({box.hi.x, box.hi.y, box.hi.z}));
  const Json& told = glb.json["meshes"][0]["extras"]["mrsim"];
  EXPECT_EQ(told["files"], Json::array({"PRIMER_2F.MPF"}));
  EXPECT_EQ(told["origins"][2], Json::array({2, 0, 12, 0}));
}

TEST_F(Foreign, GlbWithoutOwnersHasNone) {
  TriMesh m = box_mesh({0, 0, 0}, {1, 2, 3});
  const Glb glb(bytes_of([&](const ByteSink& out) { write_glb(m, {}, out); }));
  const Json& primitive = glb.json["meshes"][0]["primitives"][0];
  EXPECT_EQ(primitive["attributes"].size(), 2u);
  EXPECT_EQ(glb.json["accessors"][0]["count"], 24);  // each corner of a box in three normals
  EXPECT_FALSE(glb.json["meshes"][0].contains("extras"));
}

}  // namespace
}  // namespace mrsim
