// A file or folder with a name that is gone with its owner, and with a process that is stopped.
#pragma once

#include <string>

namespace mrsim::cli {

class TemporaryPlace {
 public:
  enum class Kind { page, folder };
  /// A new empty .html file or folder in the system's temporary folder. Throws Error
  /// "output-folder".
  explicit TemporaryPlace(Kind kind);
  TemporaryPlace(const TemporaryPlace&) = delete;
  TemporaryPlace& operator=(const TemporaryPlace&) = delete;
  ~TemporaryPlace();

  const std::string& path() const { return path_; }
  /// It outlives its owner.
  void keep();

 private:
  std::string path_;
};

/// All that there are: the process is about to end out of order.
void remove_temporary_places();

}  // namespace mrsim::cli
