#include "core/child_process.h"

#include "core/error.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <new>

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace mrsim {
namespace {

constexpr int kNoMemory = 42;  // exit code of the child

std::size_t address_space() {
  std::FILE* file = std::fopen("/proc/self/statm", "re");
  unsigned long pages = 0;
  if (file != nullptr) {
    if (std::fscanf(file, "%lu", &pages) != 1) pages = 0;
    std::fclose(file);
  }
  return pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

void lower(decltype(RLIMIT_AS) what, rlim_t value) {
  rlimit limit{};
  ::getrlimit(what, &limit);
  limit.rlim_cur = std::min(limit.rlim_cur, value);
  limit.rlim_max = std::min(limit.rlim_max, value);
  ::setrlimit(what, &limit);
}

void write_all(int fd, const char* data, std::size_t size) {
  while (size > 0) {
    const ssize_t n = ::write(fd, data, size);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) ::_exit(1);
    data += n;
    size -= static_cast<std::size_t>(n);
  }
}

[[noreturn]] void be_child(int fd, const ChildLimits& limits,
                           const std::function<void(const ByteSink&)>& work) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  const int nowhere = ::open("/dev/null", O_WRONLY);  // what a dying library says is of no use
  ::dup2(nowhere, STDOUT_FILENO);
  ::dup2(nowhere, STDERR_FILENO);
  lower(RLIMIT_CORE, 0);
  lower(RLIMIT_CPU, static_cast<rlim_t>(limits.seconds));
#ifndef __SANITIZE_ADDRESS__  // its shadow takes all addresses
  if (limits.bytes > 0) lower(RLIMIT_AS, address_space() + limits.bytes);
#endif
  try {
    work([fd](const void* data, std::size_t size) {
      write_all(fd, static_cast<const char*>(data), size);
    });
  } catch (const std::bad_alloc&) {
    ::_exit(kNoMemory);
  } catch (...) {
    ::_exit(1);
  }
  ::_exit(0);
}

// False where the clock ran out.
bool collect(int fd, int seconds, std::string& bytes) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::seconds(seconds);
  std::array<char, 65536> piece;
  for (;;) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now());
    if (left.count() <= 0) return false;
    pollfd wait{fd, POLLIN, 0};
    if (::poll(&wait, 1, static_cast<int>(left.count())) <= 0) continue;
    const ssize_t n = ::read(fd, piece.data(), piece.size());
    if (n == 0) return true;
    if (n > 0) bytes.append(piece.data(), static_cast<std::size_t>(n));
  }
}

ChildOutcome::End end_of(int status) {
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return ChildOutcome::End::done;
  if (WIFEXITED(status) && WEXITSTATUS(status) == kNoMemory)
    return ChildOutcome::End::out_of_memory;
  if (WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL))
    return ChildOutcome::End::too_long;
  return ChildOutcome::End::crashed;
}

}  // namespace

ChildOutcome run_in_child(const ChildLimits& limits,
                          const std::function<void(const ByteSink& sink)>& work) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0)
    throw Error("process", fmt::format("no pipe: {}", std::strerror(errno)));
  const pid_t child = ::fork();
  if (child == 0) be_child(ends[1], limits, work);
  const int error = errno;
  ::close(ends[1]);
  if (child < 0) {
    ::close(ends[0]);
    throw Error("process", fmt::format("no process: {}", std::strerror(error)));
  }
  ChildOutcome out;
  bool in_time = false;
  try {
    in_time = collect(ends[0], 4 * limits.seconds, out.bytes);
  } catch (...) {
    out.end = ChildOutcome::End::out_of_memory;
  }
  if (!in_time) ::kill(child, SIGKILL);
  ::close(ends[0]);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (out.end == ChildOutcome::End::done) out.end = end_of(status);
  return out;
}

}  // namespace mrsim
