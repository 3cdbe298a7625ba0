// A temporary file or folder that is removed with its owner, and when the process is stopped.
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
  /// The file or folder stays when this object is gone.
  void keep();

 private:
  std::string path_;
};

/// Removes all that there are; for a process that ends out of order.
void remove_temporary_places();

}  // namespace mrsim::cli
