// Locks of folders, that keep two processes from publishing files there at one time.
#pragma once

#include <set>
#include <string>
#include <vector>

namespace mrsim {

/// Holds all folders of a set, until it goes away or the process ends. Leaves no file behind: the
/// lock is on the folder itself. A file system without such locks (NFS) holds nobody off.
class FolderLocks {
 public:
  /// Requires: absolute names without links. Throws Error "output-busy" when another process holds
  /// one for a minute.
  explicit FolderLocks(const std::set<std::string>& folders);
  FolderLocks(const FolderLocks&) = delete;
  FolderLocks& operator=(const FolderLocks&) = delete;
  ~FolderLocks();

 private:
  void take(const std::string& folder);
  std::vector<int> held_;
};

}  // namespace mrsim
