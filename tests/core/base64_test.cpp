#include "core/text/base64.h"

#include <string>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

TEST(Base64, IsThatOfRfc4648) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

TEST(Base64, ComesBack) {
  std::string bytes;
  for (int k = 0; k < 300; ++k) {
    EXPECT_EQ(from_base64(base64(bytes)), bytes);
    bytes += static_cast<char>(k * 37);
  }
}

TEST(Base64, RefusesWhatItHasNotMade) {
  for (const char* text : {"Z", "Zg=", "Zg==Zg==", "Zm9v!A==", "Z===", "====", "Zh==", "Zm9="})
    EXPECT_FALSE(from_base64(text)) << text;
}

}  // namespace
}  // namespace mrsim
