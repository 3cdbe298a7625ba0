#include "core/output/scratch_file.h"

#include "support/error_code.h"
#include "support/temp_folder.h"

#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <stdlib.h>

namespace mrsim {
namespace {

class ScratchFileTest : public testing::TempFolderTest {};

TEST_F(ScratchFileTest, HasNoNameAndOutlivesItsFolder) {
  ScratchFile file(folder_.string());
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
  file.append("abc", 3);
  std::filesystem::remove_all(folder_);
  file.append("defg", 4);
  EXPECT_EQ(file.size(), 7u);
  char read[4];
  file.read(2, read, 4);
  EXPECT_EQ(std::string(read, 4), "cdef");
}

TEST_F(ScratchFileTest, BeginsAnew) {
  ScratchFile file(folder_.string());
  file.append("abcdef", 6);
  file.clear();
  EXPECT_EQ(file.size(), 0u);
  file.append("xy", 2);
  char read[2];
  file.read(0, read, 2);
  EXPECT_EQ(std::string(read, 2), "xy");
}

TEST_F(ScratchFileTest, FaultsHaveACode) {
  EXPECT_EQ(testing::error_code([&] { const ScratchFile file(path("none")); }),
            "output-unwritable");
  ScratchFile file(folder_.string());
  file.append("abc", 3);
  char read[4];
  EXPECT_EQ(testing::error_code([&] { file.read(0, read, 4); }), "output-unwritable");  // cut short
}

}  // namespace
}  // namespace mrsim
