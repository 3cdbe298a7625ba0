// docs/words.md says what the tables say.
#include "interp/show/words_page.h"

#include <cstdlib>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

TEST(Words, ThePageIsThatOfTheTables) {
  const std::string path = std::string(MRSIM_DATA_DIR) + "/../docs/words.md";
  if (std::getenv("MRSIM_WRITE_WORDS") != nullptr) std::ofstream(path) << words_page();
  std::ostringstream page;
  page << std::ifstream(path).rdbuf();
  EXPECT_EQ(page.str(), words_page());
}

}  // namespace
}  // namespace mrsim
