// STEP files written by Open CASCADE itself, read and measured against closed forms.
#ifdef MRSIM_HAS_STEP

#include "core/numbers/units.h"
#include "core/text/text_io.h"
#include "mesh/solid/half_edges.h"
#include "support/mesh_asserts.h"
#include "support/temp_folder.h"
#include <mrsim/solid_files.h>

#include <cmath>
#include <functional>
#include <regex>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Writer.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Ax2.hxx>
#include <gp_Pln.hxx>
#include <gtest/gtest.h>

namespace mrsim {
namespace {

std::string write_step(const TopoDS_Shape& shape, const char* name, const char* unit = "MM") {
  static const testing::TempFolder folder;
  const std::string path = folder.path(name);
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
}

TEST(ReadStep, ConvertsUnits) {
  const std::string path = write_step(drilled_block(), "inch.step", "INCH");
  const MeshSummary s = check_mesh(read_step(path, 0.01));
  EXPECT_NEAR(s.bounds.hi.x, 60 * 25.4, 1e-3);  // the writer labels its numbers, and no more
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
}

// Open CASCADE leaves out what refers to no entity, or puts another one there. Curves in the
// parameters of a face are among it, which no shape needs.
TEST(ReadStep, RefusesReferencesToNothing) {
  const std::string path = write_step(drilled_block(), "block.step");
  const std::string bytes = read_file(path);
  for (const char* entity : {"PCURVE('',#", "EDGE_CURVE('',#", "PRODUCT_RELATED"}) {
    const std::size_t at = bytes.find('#', bytes.find(entity)) + 1;
    ASSERT_LT(at, bytes.size()) << entity;
    const std::size_t end = bytes.find_first_not_of("0123456789", at);
    for (const std::string to : {"99999999999999999999", "18446744073709551621", "999999", "0",
                                 "-1", "", "ABC", " 5", "5x", "5.5"}) {
      const std::string text = bytes.substr(0, at) + to + bytes.substr(end);
      write_file_atomically(path, [&](const ByteSink& out) { out(text.data(), text.size()); });
      EXPECT_EQ(testing::error_code([&] { read_step(path); }), "step-unreadable") << entity << to;
    }
  }
}

// A prism of 15 mm over a closed spline, and a polygon of points on that.
struct SplinePrism {
  TopoDS_Shape solid;
  std::vector<gp_Pnt> outline;
};

SplinePrism spline_prism() {
  TColgp_Array1OfPnt poles(1, 5);
  const double places[5][2] = {{0, -4}, {34, 4}, {34, 28}, {6, 32}, {-6, 10}};
  for (int i = 0; i < 5; ++i) poles(i + 1) = gp_Pnt(places[i][0], places[i][1], 0);
  TColStd_Array1OfReal knots(1, 6);
  TColStd_Array1OfInteger times(1, 6);
  for (int i = 1; i <= 6; ++i) knots(i) = i, times(i) = 1;
  const Handle(Geom_BSplineCurve) curve = new Geom_BSplineCurve(poles, knots, times, 3, true);
  SplinePrism out;
  for (int i = 0; i < 1000; ++i) out.outline.push_back(curve->Value(1 + 5.0 * i / 1000));
  const TopoDS_Wire wire = BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(curve).Edge()).Wire();
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(wire).Face();
  out.solid = BRepPrimAPI_MakePrism(face, gp_Vec(0, 0, 15)).Shape();
  return out;
}

// The largest distance of the middles of the triangles' sides from `distance`'s zero.
double farthest(const TriMesh& mesh, const std::function<double(const Vec3&)>& distance) {
  double worst = 0;
  for (const auto& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 a = to_vec(mesh.vertices[t[i]]), b = to_vec(mesh.vertices[t[(i + 1) % 3]]);
      worst = std::max(worst, std::abs(distance(0.5 * (a + b))));
    }
  return worst;
}

TEST(ReadStep, IsAsNearAsItSays) {
  const SplinePrism prism = spline_prism();
  const std::string path = write_step(prism.solid, "prism.step");
  const auto beside = [&](const Vec3& p) {
    if (p.z < 1e-6 || p.z > 15 - 1e-6) return 0.0;
    double least = 1e9;
    for (const gp_Pnt& q : prism.outline)
      least = std::min(least, std::hypot(q.X() - p.x, q.Y() - p.y));
    return least;
  };
  const double spacing = 0.07;  // from points of the outline, at most
  const TriMesh mesh = read_step(path, 0.02);
  testing::expect_closed_manifold(mesh);
  EXPECT_LE(farthest(mesh, beside), std::hypot(0.02, spacing));
  EXPECT_LE(mesh.triangles.size(), 2000u);  // none where the prism is straight

  const std::string ball = write_step(BRepPrimAPI_MakeSphere(12).Shape(), "ball.step");
  EXPECT_LE(farthest(read_step(ball, 0.002),
                     [](const Vec3& p) { return std::hypot(p.x, p.y, p.z) - 12; }),
            0.002);
}

TopoDS_Compound together(const TopoDS_Shape& a, const TopoDS_Shape& b) {
  TopoDS_Compound out;
  const BRep_Builder builder;
  builder.MakeCompound(out);
  builder.Add(out, a);
  builder.Add(out, b);
  return out;
}

TEST(ReadStep, ReadsEverySolidOrNone) {
  const TopoDS_Shape a = BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), gp_Pnt(10, 10, 10)).Shape();
  const TopoDS_Shape b = BRepPrimAPI_MakeBox(gp_Pnt(20, 0, 0), gp_Pnt(30, 10, 10)).Shape();
  const std::string path = write_step(together(a, b), "two.step");
  EXPECT_NEAR(check_mesh(read_step(path)).volume, 2000, 1e-3);
  const std::string bytes = read_file(path);
  const auto changed = [&](const std::regex& what, const char* to) {
    const std::string text =
        std::regex_replace(bytes, what, to, std::regex_constants::format_first_only);
    EXPECT_NE(text, bytes);
    write_file_atomically(path, [&](const ByteSink& out) { out(text.data(), text.size()); });
    return testing::error_code([&] { read_step(path); });
  };
  // A shell without one of its faces, of a kind that is not known, and of what is not there.
  EXPECT_EQ(changed(std::regex(R"((CLOSED_SHELL\('',\()#\d+,)"), "$1"), "step-incomplete");
  EXPECT_EQ(changed(std::regex("CLOSED_SHELL"), "CLOSED_SHEL"), "step-incomplete");
  EXPECT_EQ(changed(std::regex(R"((MANIFOLD_SOLID_BREP\('',)#\d+)"), "$1#99999"),
            "step-unreadable");
  EXPECT_EQ(changed(std::regex("DATA;"), "DATA; /* #99999 */"), "");  // a comment names nothing
}

TEST(ReadStep, SaysWhatBoundsNoSolid) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), gp_Pnt(10, 10, 10)).Shape();
  const TopoDS_Shape sheet =
      BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(0, 0, 20), gp_Dir(0, 0, 1)), 0, 10, 0, 10).Shape();
  const std::string path = write_step(together(box, sheet), "sheet.step");
  std::string note;
  EXPECT_NEAR(check_mesh(read_step(path, 0.001, &note)).volume, 1000, 1e-3);
  EXPECT_NE(note.find("12 triangles within 0.001 mm of the exact faces; 1 face that bounds no "
                      "solid left out"),
            note.npos)
      << note;
}

}  // namespace
}  // namespace mrsim

#endif
