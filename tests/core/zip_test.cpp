#include "core/text/zip.h"

#include "core/process/memory_limit.h"
#include "support/error_code.h"

#include <gtest/gtest.h>

namespace mrsim::detail {
namespace {

// 60 kB of an archive may hold 60 MB.
TEST(Zip, UnpacksOnlyWhatTheMemoryLimitLeaves) {
  constexpr std::size_t kSize = 60'000'000;
  const std::string bytes = zip({{"bomb", std::string(kSize, ' ')}});
  const std::vector<ZipEntry> entries = zip_directory(bytes, "a.3mf");
  const auto unpack = [&](std::size_t limit) {
    const MemoryLimit held(limit);
    return testing::error_code([&] { unzip(bytes, entries.at(0), 2 * kSize, "a.3mf"); });
  };
  EXPECT_EQ(unpack(50'000'000), "memory");
  EXPECT_EQ(unpack(400'000'000), "");
}

}  // namespace
}  // namespace mrsim::detail
