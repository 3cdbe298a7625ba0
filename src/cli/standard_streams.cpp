#include "cli/standard_streams.h"

#include <mrsim/types.h>

#include <cerrno>
#include <cstdio>

#include <fcntl.h>

namespace mrsim::cli {

void keep_standard_streams() {
  for (const int descriptor : {0, 1, 2}) {
    if (::fcntl(descriptor, F_GETFD) != -1 || errno != EBADF) continue;
    // The lowest free number, which is this one. Open the wrong way round: its use is an error.
    ::open("/dev/null", descriptor == 0 ? O_WRONLY : O_RDONLY);
  }
}

void print(const std::string& text) { std::fwrite(text.data(), 1, text.size(), stdout); }

int finish_output(int code) {
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
    throw Error("output-unwritable", "cannot write to the standard output");
  return code;
}

void say(const std::string& text) {
  std::fflush(stdout);  // keeps the order where both go to one place
  std::fwrite(text.data(), 1, text.size(), stderr);
}

}  // namespace mrsim::cli
