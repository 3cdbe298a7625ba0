// The options of --help stand in the man page and in the completion of bash.
#include "run_program.h"

#include <algorithm>
#include <set>
#include <string>

namespace mrsim {
namespace {

using OptionNames = CliTest;

// "--name" words of a text; a man page writes its dashes as "\-".
std::set<std::string> options_in(std::string text) {
  for (std::size_t at = 0; (at = text.find("\\-", at)) != std::string::npos;) text.erase(at, 1);
  std::set<std::string> out;
  for (std::size_t at = text.find("--"); at != std::string::npos; at = text.find("--", at + 2)) {
    const std::size_t end = text.find_first_not_of("abcdefghijklmnopqrstuvwxyz-", at);
    const std::string name = text.substr(at, end - at);
    if (name.size() > 2) out.insert(name);
  }
  return out;
}

TEST_F(OptionNames, HelpManPageAndCompletionAgree) {
  const std::filesystem::path root = std::filesystem::path(MRSIM_DATA_DIR).parent_path();
  const auto manual = options_in(contents(root / "docs/mrsim.1"));
  const auto completion = options_in(contents(root / "scripts/completion.bash"));
  std::set<std::string> all;
  for (const char* command : {"", "trace", "check", "compare", "render", "tools", "view", "rest"})
    all.merge(options_in(run(std::string(command) + " --help").out));
  EXPECT_GT(all.size(), 30U);
  for (const std::string& name : all) {
    EXPECT_TRUE(manual.count(name)) << name << " is not in docs/mrsim.1";
    EXPECT_TRUE(completion.count(name)) << name << " is not in scripts/completion.bash";
  }
  for (const std::string& name : completion) EXPECT_TRUE(all.count(name)) << name << " is unknown";
}

}  // namespace
}  // namespace mrsim
