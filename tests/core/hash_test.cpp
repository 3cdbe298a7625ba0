#include "core/numbers/hash.h"

#include <set>
#include <string>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

std::uint64_t of(const std::string& text) {
  ContentHash hash;
  hash.update(text.data(), text.size());
  return hash.digest();
}

TEST(ContentHash, DoesNotDependOnPieces) {
  const std::string text = "The quick brown fox jumps over the lazy dog";
  for (std::size_t cut = 0; cut <= text.size(); ++cut) {
    ContentHash hash;
    hash.update(text.data(), cut);
    hash.update(text.data() + cut, text.size() - cut);
    EXPECT_EQ(hash.digest(), of(text));
  }
}

TEST(ContentHash, TellsApart) {
  std::set<std::uint64_t> seen;
  for (int i = 0; i < 10000; ++i) seen.insert(of("stock " + std::to_string(i)));
  for (std::size_t zeros = 0; zeros < 32; ++zeros) seen.insert(of(std::string(zeros, '\0')));
  EXPECT_EQ(seen.size(), 10032u);
}

TEST(ContentHash, UuidHasTheForm) {
  const std::string uuid = ContentHash().uuid();
  ASSERT_EQ(uuid.size(), 36u);
  EXPECT_EQ(uuid[14], '8');
  EXPECT_NE(uuid.substr(0, 8), "00000000");
  EXPECT_EQ(uuid, ContentHash().uuid());
}

}  // namespace
}  // namespace mrsim
