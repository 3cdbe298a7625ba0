// Files that are no programs, and what stands around a program in a file.
#include "interp/support.h"

namespace mrsim {
namespace {

using namespace mrsim::testing;

TEST(FileKind, TextBehindTheTapeIsNamed) {
  const auto notes = [](const char* text) {
    return codes(read_text(text, at_origin(Dialect::fanuc)), Severity::note);
  };
  EXPECT_EQ(notes("%\nO1\nG1 X1. F1\n%\nG1 X2.\n"), "tape-end");
  EXPECT_EQ(notes("%\nO1\nG1 X1. F1\n%\n\n%\n"), "");
  EXPECT_EQ(codes(read_text("%\nO1\nG1 X1. F1\n% a comment\nG1 X2.\n", at_origin(Dialect::fanuc))),
            "tape-end")
      << "a warning: cuts may be lost";
  EXPECT_EQ(path_text(read_text("G1 X1 F1\n%wait\nG1 X2\nM2\n", at_origin(Dialect::ngc))),
            "l1,0,0 l2,0,0")
      << "of CNCjs";
  const Program sender = read_text(
      "%\nG1 X1 F1\n% vfd enable\nM62 P0\n%( end )\no1 sub\nG1 X2\no1 endsub\no1 call\n%\nG1 X3\n",
      at_origin(Dialect::ngc));
  EXPECT_EQ(path_text(sender), "l1,0,0 l2,0,0 | sender-line") << "lines for senders";
  EXPECT_EQ(codes(sender, Severity::note), "sender-line tape-end");
  EXPECT_EQ(notes("%\nO1\nG1 X1. F1\nM30\n%\nlisting\n"), "");
  EXPECT_EQ(codes(read_text("% A\nG1 X1 F1\nSUBPROGRAM B{}\nG1 X2\nEND_SUBPROGRAM\n",
                            at_origin(Dialect::codesys)),
                  Severity::note),
            "");
}

// A part given in the place of the program is one error, not one for each of its characters.
TEST(FileKind, FilesOfOtherKindsAreNoPrograms) {
  using namespace std::string_literals;
  TempFolder scratch;
  const std::string header(80, 'x'), triangle(50, '\0');
  const std::pair<std::string, const char*> kinds[] = {
      {header + "\x02\0\0\0"s + triangle + triangle, "STL"},
      {"solid a\nfacet normal 0 0 1\n", "STL"},
      {"\x20\x42\x44\x56\0\0\0\0\xE0"s, "OpenVDB"},
      {"\x89PNG\r\n", "PNG"},
      {"%PDF-1.4\n", "PDF"},
      {"PK\x03\x04", "ZIP"},
      {"ISO-10303-21;\n", "STEP"},
      {"ply\nformat ascii 1.0\n", "PLY"},
      {" {\n \"kind\": 1}", "JSON"},
      {"  0\r\nSECTION\r\n", "DXF"}};
  for (const auto& [text, name] : kinds) try {
      read_program(scratch.write("part.nc", text), at_origin(Dialect::automatic));
      ADD_FAILURE() << name;
    } catch (const Error& e) {
      EXPECT_EQ(e.code(), "file-not-program") << name;
      EXPECT_NE(std::string(e.what()).find(name), std::string::npos) << e.what();
    }
  for (const char* program : {"%\nO1\nG1 X1\n", "<PART>\nG1 X1\n", "[remark]\nG1 X1\n",
                              "0\nG1 X1\n", "(solid)\nG1 X1\n", "", "{1}\n"})
    try {
      read_program(scratch.write("a.nc", program), at_origin(Dialect::fanuc));
    } catch (const Error& e) {
      EXPECT_NE(e.code(), "file-not-program") << program;
    }
}

// The leader of a tape, and what a serial line starts and stops a transfer with.
TEST(FileKind, SignsOfTransfersAreNoText) {
  const std::string nul(3, '\0');
  const std::string text = nul + "\x12%\nO1\nG1 X5. F9\n\fX6.\x13\n\x7F\x7FX7.\nM30\n%\n\x14" + nul;
  EXPECT_EQ(path_text(read_text(text, at_origin(Dialect::fanuc))), "l5,0,0 l6,0,0 l7,0,0");
  const std::string inside = "G1 X" + nul + "5. F9\n";
  EXPECT_NE(codes(read_text(inside, at_origin(Dialect::fanuc))).find("character"),
            std::string::npos);
}

}  // namespace
}  // namespace mrsim
