// A folder of its own for each test, gone with it; and the code of the error that a call throws.
#pragma once

#include "core/error.h"

#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>
#include <stdlib.h>

namespace mrsim {

/// A folder that is removed with this object.
class TempFolder {
 public:
  TempFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "mrsim-test-XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("mkdtemp: " + pattern);
    folder_ = pattern;
  }
  ~TempFolder() { std::filesystem::remove_all(folder_); }
  TempFolder(const TempFolder&) = delete;
  TempFolder& operator=(const TempFolder&) = delete;
  const std::filesystem::path& folder() const { return folder_; }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

 private:
  std::filesystem::path folder_;
};

class TempFolderTest : public ::testing::Test {
 protected:
  std::string path(const std::string& name) const { return temporary_.path(name); }

 private:
  TempFolder temporary_;

 protected:
  const std::filesystem::path& folder_ = temporary_.folder();
};

/// Empty where none is thrown.
inline std::string code_of(const std::function<void()>& body) {
  try {
    body();
  } catch (const Error& error) {
    return error.code();
  }
  return {};
}

}  // namespace mrsim
