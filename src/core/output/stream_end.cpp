#include "core/output/output_place.h"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <ctime>

#include <fcntl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

namespace mrsim {
namespace {

int open_socket(const OutputPlace& place) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (place.path.size() >= sizeof address.sun_path) fail_output(place.given, ENAMETOOLONG);
  std::memcpy(address.sun_path, place.path.c_str(), place.path.size() + 1);
  const int fd = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (fd < 0) fail_output(place.given, errno);
  if (::connect(fd, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0) return fd;
  const int error = errno;
  ::close(fd);
  fail_output(place.given, error);
}

// Keeps SIGPIPE, which would end the program without a word, from this thread.
class NoPipeSignal {
 public:
  NoPipeSignal() {
    ::sigemptyset(&pipe_);
    ::sigaddset(&pipe_, SIGPIPE);
    ::pthread_sigmask(SIG_BLOCK, &pipe_, &before_);
  }
  NoPipeSignal(const NoPipeSignal&) = delete;
  NoPipeSignal& operator=(const NoPipeSignal&) = delete;
  ~NoPipeSignal() {
    const timespec none{};
    ::sigtimedwait(&pipe_, nullptr, &none);
    ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }

 private:
  sigset_t pipe_{}, before_{};
};

}  // namespace

StreamEnd::StreamEnd(const OutputPlace& place) : place_(place) {
  struct stat info {};
  if (place.descriptor >= 0)
    fd_ = ::fcntl(place.descriptor, F_DUPFD_CLOEXEC, 0);
  else if (::stat(place.path.c_str(), &info) == 0 && S_ISSOCK(info.st_mode))
    fd_ = open_socket(place);
  else
    fd_ = ::open(place.path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY);
  if (fd_ < 0) fail_output(place.given, errno);
}

StreamEnd::~StreamEnd() { ::close(fd_); }

void StreamEnd::write(const char* data, std::size_t size) {
  const NoPipeSignal quiet;
  while (size > 0) {
    const ssize_t n = ::write(fd_, data, size);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) fail_output(place_.given, errno);
    data += n;
    size -= static_cast<std::size_t>(n);
  }
}

}  // namespace mrsim
