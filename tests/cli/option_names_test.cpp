// Help, manual, completion and the document of jobs say the same of the options.
#include "run_program.h"

#include <regex>
#include <set>
#include <string>

namespace mrsim {
namespace {

using namespace mrsim::testing;

using Names = std::set<std::string>;

// All matches of a group of `pattern`.
Names found(const std::string& text, const char* pattern) {
  Names out;
  const std::regex expression(pattern);
  for (std::sregex_iterator at(text.begin(), text.end(), expression), end; at != end; ++at)
    out.insert((*at)[1]);
  return out;
}

class OptionNames : public CliTest {
 protected:
  // Options at the beginning of a line of --help.
  Names helped(const std::string& command) {
    return found(run(command + " --help").out, "\n  (?:-[a-z],)?(--[a-z-]+)");
  }
  // What bash offers for the last word, a line each.
  std::string offered(const std::string& words) {
    const std::string texts = MRSIM_OPTION_TEXTS;
    write("ask.sh", "source '" + texts + "/completion.bash'\nCOMP_WORDS=(" + words +
                        ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_mrsim\n"
                        "printf '%s\\n' \"${COMPREPLY[@]}\" >offered\n");
    const std::string command = "cd '" + folder_.string() + "' && bash ask.sh";
    EXPECT_EQ(std::system(command.c_str()), 0);
    return read("offered");
  }
};

TEST_F(OptionNames, CompletionOffersWhatHelpNames) {
  for (const std::string command : {"trace", "check", "compare", "rest", "tools"}) {
    const Names names = helped(command);
    EXPECT_GT(names.size(), 3U) << command;
    EXPECT_EQ(found(offered("mrsim " + command + " --"), "(--[a-z-]+)"), names) << command;
  }
  EXPECT_EQ(found(offered("mrsim p.mpf --"), "(--[a-z-]+)"), helped(""));
  Names render = helped("render");
  render.merge(helped("render p.mpf --frames 2"));
  EXPECT_EQ(found(offered("mrsim render --"), "(--[a-z-]+)"), render);
  Names view = helped("view");
  view.merge(helped(""));
  EXPECT_EQ(found(offered("mrsim view --"), "(--[a-z-]+)"), view);
}

TEST_F(OptionNames, CompletionOffersValuesAndCommands) {
  EXPECT_EQ(offered("mrsim p.mpf --dialect f"), "fanuc\n");
  EXPECT_EQ(offered("mrsim p.mpf --align i"), "icp\n");
  EXPECT_EQ(offered("mrsim p.mpf --stock cyl"), "cylinder:\n");
  EXPECT_EQ(offered("mrsim comp"), "compare\n");
}

TEST_F(OptionNames, ManualTellsEachOptionOnce) {
  std::string manual = contents(std::string(MRSIM_OPTION_TEXTS) + "/mrsim.1");
  for (std::size_t at = 0; (at = manual.find("\\-", at)) != std::string::npos;) manual.erase(at, 1);
  Names all;
  for (const char* command :
       {"", "trace", "check", "compare", "render", "tools", "view", "rest", "render --frames 2"})
    all.merge(helped(command));
  EXPECT_GT(all.size(), 50U);
  EXPECT_EQ(found(manual, "\n\\.TP\n[^\n]*(--[a-z-]+)"), all);
  for (const std::string& name : all) {
    const std::regex entry("\n\\.TP\n[^\n]*" + name + "[ \"\n]");
    EXPECT_EQ(std::distance(std::sregex_iterator(manual.begin(), manual.end(), entry), {}), 1)
        << name;
  }
}

// An unknown key is answered with all that there are.
TEST_F(OptionNames, DocumentOfJobsHasAllKeys) {
  write("job.toml", "quux = 1\n");
  const std::string error = run("job.toml").err;
  const std::string list = error.substr(error.find("known here: ") + 12);
  const Names keys =
      found(list.substr(0, list.find_first_not_of("abcdefghijklmnopqrstuvwxyz_ ")), "([a-z_]+)");
  EXPECT_GT(keys.size(), 35U);
  const std::string text = contents(std::filesystem::path(MRSIM_DATA_DIR) / "../docs/job.md");
  Names told;
  for (const std::string& cell : found(text, "\n\\| ([a-z_, ]+) \\|"))
    told.merge(found(cell, "([a-z_]+)"));
  told.erase("key");
  EXPECT_EQ(told, keys);
}

}  // namespace
}  // namespace mrsim
