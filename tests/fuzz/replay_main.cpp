// Without libFuzzer: runs a fuzz target over the files of its corpus, and over up to eighty cheap
// variations of each (cut short, bytes changed; a third of them under sanitizers), fewer where the
// corpus is large, the same in every run.
#include "support/rounds.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

using Bytes = std::vector<std::uint8_t>;

void run(const Bytes& bytes) { LLVMFuzzerTestOneInput(bytes.data(), bytes.size()); }

std::uint64_t next_random(std::uint64_t& state) {
  state ^= state << 13;
  state ^= state >> 7;
  return state ^= state << 17;
}

// Of each of so many files; five are one beginning and four changes.
std::size_t variations(std::size_t files) {
  const std::size_t most = mrsim::testing::rounds(80), all = mrsim::testing::rounds(13000);
  return std::clamp<std::size_t>(all / files, 5, most);
}

// A fifth of them are beginnings.
void run_variations(const Bytes& bytes, std::size_t count) {
  if (bytes.empty() || bytes.size() > (std::size_t(1) << 16)) return;
  const std::size_t cuts = count / 5, changes = count - cuts;
  for (std::size_t i = 1; i <= cuts; ++i)
    run(Bytes(bytes.begin(),
              bytes.begin() + static_cast<std::ptrdiff_t>(bytes.size() * i / (cuts + 1))));
  std::uint64_t state = 88172645463325252ull ^ bytes.size();
  for (std::size_t i = 0; i < changes; ++i) {
    Bytes changed = bytes;
    for (std::uint64_t n = 1 + next_random(state) % 4; n > 0; --n)
      changed[next_random(state) % changed.size()] = static_cast<std::uint8_t>(next_random(state));
    run(changed);
  }
}

}  // namespace

int main(int argc, char** argv) {
  std::set<std::string> files;
  for (int i = 1; i < argc; ++i) {
    if (std::filesystem::is_directory(argv[i]))
      for (const auto& entry : std::filesystem::recursive_directory_iterator(argv[i]))
        if (entry.is_regular_file()) files.insert(entry.path().string());
    if (std::filesystem::is_regular_file(argv[i])) files.insert(argv[i]);
  }
  run({});
  for (const std::string& path : files) {
    std::ifstream file(path, std::ios::binary);
    const Bytes bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    run(bytes);
    run_variations(bytes, variations(files.size()));
  }
  std::printf("%zu files and their variations\n", files.size());
  return files.empty() ? 1 : 0;  // an empty corpus tests nothing
}
