// Every program of data/ at default settings, cut by mrsim as a user runs it: its mesh is closed,
// and free of self-intersections by CGAL. PRIMER_2F's vertices lie on the exact part.
#include "mesh/format/mesh_io.h"
#include "mesh/solid/check.h"
#include "support/analytic_field.h"
#include "support/cgal_mesh.h"
#include "support/mesh_asserts.h"
#include "support/temp_folder.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using namespace mrsim::testing;
namespace fs = std::filesystem;

// The mesh that mrsim writes; none where it finds errors in the program.
std::optional<TriMesh> mesh_of(const std::string& arguments) {
  const testing::TempFolder folder;
  const std::string out = folder.path("part.stl");
  const std::string command = "cd '" MRSIM_DATA_DIR "' && '" MRSIM_PROGRAM "' " + arguments +
                              " -q -o '" + out + "' 2>/dev/null";
  std::optional<TriMesh> mesh;
  if (std::system(command.c_str()) == 0) mesh = load_mesh(out);
  return mesh;
}

bool is_slow(const std::string& name) {
  return name == "CODESYS_3D.CNC" || name == "CODESYS_HELIX.CNC";
}

std::vector<std::string> programs(bool slow) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(MRSIM_DATA_DIR)) {
    const std::string end = entry.path().extension().string();
    const std::string name = entry.path().filename().string();
    if ((end == ".MPF" || end == ".NC" || end == ".CNC") && is_slow(name) == slow)
      names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string options_of(const std::string& name) {
  if (name == "PRIMER_2F.MPF") return " --stock block.stl";
  if (name == "PRIMER_2S.MPF") return " --stock bar.stl";
  const bool pocket = name.starts_with("FANUC_POCKET");
  return pocket ? " --stock box:-30,-30,-30,30,30,0 --tool 1=endmill:d=10"
                : " --machine mill --tool endmill:d=10";
}

class DataPrograms : public ::testing::TestWithParam<std::string> {};

TEST_P(DataPrograms, MeshDoesNotMeetItself) {
  const std::optional<TriMesh> mesh = mesh_of(GetParam() + options_of(GetParam()));
  if (!mesh) {  // printed with damage: only those may be refused
    ASSERT_NE(GetParam().find("verbatim"), std::string::npos);
    return;
  }
  const MeshSummary s = check_mesh(*mesh);
  EXPECT_TRUE(s.closed && s.oriented && s.manifold && s.degenerate == 0) << s.first_fault;
  EXPECT_EQ(self_intersections(*mesh), 0u);
}

std::string name_of(const ::testing::TestParamInfo<std::string>& at) {
  std::string name = at.param;
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return !std::isalnum(c); }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Data, DataPrograms, ::testing::ValuesIn(programs(false)), name_of);
INSTANTIATE_TEST_SUITE_P(SlowData, DataPrograms, ::testing::ValuesIn(programs(true)), name_of);

void expect_vertices_on_part(const char* voxel) {
  const std::optional<TriMesh> mesh =
      mesh_of(std::string("PRIMER_2F.MPF --stock block.stl --voxel ") + voxel);
  ASSERT_TRUE(mesh);
  const double most = largest_vertex_error(primer_2f(), *mesh);
  EXPECT_LE(most, 0.001) << "voxel " << voxel;
  ::testing::Test::RecordProperty("largest_error_mm", std::to_string(most));
}

TEST(Vertices, LieOnTheExactPartAtEveryVoxel) {
  for (const char* voxel : {"1", "0.5", "0.25"}) expect_vertices_on_part(voxel);
}

TEST(SlowVertices, LieOnTheExactPartAtATenth) { expect_vertices_on_part("0.1"); }

}  // namespace
}  // namespace mrsim
