#include "cli/console/standard_streams.h"

#include "cli/console/temporary_place.h"
#include <mrsim/types.h>

#include <cerrno>
#include <csignal>
#include <cstdio>

#include <fcntl.h>
#include <unistd.h>

namespace mrsim::cli {
namespace {

// Where the reader of the standard output has gone (`| head -1`), the program ends as if it knew
// nothing of SIGPIPE, which is blocked; but without its temporary files.
void end_with_reader() {
  struct sigaction given {};
  ::sigaction(SIGPIPE, nullptr, &given);
  if (given.sa_handler == SIG_IGN) return;  // an error like any other, as its caller wants it
  remove_temporary_places();
  sigset_t pipe;
  ::sigemptyset(&pipe);
  ::sigaddset(&pipe, SIGPIPE);
  ::raise(SIGPIPE);
  ::pthread_sigmask(SIG_UNBLOCK, &pipe, nullptr);
}

}  // namespace

void keep_standard_streams() {
  for (const int descriptor : {0, 1, 2}) {
    if (::fcntl(descriptor, F_GETFD) != -1 || errno != EBADF) continue;
    // The lowest free number, which is this one. Open the wrong way round: its use is an error.
    ::open("/dev/null", descriptor == 0 ? O_WRONLY : O_RDONLY);
  }
}

void print(const std::string& text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) < text.size() && errno == EPIPE)
    end_with_reader();
}

int finish_output(int code) {
  errno = 0;
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
  if (errno == EPIPE) end_with_reader();
  throw Error("output-unwritable", "cannot write to the standard output");
}

void say(const std::string& text) {
  // Keeps the order where both go to one place.
  if (std::fflush(stdout) != 0 && errno == EPIPE) end_with_reader();
  std::fwrite(text.data(), 1, text.size(), stderr);
}

}  // namespace mrsim::cli
