// Runs the built program as a user does, in a folder of its own.
#pragma once

#include "support/json_schema.h"
#include "support/sanitized.h"
#include "support/temp_folder.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/wait.h>

namespace mrsim::testing {

using Json = nlohmann::json;

/// A variable of the environment, where tests of one build run the program of another.
inline std::string from_environment(const char* name, const char* otherwise) {
  const char* value = std::getenv(name);
  return value ? value : otherwise;
}

// The program, its library, and whether neither is sanitized: a sanitizer's shadow is memory as
// well.
inline const std::string kProgram = from_environment("MRSIM_PROGRAM", MRSIM_PROGRAM),
                         kLibrary = from_environment("MRSIM_LIBRARY", MRSIM_LIBRARY);
inline const bool kIsPlain = !is_sanitized();

struct Outcome {
  int code = -1;
  std::string out, err;
};

inline std::string contents(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

class CliTest : public TempFolderTest {
 protected:
  void SetUp() override {
    for (const char* name : {"PRIMER_2F.MPF", "PRIMER_2S.MPF", "block.stl", "bar.stl"})
      std::filesystem::copy(std::filesystem::path(MRSIM_DATA_DIR) / name, folder_ / name);
  }

  /// `arguments` as typed after "mrsim" in a shell, `variables` before it.
  Outcome run(const std::string& arguments, const std::string& variables = "") {
    const std::string command = "cd '" + folder_.string() + "' && " + variables + " '" + kProgram +
                                "' " + arguments + " >.out 2>.err </dev/null";
    const int status = std::system(command.c_str());
    Outcome outcome;
    outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : 100 + status;
    outcome.out = contents(folder_ / ".out");
    outcome.err = contents(folder_ / ".err");
    return outcome;
  }
  void write(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }
  std::string read(const std::string& name) { return contents(folder_ / name); }
  bool exists(const std::string& name) { return std::filesystem::exists(folder_ / name); }

  /// The run fails with `code`, says `text`, and leaves no file "part.stl" nor any temporary one.
  void expect_failure(const std::string& arguments, int code, const std::string& text) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, code) << arguments << "\n" << outcome.err;
    EXPECT_NE(outcome.err.find(text), std::string::npos) << arguments << "\n" << outcome.err;
    EXPECT_NE(outcome.err.find("error:"), std::string::npos) << arguments << "\n" << outcome.err;
    EXPECT_FALSE(exists("part.stl")) << arguments;
    for (const auto& entry : std::filesystem::directory_iterator(folder_))
      EXPECT_FALSE(entry.path().filename().string().starts_with(".mrsim-")) << entry.path();
  }
  /// The file fits docs/schema/`schema`.json; with `is_lines`, each of its lines does.
  void expect_valid(const std::string& schema, const std::string& name, bool is_lines = false) {
    const JsonSchema checked(
        Json::parse(contents(MRSIM_DATA_DIR "/../docs/schema/" + schema + ".json")));
    std::istringstream lines(read(name));
    std::string value;
    std::size_t count = 0;
    while (std::getline(lines, value, is_lines ? '\n' : '\0')) {
      ++count;
      const Json parsed = Json::parse(value, nullptr, false);
      ASSERT_FALSE(parsed.is_discarded()) << value.substr(0, 2000);
      for (const std::string& fault : checked.faults(parsed)) ADD_FAILURE() << fault;
    }
    EXPECT_GT(count, 0U) << name;
  }
};

/// With the nominals of both parts in the folder.
class NominalTest : public CliTest {
 protected:
  void SetUp() override {
    CliTest::SetUp();
    for (const char* name : {"PRIMER_2F.nominal.stl", "PRIMER_2S.nominal.stl"})
      std::filesystem::copy(std::filesystem::path(MRSIM_DATA_DIR) / name, folder_ / name);
  }
};

/// The number after `label` in a report, its thousands apart.
inline double number_after(const std::string& text, const std::string& label) {
  const std::size_t at = text.find(label);
  if (at == std::string::npos) return -1;
  std::string digits;
  for (std::size_t i = text.find_first_of("0123456789", at + label.size()); i < text.size(); ++i) {
    const char c = text[i];
    if (c == ' ' && i + 1 < text.size() && text[i + 1] >= '0' && text[i + 1] <= '9') continue;
    if (c != '.' && (c < '0' || c > '9')) break;
    digits += c;
  }
  return std::stod("0" + digits);
}

}  // namespace mrsim::testing
