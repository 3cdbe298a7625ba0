// STEP files and .vdb as stock, nominal and part; without Open CASCADE, what is said of STEP.
#include "run_program.h"
#include "support/rounds.h"

#include <cstdint>

#include <nlohmann/json.hpp>

#ifdef MRSIM_HAS_STEP
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Writer.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Ax2.hxx>
#include <gp_Pln.hxx>
#endif

namespace mrsim {
namespace {

using namespace mrsim::testing;

class SolidFiles : public NominalTest {
 protected:
  nlohmann::json json(const std::string& name) {
    return nlohmann::json::parse(read(name), nullptr, false);
  }
};

#ifdef MRSIM_HAS_STEP

class StepFiles : public SolidFiles {
 protected:
  void write_step(const TopoDS_Shape& shape, const std::string& name, const char* unit = "MM") {
    STEPControl_Writer writer;
    Interface_Static::SetCVal("write.step.unit", unit);
    writer.Transfer(shape, STEPControl_AsIs);
    writer.Write((folder_ / name).c_str());
  }
  static TopoDS_Shape box(double x0, double y0, double z0, double x1, double y1, double z1) {
    return BRepPrimAPI_MakeBox(gp_Pnt(x0, y0, z0), gp_Pnt(x1, y1, z1)).Shape();
  }
  static TopoDS_Shape bar(double diameter, double length) {
    return BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), diameter / 2, length)
        .Shape();
  }
};

TEST_F(StepFiles, BoxIsTheStockOfTheMesh) {
  write_step(box(0, -60, 0, 100, 0, 10), "block.step");
  ASSERT_EQ(run("PRIMER_2F.MPF --stock block.stl -q -o mesh.stl").code, 0);
  const Outcome o = run("PRIMER_2F.MPF --stock block.step -o step.stl");
  ASSERT_EQ(o.code, 0) << o.err;
  EXPECT_EQ(read("step.stl").substr(84), read("mesh.stl").substr(84));
}

TEST_F(StepFiles, CylinderIsTurnedAndCompared) {
  write_step(bar(50, 51), "bar.STP");
  const Outcome o =
      run("PRIMER_2S.MPF --stock bar.STP -o part.ply --nominal PRIMER_2S.nominal.stl --accept 0.02 "
          "--json r.json");
  EXPECT_EQ(o.code, 0) << o.out << o.err;
  EXPECT_LE(json("r.json")["part_to_nominal"]["rms"], 0.003);
}

TEST_F(StepFiles, AnyShapeIsAStock) {
  // A block with a bore: no primitive, the surface is cut as it was tessellated.
  const TopoDS_Shape drilled = BRepAlgoAPI_Cut(
      box(0, -60, 0, 100, 0, 10),
      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(90, -50, -1), gp_Dir(0, 0, 1)), 5, 12).Shape());
  write_step(drilled, "drilled.step");
  const Outcome o = run("PRIMER_2F.MPF --stock drilled.step -o part.stl");
  ASSERT_EQ(o.code, 0) << o.err;
  const Outcome c = run("compare part.stl PRIMER_2F.nominal.stl --json r.json -q");
  ASSERT_EQ(c.code, 0) << c.err;
  const double bore = 3.14159265358979 * 25 * 10;
  EXPECT_NEAR(json("r.json")["volume"]["part"].get<double>(), 58782.632 - bore, 3);
}

TEST_F(StepFiles, AreNominalAndPart) {
  write_step(box(0, 0, 0, 30, 20, 10), "nominal.step");
  write_step(box(0, 0, 0, 30, 20, 10.05), "part.step");
  const Outcome o = run("compare part.step nominal.step --accept 0.02 --json r.json");
  EXPECT_EQ(o.code, 4) << o.err;
  for (const char* said : {"nominal.step: 12 triangles within 0.001 mm of the exact faces",
                           "part.step: 12 triangles within 0.001 mm of the exact faces"})
    EXPECT_NE(o.err.find(said), std::string::npos) << o.err;
  EXPECT_NEAR(json("r.json")["part_to_nominal"]["max"].get<double>(), 0.05, 1e-5);
}

TEST_F(StepFiles, BadOnesLeaveNothing) {
  write_step(BRepBuilderAPI_MakeFace(gp_Pln(), 0, 10, 0, 10).Face(), "face.step");
  write_step(box(0, -60, 0, 100, 0, 10), "inch.step", "INCH");
  write("text.step", "solid no step");
  const auto fails = [&](const std::string& arguments, const std::string& text) {
    expect_failure(arguments + " --report r.html", 1, text);
    EXPECT_FALSE(exists("r.html"));
  };
  const std::string cut = "PRIMER_2F.MPF -o part.stl --stock ";
  fails("compare block.stl face.step", "no solid");
  fails(cut + "face.step", "no solid");
  fails(cut + "block.stl --nominal face.step", "no solid");
  fails(cut + "text.step", "STEP");
  fails("compare block.stl inch.step", "25.4");
  fails(cut + "block.stl --nominal inch.step", "25.4");
}

// Read in a process of its own, which has what the limit leaves.
TEST_F(StepFiles, KeepToTheMemoryOfTheRun) {
  BRep_Builder builder;
  TopoDS_Compound balls;
  builder.MakeCompound(balls);
  for (int i = 0; i < 16; ++i)
    builder.Add(balls, BRepPrimAPI_MakeSphere(gp_Pnt(20 * i, 0, 0), 9).Shape());
  write_step(balls, "balls.step");
  expect_failure("compare block.stl balls.step --max-memory 30M", 1, "reading balls.step takes");
  EXPECT_EQ(run("compare block.stl balls.step --deflection 0.5 -q").code, 0);
}

// Open CASCADE crashes on some of them, in a process of its own.
TEST_F(StepFiles, DamagedOnesAreErrors) {
  write_step(bar(50, 51), "whole.step");
  const std::string whole = read("whole.step");
  const std::size_t data = whole.find("DATA;");
  ASSERT_NE(data, std::string::npos);
  std::uint32_t state = 1;
  const auto random = [&](std::size_t below) {
    state = state * 1664525u + 1013904223u;
    return std::size_t(state >> 8) % below;
  };
  unsigned errors = 0;
  for (unsigned k = 0; k < testing::rounds(25); ++k) {
    std::string text = whole;
    const std::size_t at = data + random(whole.size() - data - 100), reference = text.find('#', at),
                      number = text.find_first_of("0123456789", at);
    if (k % 5 == 0) text.replace(reference + 1, 1, "99999999999999999999");
    if (k % 5 == 1) text.erase(at, 1 + random(60));
    if (k % 5 == 2) text.resize(at);
    if (k % 5 == 3) text.replace(number, 1, "1.E999");
    if (k % 5 == 4) text[at] = static_cast<char>(random(256));
    write("mutant.step", text);
    const Outcome o = run("compare mutant.step bar.stl --threads 1");
    EXPECT_TRUE(o.code == 0 || o.code == 1) << k << ": " << o.code << "\n" << o.err;
    EXPECT_EQ(o.code == 1, contains(o.err, "error: ")) << k << "\n" << o.err;
    errors += o.code == 1;
  }
  EXPECT_GT(errors, testing::rounds(25) / 4);  // the others are still files of a solid
}

TEST_F(StepFiles, VerticesAtInfinityAreErrors) {
  write_step(bar(50, 51), "far.step");
  std::string text = read("far.step");
  const std::size_t vertex = text.find("VERTEX_POINT('',#") + 17;
  const std::size_t point =
      text.find("\n#" + std::to_string(std::stoi(text.substr(vertex))) + " =");
  ASSERT_NE(point, std::string::npos);
  const std::size_t first = text.find(",(", point) + 2;
  text.replace(first, text.find(',', first) - first, "1.E123456789");
  write("far.step", text);
  expect_failure("compare far.step bar.stl", 1, "[step-too-far]");
}

#else

TEST_F(SolidFiles, IsSaidToBeMissing) {
  write("a.step", "ISO-10303-21;");
  for (const char* arguments :
       {"compare block.stl a.step", "compare a.step block.stl",
        "PRIMER_2F.MPF --stock a.step -o part.stl", "render a.step -o a.png",
        "PRIMER_2F.MPF --stock block.stl --nominal a.step -o part.stl"})
    expect_failure(arguments, 1, "built without Open CASCADE");
}

#endif

TEST_F(SolidFiles, VdbPartKnowsItsLines) {
  std::string program = read("PRIMER_2F.MPF");
  program.replace(program.find("N40 G2"), 6, "N40 G3");
  write("BAD.MPF", program);
  ASSERT_EQ(run("BAD.MPF --stock block.stl -q -o part.vdb").code, 0);
  const Outcome o =
      run("compare part.vdb PRIMER_2F.nominal.stl --accept 0.02 --json r.json --report r.html");
  EXPECT_EQ(o.code, 4) << o.err;
  EXPECT_EQ(o.err.find("no lines are named"), std::string::npos);
  EXPECT_NE(o.err.find("part.vdb: meshed with its voxel of 0.25 mm"), std::string::npos) << o.err;
  bool named = false;
  const nlohmann::json result = json("r.json");
  for (const auto& region : result["regions"])
    named = named || (region["kind"] == "gouge" && region["lines"][0]["line"] == 8 &&
                      region["lines"][0]["text"] == "N40 G3 X7.5 Y0 CR=7.5");
  EXPECT_TRUE(named);
  EXPECT_TRUE(exists("r.html"));
  write("bad.vdb", read("part.vdb").substr(0, 500));
  expect_failure("compare bad.vdb PRIMER_2F.nominal.stl --json r2.json", 1, "bad.vdb");
  EXPECT_EQ(json("r2.json")["error"]["code"], "vdb-damaged");
}

// `bytes` as another program would write them again: no seal at the end, another identifier.
std::string written_again(std::string bytes) {
  bytes.resize(bytes.size() - 16);
  bytes[30] = bytes[30] == 'a' ? 'b' : 'a';
  return bytes;
}

std::string replaced(std::string bytes, const std::string& word, const std::string& by) {
  return bytes.replace(bytes.find(word), by.size(), by);
}

TEST_F(SolidFiles, VdbThatWasWrittenAgainIsStillTheStock) {
  const std::string rest = "PRIMER_2F.MPF --stock block.stl --voxel 2 -q -o ";
  ASSERT_EQ(run(rest + "part.vdb").code, 0);
  write("again.vdb", written_again(read("part.vdb")));
  for (const char* name : {"part", "again"})
    ASSERT_EQ(
        run(std::string("PRIMER_2F.MPF --stock ") + name + ".vdb --voxel 2 -q -o " + name + ".stl")
            .code,
        0);
  EXPECT_EQ(read("part.stl"), read("again.stl"));
}

TEST_F(SolidFiles, VdbOfAnotherProgramIsAStockAndAPart) {
  ASSERT_EQ(run("PRIMER_2F.MPF --stock block.stl --voxel 2 -q -o part.vdb").code, 0);
  const std::string again = written_again(read("part.vdb"));
  write("other.vdb", replaced(again, "mrsim:recipe", "houdi:recipe"));
  write("changed.vdb", replaced(again, "mrsim:voxels\x06", "mrsim:vOxels\x06"));
  for (const char* name : {"other", "changed"}) {
    const Outcome o = run(std::string("PRIMER_2F.MPF --stock ") + name + ".vdb --voxel 2 -o b.stl");
    EXPECT_EQ(o.code, 0) << o.err;
    EXPECT_TRUE(contains(o.err, "voxels are 2 mm")) << o.err;
    EXPECT_TRUE(contains(o.err, "[stock-of-voxels]")) << o.err;
    EXPECT_EQ(contains(o.err, "another program has changed"), name == std::string("changed"));
    EXPECT_TRUE(contains(o.out, "mesh of")) << o.out;
  }
  const Outcome compared = run("compare other.vdb block.stl --accept 10 --json r.json");
  EXPECT_TRUE(contains(compared.err, "voxels are 2 mm")) << compared.err;
  write("damaged.vdb", replaced(again, "mrsim:recipe", "houdi:recipe").substr(0, again.size() / 2));
  expect_failure("PRIMER_2F.MPF --stock damaged.vdb -o part.stl", 1, "vdb-unreadable");
}

// A measured grid's volume is corrected, and so must be that of the stock, which is meshed alike.
TEST_F(SolidFiles, VolumeOfAVdbStockIsMeasuredAsThePartIs) {
  ASSERT_EQ(run("PRIMER_2F.MPF --stock block.stl --voxel 0.5 -o part.vdb").code, 0);
  write("beside.MPF", "G17 G90 G71\nT1 M6\nS3000 M3\nG0 X-100 Y-90 Z5\nG1 X-90 F500\nG0 Z9\nM30\n");
  const Outcome outcome =
      run("beside.MPF --machine mill --stock part.vdb --tool 1=endmill:d=4 --voxel 0.5 "
          "--nominal PRIMER_2F.nominal.stl --accept 0.1 -o same.stl");
  EXPECT_NE(number_after(outcome.out, "the mesh"), number_after(outcome.out, "volume"));
  EXPECT_NEAR(number_after(outcome.out, "removed"), 0, 1e-3) << outcome.out << outcome.err;
}

}  // namespace
}  // namespace mrsim
