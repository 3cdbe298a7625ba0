#include "core/words/option_table.h"

#include <set>
#include <string>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

TEST(OptionTable, NamesStandOnceInEachCommand) {
  for (unsigned use = kUseRun; use <= kUseView; use <<= 1) {
    std::set<std::string_view> names;
    for (const OptionRow& row : option_table())
      EXPECT_TRUE((row.uses & use) == 0 || names.insert(row.name).second) << row.name;
  }
}

TEST(OptionTable, KeysOfJobsStandOnceAndAreTheirOptions) {
  std::set<std::string_view> keys;
  for (const OptionRow& row : option_table()) {
    if (row.key.empty()) continue;
    EXPECT_TRUE(keys.insert(row.key).second) << row.key;
    EXPECT_EQ(find_option(row.name, kUseRun), &row) << row.key << " is an option of a run";
    std::string name = "--" + std::string(row.key);
    for (char& c : name)
      if (c == '_') c = '-';
    EXPECT_TRUE(row.name == name || row.key == "variables" || row.key == "outputs") << row.key;
  }
  EXPECT_GT(keys.size(), 35U);
}

TEST(OptionTable, FlagsAloneHaveNoType) {
  for (const OptionRow& row : option_table()) {
    EXPECT_EQ(row.type.empty(), row.value == OptionValue::flag) << row.name;
    EXPECT_FALSE(row.help.empty()) << row.name;
    EXPECT_TRUE(row.value != OptionValue::choice || option_words(row).size() > 1) << row.name;
  }
}

TEST(OptionTable, FindsTheRowOfACommand) {
  EXPECT_EQ(find_option("--above", kUseRun), nullptr);
  ASSERT_NE(find_option("--json", kUseTrace), nullptr);
  EXPECT_EQ(find_option("--json", kUseTrace)->value, OptionValue::flag);
  EXPECT_EQ(find_option("--json", kUseRun)->value, OptionValue::path);
  EXPECT_EQ(find_option("--voxle"), nullptr);
}

TEST(OptionTable, WordsAreApartBySpaces) {
  const std::vector<std::string_view> words = option_words(*find_option("--align"));
  EXPECT_EQ(words, (std::vector<std::string_view>{"none", "bbox", "icp"}));
  EXPECT_TRUE(option_words(*find_option("--voxel")).empty());
}

}  // namespace
}  // namespace mrsim
