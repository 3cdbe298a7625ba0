#include "core/text/text_io.h"

#include "support/error_code.h"
#include "support/temp_folder.h"

#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

#include <gtest/gtest.h>
#include <sys/stat.h>

namespace mrsim {
namespace {

namespace fs = std::filesystem;

class TextIo : public testing::TempFolderTest {};

TEST(ParseNumber, TakesWhatControlsTake) {
  EXPECT_EQ(parse_number("12"), 12.0);
  EXPECT_EQ(parse_number("+1.5"), 1.5);
  EXPECT_EQ(parse_number("-.5"), -0.5);
  EXPECT_EQ(parse_number("3."), 3.0);
  EXPECT_EQ(parse_number("1e3", true), 1000.0);
}

TEST(ParseNumber, RefusesTheRest) {
  for (const char* bad :
       {"", "-", ".", "--5", "+-5", "1.2.3", "1e3", "nan", "inf", " 1", "1 ", "0x10", "1,5"})
    EXPECT_FALSE(parse_number(bad)) << bad;
  EXPECT_FALSE(parse_number("1e999", true));
  EXPECT_FALSE(parse_number(std::string(400, '9')));
}

TEST_F(TextIo, WritesWholeFiles) {
  write_file_atomically(path("a"), [](const ByteSink& out) { out("hello", 5); });
  EXPECT_EQ(read_file(path("a")), "hello");
}

TEST_F(TextIo, KeepsOldFileWhenWriterFails) {
  write_file_atomically(path("a"), [](const ByteSink& out) { out("old", 3); });
  EXPECT_THROW(write_file_atomically(path("a"),
                                     [](const ByteSink& out) {
                                       out("new", 3);
                                       throw std::runtime_error("no");
                                     }),
               std::runtime_error);
  EXPECT_EQ(read_file(path("a")), "old");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
}

TEST_F(TextIo, WritesAllFilesOrNone) {
  const auto good = [](const ByteSink& out) { out("new", 3); };
  const auto bad = [](const ByteSink&) { throw std::runtime_error("no"); };
  const std::vector<OutputFile> broken = {{path("a"), good}, {path("b"), bad}};
  EXPECT_THROW(write_files_atomically(broken), std::runtime_error);
  EXPECT_TRUE(fs::is_empty(folder_));
  const std::vector<OutputFile> whole = {{path("a"), good}, {path("b"), good}};
  write_files_atomically(whole);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 2);
}

TEST_F(TextIo, NamesWhatIsWrong) {
  EXPECT_EQ(testing::error_code([&] { read_file(path("missing")); }), "file-missing");
  EXPECT_EQ(testing::error_code([&] { read_file(folder_.string()); }), "file-is-directory");
  EXPECT_EQ(testing::error_code([&] { check_writable(path("no/such/folder")); }), "output-folder");
  EXPECT_EQ(testing::error_code([&] { check_writable(folder_.string()); }), "output-unwritable");
  std::ofstream(path("big")) << std::string(100, 'x');
  EXPECT_EQ(testing::error_code([&] { read_file(path("big"), 99); }), "file-too-large");
}

// A second reading would wait for a writer for ever.
TEST_F(TextIo, ReadsAPipeAgainOnlyWhereItIsFilledAgain) {
  const std::string pipe = path("pipe");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  for (const char* text : {"one", "two"}) {
    std::thread writer([&] { std::ofstream(pipe) << text; });
    std::this_thread::sleep_for(std::chrono::milliseconds(100));  // until it waits for a reader
    EXPECT_EQ(read_file(pipe), text);
    writer.join();
  }
  EXPECT_EQ(testing::error_code([&] { read_file(pipe); }), "file-read-once");
}

TEST(XmlEscaped, LeavesNoMarkupAndNoControlCharacters) {
  EXPECT_EQ(xml_escaped("a<b> & \"c\"\n\t\x01"), "a&lt;b&gt; &amp; &quot;c&quot;\n\t ");
}

TEST(Utf8, KeepsUtf8AndReadsLatin2) {
  EXPECT_EQ(to_utf8("Steblasto frezalo \xC3\x98"
                    "5"),
            "Steblasto frezalo \xC3\x98"
            "5");
  EXPECT_EQ(to_utf8("No\xBE"), "No\xC5\xBE");          // zcaron
  EXPECT_EQ(to_utf8("\xC0\x80"), "\xC5\x94\xC2\x80");  // overlong: not UTF-8
}

}  // namespace
}  // namespace mrsim
