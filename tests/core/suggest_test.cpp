#include "core/words/suggest.h"

#include <array>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

constexpr std::array<std::string_view, 4> kWords = {"diameter", "corner_radius", "type", "id"};

TEST(NearestWord, FindsTypingErrors) {
  EXPECT_EQ(nearest_word("diametre", kWords), "diameter");
  EXPECT_EQ(nearest_word("Diamter", kWords), "diameter");
  EXPECT_EQ(nearest_word("tpye", kWords), "type");
  EXPECT_EQ(nearest_word("corner-radius", kWords), "corner_radius");
}

TEST(NearestWord, KeepsSilentWhenNothingIsNear) {
  EXPECT_EQ(nearest_word("spindle", kWords), "");
  EXPECT_EQ(nearest_word("x", kWords), "");
  EXPECT_EQ(nearest_word(std::string(1000, 'a'), kWords), "");
  EXPECT_EQ(suggestion("tpye", kWords), "; did you mean \"type\"?");
  EXPECT_EQ(suggestion("spindle", kWords), "");
}

}  // namespace
}  // namespace mrsim
