// The modules that are opened when they are needed, and what is said where they are not as they
// should be.
#include "run_program.h"

namespace mrsim {
namespace {

using namespace mrsim::testing;

class Modules : public CliTest {
 protected:
  // A library elsewhere that finds its module, if it is there and is one.
  void expect_beside_the_library(const std::string& name, const std::string& arguments,
                                 const std::string& code) {
    const std::filesystem::path library = kLibrary, moved = folder_ / "moved";
    const std::filesystem::path module = moved / "mrsim" / (name + ".so");
    std::filesystem::create_directories(moved / "mrsim");
    std::filesystem::copy(library, moved / "libmrsim.so.0");
    const std::string there = "LD_LIBRARY_PATH='" + moved.string() + "'";
    const auto says = [&](const std::string& text) {
      const Outcome o = run(arguments, there);
      EXPECT_EQ(o.code, 1) << o.err;
      EXPECT_NE(o.err.find(code), std::string::npos) << o.err;
      EXPECT_NE(o.err.find(text), std::string::npos) << o.err;
    };
    says("moved/mrsim/" + name + ".so");
    write("moved/mrsim/" + name + ".so", "no module");
    says("moved/mrsim/" + name + ".so");
    std::filesystem::remove(module);
    std::filesystem::create_symlink(moved / "libmrsim.so.0", module);
    says("another version");
    std::filesystem::remove(module);
    std::filesystem::copy(library.parent_path() / "mrsim" / (name + ".so"), module);
    EXPECT_EQ(run(arguments, there).err.find(code), std::string::npos);
  }
};

TEST_F(Modules, WriteVdbBesideTheLibrary) {
  expect_beside_the_library("vdb", "PRIMER_2F.MPF --stock block.stl -q -o part.vdb", "vdb-module");
  EXPECT_TRUE(exists("part.vdb"));
}

#ifdef MRSIM_HAS_STEP
TEST_F(Modules, ReadStepBesideTheLibrary) {
  write("a.step", "ISO-10303-21;");
  expect_beside_the_library("step", "compare a.step block.stl", "step-module");
}
#endif

TEST_F(Modules, AreNotOpenedByOtherRuns) {
  const Outcome o = run("--version", "LD_TRACE_LOADED_OBJECTS=1");
  EXPECT_NE(o.out.find("libmrsim"), std::string::npos) << o.out;
  EXPECT_EQ(o.out.find("libTK"), std::string::npos) << o.out;
  EXPECT_EQ(o.out.find("libopenvdb"), std::string::npos) << o.out;
}

}  // namespace
}  // namespace mrsim
