#include "core/output/folder_lock.h"

#include "core/process/error.h"

#include <cerrno>
#include <chrono>
#include <thread>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

namespace mrsim {
namespace {

constexpr auto kPatience = std::chrono::seconds(60);
constexpr auto kPause = std::chrono::milliseconds(5);

}  // namespace

// In the order of their names, so that two processes never wait for each other.
FolderLocks::FolderLocks(const std::set<std::string>& folders) {
  try {
    for (const std::string& folder : folders) take(folder);
  } catch (...) {
    for (const int fd : held_) ::close(fd);
    throw;
  }
}

FolderLocks::~FolderLocks() {
  for (const int fd : held_) ::close(fd);
}

void FolderLocks::take(const std::string& folder) {
  const int fd = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (fd < 0) return;  // writable but not readable: nothing can be locked there
  held_.push_back(fd);
  const auto begin = std::chrono::steady_clock::now();
  while (::flock(fd, LOCK_EX | LOCK_NB) != 0) {
    if (errno != EWOULDBLOCK && errno != EINTR) return;  // no locks on this file system
    if (std::chrono::steady_clock::now() - begin > kPatience)
      throw Error("output-busy",
                  fmt::format("another run is writing into {}: wait for its end", folder));
    std::this_thread::sleep_for(kPause);
  }
}

}  // namespace mrsim
