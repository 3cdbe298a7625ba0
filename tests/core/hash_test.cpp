#include "core/numbers/hash.h"

#include <algorithm>
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

std::string hash_of(const std::string& text) {
  Sha256 hash;
  hash.update(text.data(), text.size());
  return hash.hex();
}

// FIPS 180-4's own examples.
TEST(Sha256, GivesTheDigestsOfTheStandard) {
  EXPECT_EQ(hash_of(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(hash_of("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(hash_of("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(hash_of(std::string(1000000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, DoesNotDependOnThePieces) {
  std::string text;
  for (int i = 0; i < 1000; ++i) text += char(i * 7);
  for (const std::size_t step : {1u, 3u, 63u, 64u, 65u, 200u}) {
    Sha256 hash;
    for (std::size_t i = 0; i < text.size(); i += step)
      hash.update(text.data() + i, std::min(step, text.size() - i));
    EXPECT_EQ(hash.hex(), hash_of(text)) << step;
  }
}

}  // namespace
}  // namespace mrsim
