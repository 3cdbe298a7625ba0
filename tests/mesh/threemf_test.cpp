// 3MF: units, components and transforms, what is refused.
#include "mesh/format/threemf.h"

#include "core/process/memory_limit.h"
#include "core/text/zip.h"
#include "support/mesh_asserts.h"
#include "support/mesh_files.h"

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using namespace mrsim::testing;

std::string package(const std::string& model) {
  return detail::zip({{"_rels/.rels", "<R/>"}, {"3d/3DModel.model", model}});
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
    return parse_code(package(model), MeshFormat::threemf);
  };
  EXPECT_EQ(refused("<model><resources><object id=\"1\"><components><component objectid=\"1\"/>"
                    "<component objectid=\"1\"/></components></object></resources><build><item "
                    "objectid=\"1\"/></build></model>"),
            "3mf-too-large");
  EXPECT_EQ(refused("<!DOCTYPE x [<!ENTITY a \"b\">]><model/>"), "3mf-xml");
  EXPECT_EQ(refused("<model><resources><object id=\"1\""), "3mf-xml");
  EXPECT_EQ(refused("<model><build><item objectid=\"5\"/></build></model>"), "3mf-index");
  EXPECT_EQ(refused("<model/>"), "3mf-empty");
  EXPECT_EQ(refused("<model unit=\"Inch\"/>"), "3mf-unit");
  // A directory that claims 3 GB in a few bytes is refused before anything is unpacked.
  std::string bomb = package(std::string(5000, ' '));
  const std::size_t entry = bomb.find("PK\1\2", bomb.find("PK\1\2") + 1);
  for (int i = 0; i < 4; ++i) bomb[entry + 24 + std::size_t(i)] = "\0\0\0\xc0"[i];
  EXPECT_EQ(parse_code(bomb, MeshFormat::threemf), "3mf-too-large");
  EXPECT_EQ(parse_code("PK", MeshFormat::threemf), "3mf-zip");
}

TEST(ThreeMf, CountsInstancesBeforeTheyAreAdded) {
  const MemoryLimit limit(std::size_t(1) << 30);
  std::string object = "<object id=\"1\"><mesh><vertices>", build;
  for (int i = 0; i < 3000; ++i) object += "<vertex x=\"0\" y=\"0\" z=\"0\"/>";
  object +=
      "</vertices><triangles><triangle v1=\"0\" v2=\"1\" v3=\"2\"/></triangles></mesh></object>";
  for (int i = 0; i < 60000; ++i) build += "<item objectid=\"1\"/>";
  EXPECT_EQ(parse_code(package("<model><resources>" + object + "</resources><build>" + build +
                               "</build></model>"),
                       MeshFormat::threemf),
            "3mf-too-large");
}

}  // namespace
}  // namespace mrsim
