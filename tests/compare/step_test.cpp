// STEP files written by Open CASCADE itself, read and measured against closed forms.
#ifdef MRSIM_HAS_STEP

#include "core/text_io.h"
#include "core/units.h"
#include "support/mesh_asserts.h"
#include <mrsim/solid_files.h>

#include <cstdio>
#include <filesystem>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Writer.hxx>
#include <gp_Ax2.hxx>
#include <gp_Pln.hxx>
#include <gtest/gtest.h>

namespace mrsim {
namespace {

std::string write_step(const TopoDS_Shape& shape, const char* name, const char* unit = "MM") {
  const std::string path =
      (std::filesystem::temp_directory_path() / (std::string("mrsim_step_test_") + name)).string();
  STEPControl_Writer writer;
  Interface_Static::SetCVal("write.step.unit", unit);
  writer.Transfer(shape, STEPControl_AsIs);
  writer.Write(path.c_str());
  return path;
}

TopoDS_Shape drilled_block() {
  const TopoDS_Shape block = BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), gp_Pnt(60, 40, 10)).Shape();
  const TopoDS_Shape drill =
      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(30, 20, -1), gp_Dir(0, 0, 1)), 8, 12).Shape();
  return BRepAlgoAPI_Cut(block, drill).Shape();
}

TEST(ReadStep, IsClosedAndWithinTheDeflection) {
  const std::string path = write_step(drilled_block(), "block.step");
  const double exact = 60 * 40 * 10 - kPi * 64 * 10;
  for (const double deflection : {0.05, 0.001}) {
    const TriMesh mesh = read_step(path, deflection);
    testing::expect_closed_manifold(mesh);
    const double excess = check_mesh(mesh).volume - exact;  // chords cut into the hole
    EXPECT_GE(excess, 0);
    EXPECT_LE(excess, deflection * 2 * kPi * 8 * 10);
  }
  std::remove(path.c_str());
}

TEST(ReadStep, ConvertsUnits) {
  const std::string path = write_step(drilled_block(), "inch.step", "INCH");
  const MeshSummary s = check_mesh(read_step(path, 0.01));
  EXPECT_NEAR(s.bounds.hi.x, 60 * 25.4, 1e-3);  // the writer labels its numbers, and no more
  std::remove(path.c_str());
}

TEST(ReadStep, SaysWhatIsWrong) {
  const std::string face =
      write_step(BRepBuilderAPI_MakeFace(gp_Pln(), 0, 10, 0, 10).Face(), "face.step");
  EXPECT_EQ(testing::error_code([&] { read_step(face); }), "step-no-solid");
  std::string bytes = read_file(face);
  const auto damaged = [&](const std::string& text) {
    write_file_atomically(face, [&](const ByteSink& out) { out(text.data(), text.size()); });
    return testing::error_code([&] { read_step(face); });
  };
  EXPECT_EQ(damaged("solid no step"), "step-unreadable");
  EXPECT_NE(damaged(bytes.substr(0, bytes.size() / 2)), "");
  EXPECT_NE(damaged("ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\n#1=CARTESIAN_POINT('',(1.E999,"), "");
  EXPECT_EQ(testing::error_code([&] { read_step("/nonexistent.step"); }), "file-missing");
  std::remove(face.c_str());
}

}  // namespace
}  // namespace mrsim

#endif
