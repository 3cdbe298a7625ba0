#include "core/output/draft_file.h"

#include "core/process/error.h"
#include "core/text/text_io.h"
#include "support/error_code.h"
#include "support/temp_folder.h"

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

namespace mrsim {
namespace {

namespace fs = std::filesystem;

class Drafts : public testing::TempFolderTest {
 protected:
  std::size_t files() const {
    return std::size_t(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }
};

TEST_F(Drafts, AppearWhole) {
  DraftFile draft(path("a"));
  draft.append("hello", 5);
  draft.finish();
  EXPECT_FALSE(fs::exists(path("a")));
  draft.publish();
  EXPECT_EQ(read_file(path("a")), "hello");
  EXPECT_EQ(files(), 1u);
}

TEST_F(Drafts, LeaveNothingWhenTheyAreGivenUp) {
  std::ofstream(path("a")) << "old";
  for (const bool finished : {false, true}) {
    DraftFile draft(path("a"));
    draft.append("new", 3);
    if (finished) draft.finish();
  }
  EXPECT_EQ(read_file(path("a")), "old");
  EXPECT_EQ(files(), 1u);
}

// A folder of `chattr +a` takes drafts that nobody can rename or remove again.
TEST_F(Drafts, AreRefusedWhereTheyCouldNotTakeTheirPlaces) {
  const auto change = [](const std::string& words) {
    return std::system(("chattr " + words + " 2>/dev/null").c_str()) == 0;
  };
  if (!change("+a " + folder_.string())) GTEST_SKIP() << "no attributes here";
  EXPECT_EQ(testing::error_code([&] { check_writable(path("a")); }), "output-unwritable");
  EXPECT_EQ(testing::error_code([&] { DraftFile draft(path("a")); }), "output-unwritable");
  ASSERT_TRUE(change("-a " + folder_.string()));
  EXPECT_EQ(files(), 0u);
  std::ofstream(path("a")) << "old";
  for (const std::string kind : {"i ", "a "}) {
    ASSERT_TRUE(change("+" + kind + path("a")));
    EXPECT_EQ(testing::error_code([&] { check_writable(path("a")); }), "output-unwritable");
    ASSERT_TRUE(change("-" + kind + path("a")));
  }
  check_writable(path("a"));
}

// Small pieces are collected, large ones are not; both keep their order.
TEST_F(Drafts, KeepTheOrderOfTheirPieces) {
  std::string whole;
  DraftFile draft(path("a"));
  for (const std::size_t size : {1u, 70000u, 10u, 65535u, 65536u, 3000000u, 5u, 20000000u, 7u}) {
    std::string piece(size, char('a' + whole.size() % 23));
    piece.back() = '\n';
    draft.append(piece.data(), piece.size());
    whole += piece;
  }
  draft.patch("head");
  whole.replace(0, 4, "head");
  draft.finish();
  draft.publish();
  EXPECT_TRUE(read_file(path("a")) == whole);
}

TEST_F(Drafts, BeginAnew) {
  DraftFile draft(path("a"));
  const std::string large(100000, 'x');
  draft.append(large.data(), large.size());
  draft.append("small", 5);
  draft.clear();
  draft.append("other", 5);
  draft.finish();
  draft.publish();
  EXPECT_EQ(read_file(path("a")), "other");
}

TEST_F(Drafts, KeepTheModeOfTheFileTheyReplace) {
  const auto mode = [&](const char* name) {
    struct stat info {};
    EXPECT_EQ(::stat(path(name).c_str(), &info), 0);
    return info.st_mode & 07777;
  };
  std::ofstream(path("a")) << "old";
  ::chmod(path("a").c_str(), 0640);
  const mode_t mask = ::umask(022);
  for (const char* name : {"a", "b"}) {
    DraftFile draft(path(name));
    draft.finish();
    draft.publish();
  }
  ::umask(mask);
  EXPECT_EQ(mode("a"), 0640u);
  EXPECT_EQ(mode("b"), 0644u);
}

// As on a full disk, a write comes back short and the next one fails.
TEST_F(Drafts, FailWhereThereIsNoRoom) {
  std::ofstream(path("a")) << "old";
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{100000, before.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  std::string code;
  try {
    DraftFile draft(path("a"));
    const std::string large(200000, 'x');
    draft.append(large.data(), large.size());
  } catch (const Error& error) {
    code = error.code();
  }
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(code, "output-unwritable");
  EXPECT_EQ(read_file(path("a")), "old");
  EXPECT_EQ(files(), 1u);
}

TEST_F(Drafts, AreRefusedWhereNoFileCanBe) {
  const auto code_at = [](const std::string& name) {
    return testing::error_code([&] { const DraftFile draft(name); });
  };
  EXPECT_EQ(code_at(path("no/such/folder")), "output-folder");
  EXPECT_EQ(code_at(folder_.string()), "output-unwritable");
}

}  // namespace
}  // namespace mrsim
