#include "cli/console/temporary_place.h"

#include "core/output/scratch_file.h"
#include "core/process/error.h"

#include <cstdlib>
#include <filesystem>
#include <mutex>
#include <set>
#include <system_error>

#include <unistd.h>

namespace mrsim::cli {
namespace {

std::mutex places_mutex;
std::set<std::string>& places() {
  static std::set<std::string>& all = *new std::set<std::string>;  // outlives all threads
  return all;
}

void remove(const std::string& path) {
  std::error_code ignored;
  std::filesystem::remove_all(path, ignored);
}

}  // namespace

TemporaryPlace::TemporaryPlace(Kind kind) {
  const std::lock_guard<std::mutex> lock(places_mutex);
  path_ = temporary_folder() + (kind == Kind::page ? "/mrsim-XXXXXX.html" : "/mrsim-XXXXXX");
  if (kind == Kind::folder) {
    if (::mkdtemp(path_.data()) == nullptr)
      throw Error("output-folder", path_ + ": the temporary folder cannot be made");
  } else {
    const int file = ::mkstemps(path_.data(), 5);
    if (file < 0) throw Error("output-folder", path_ + ": the temporary file cannot be made");
    ::close(file);
  }
  places().insert(path_);
}

TemporaryPlace::~TemporaryPlace() {
  const std::lock_guard<std::mutex> lock(places_mutex);
  if (places().erase(path_) > 0) remove(path_);
}

void TemporaryPlace::keep() {
  const std::lock_guard<std::mutex> lock(places_mutex);
  places().erase(path_);
}

void remove_temporary_places() {
  const std::lock_guard<std::mutex> lock(places_mutex);
  for (const std::string& path : places()) remove(path);
  places().clear();
}

}  // namespace mrsim::cli
