#include "core/process/child_process.h"

#include "core/process/error.h"
#include "core/process/heap.h"
#include "core/process/memory_limit.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>
#include <optional>

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

[[maybe_unused]] std::size_t address_space() {
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

// Lets the kernel kill this process when its parent ends.
void die_with(pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(1);  // the parent has died before prctl() took effect
}

void be_silent() {
  const int nowhere = ::open("/dev/null", O_WRONLY);
  ::dup2(nowhere, STDOUT_FILENO);
  ::dup2(nowhere, STDERR_FILENO);
}

// Runs in the forked copy of this process. Only calls that are safe in a signal handler are allowed
// there: other threads of the original may have held locks when it was copied.
[[noreturn]] void be_program(char* const* words, ProgramLife life, pid_t parent, int told) {
  if (life == ProgramLife::ours)
    die_with(parent);
  else
    be_silent();
  sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  std::signal(SIGXFSZ, SIG_DFL);
  ::execvp(words[0], words);
  write_all(told, "-", 1);
  ::_exit(127);
}

[[noreturn]] void be_child(int fd, const ChildLimits& limits,
                           const std::function<void(const ByteSink&)>& work, pid_t parent) {
  die_with(parent);
  be_silent();  // a library that fails here may print; the caller reports the end instead
  lower(RLIMIT_CORE, 0);
  lower(RLIMIT_CPU, static_cast<rlim_t>(limits.seconds));
#ifndef __SANITIZE_ADDRESS__  // its shadow memory takes all addresses, so no limit can be set
  if (limits.bytes > 0) {
    // Memory that the heap has reserved and not used yet would be free beyond the limit.
    grow_heap_in_small_steps();
    release_freed_memory();
    lower(RLIMIT_AS, address_space() + limits.bytes);
  }
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

// Reads until the other end closes the pipe. False: its time was over before.
bool collect(int fd, const ChildLimits& limits, std::string& bytes) {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::milliseconds kBetweenQuestions(200);
  const auto begin = Clock::now(), end = begin + std::chrono::seconds(4 * limits.seconds);
  std::array<char, 65536> chunk;
  for (;;) {
    const auto now = Clock::now();
    auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - now);
    if (left.count() <= 0) return false;
    if (limits.goes_on) {
      if (!limits.goes_on(std::chrono::duration<double>(now - begin).count()))
        throw Error("cancelled", "the run was stopped");
      left = std::min(left, kBetweenQuestions);
    }
    pollfd wait{fd, POLLIN, 0};
    if (::poll(&wait, 1, static_cast<int>(left.count())) <= 0) continue;
    const ssize_t n = ::read(fd, chunk.data(), chunk.size());
    if (n == 0) return true;
    if (n > 0 && bytes.size() + chunk.size() > bytes.capacity())
      require_memory(3.0 * double(bytes.capacity()), limits.what);
    if (n > 0) bytes.append(chunk.data(), static_cast<std::size_t>(n));
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

// Throws where the child had too little memory because this process has little left. Otherwise the
// limit that the caller gave has ended it, which is the caller's to tell.
void require_memory_for_child(const ChildLimits& limits, bool is_little, double left) {
  if (is_address_space_limited() && !has_address_space(limits.bytes))
    throw Error(
        "memory",
        limits.what + " takes more address space than is free; raise its limit (ulimit -v)");
  if (is_little)
    throw Error("memory", fmt::format("{} takes more than the {} that are left of the limit; "
                                      "--max-memory allows more",
                                      limits.what, size_text(left)));
}

}  // namespace

ChildOutcome run_in_child(const ChildLimits& given,
                          const std::function<void(const ByteSink& sink)>& work) {
  ChildLimits limits = given;
  const double left = memory_left();
  const bool is_little = limits.bytes > 0 && left < double(limits.bytes);
  if (is_little) limits.bytes = static_cast<std::size_t>(left) + 1;
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0)
    throw Error("process", fmt::format("no pipe: {}", std::strerror(errno)));
  const pid_t parent = ::getpid();
  const pid_t child = ::fork();
  if (child == 0) be_child(ends[1], limits, work, parent);
  const int error = errno;
  ::close(ends[1]);
  if (child < 0) {
    ::close(ends[0]);
    throw Error("process", fmt::format("no process: {}", std::strerror(error)));
  }
  ChildOutcome out;
  bool in_time = false;
  std::exception_ptr fault;
  try {
    in_time = collect(ends[0], limits, out.bytes);
  } catch (const Error&) {
    fault = std::current_exception();
  } catch (...) {
    out.end = ChildOutcome::End::out_of_memory;
  }
  if (!in_time) ::kill(child, SIGKILL);
  ::close(ends[0]);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (fault) std::rethrow_exception(fault);
  if (out.end == ChildOutcome::End::done) out.end = end_of(status);
  if (out.end == ChildOutcome::End::out_of_memory)
    require_memory_for_child(limits, is_little, left);
  return out;
}

int start_program(const std::vector<std::string>& words, ProgramLife life) {
  std::vector<char*> pointers;
  pointers.reserve(words.size() + 1);
  for (const std::string& word : words) pointers.push_back(const_cast<char*>(word.c_str()));
  pointers.push_back(nullptr);
  // A started program closes the pipe; a byte comes through it where the program does not exist.
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) return -1;
  const pid_t parent = ::getpid();
  const pid_t child = ::fork();
  if (child == 0) be_program(pointers.data(), life, parent, ends[1]);
  ::close(ends[1]);
  char byte = 0;
  ssize_t n = 0;
  while (child > 0 && (n = ::read(ends[0], &byte, 1)) < 0 && errno == EINTR) {
  }
  ::close(ends[0]);
  if (child > 0 && n > 0) ::waitpid(child, nullptr, 0);
  return child > 0 && n == 0 ? child : -1;
}

namespace {

// The first bytes in the pipe. The lengths of the texts follow, then the data, in the order of
// these counts. Where the work ended in an Error, its code and its sentence are the only texts.
struct Header {
  std::uint64_t is_error = 0, is_usage = 0;
  std::uint64_t numbers = 0, texts = 0, vertices = 0, triangles = 0;
};

template <class T>
void send_all(const std::vector<T>& column, const ByteSink& sink) {
  sink(column.data(), bytes_of(column));
}

void send(Header header, const ChildParcel& parcel, const ByteSink& sink) {
  header.numbers = parcel.numbers.size();
  header.texts = parcel.texts.size();
  header.vertices = parcel.mesh.vertices.size();
  header.triangles = parcel.mesh.triangles.size();
  sink(&header, sizeof header);
  std::vector<std::uint64_t> lengths;
  for (const std::string& text : parcel.texts) lengths.push_back(text.size());
  send_all(lengths, sink);
  for (const std::string& text : parcel.texts) sink(text.data(), text.size());
  send_all(parcel.numbers, sink);
  send_all(parcel.mesh.vertices, sink);
  send_all(parcel.mesh.triangles, sink);
}

// Takes values one after another from the bytes that came through the pipe.
class Reader {
 public:
  explicit Reader(const std::string& bytes) : bytes_(bytes) {}

  bool take(void* to, std::size_t size) {
    if (size > bytes_.size() - at_) return false;
    if (size > 0) std::memcpy(to, bytes_.data() + at_, size);
    at_ += size;
    return true;
  }
  template <class T>
  bool take_all(std::vector<T>& column, std::uint64_t count) {
    if (count > (bytes_.size() - at_) / sizeof(T)) return false;
    column.resize(count);
    return take(column.data(), bytes_of(column));
  }
  bool take_texts(std::vector<std::string>& texts, std::uint64_t count) {
    std::vector<std::uint64_t> lengths;
    if (!take_all(lengths, count)) return false;
    for (const std::uint64_t length : lengths) {
      if (length > bytes_.size() - at_) return false;
      texts.push_back(bytes_.substr(at_, length));
      at_ += length;
    }
    return true;
  }

 private:
  const std::string& bytes_;
  std::size_t at_ = 0;
};

// The parcel in `bytes`; empty where some are missing, because the process died while it wrote.
std::optional<ChildParcel> receive(const std::string& bytes) {
  Reader reader(bytes);
  Header header;
  ChildParcel parcel;
  const bool whole = reader.take(&header, sizeof header) &&
                     reader.take_texts(parcel.texts, header.texts) &&
                     reader.take_all(parcel.numbers, header.numbers) &&
                     reader.take_all(parcel.mesh.vertices, header.vertices) &&
                     reader.take_all(parcel.mesh.triangles, header.triangles);
  if (!whole) return std::nullopt;
  if (header.is_error != 0)
    throw Error(parcel.texts.at(0), parcel.texts.at(1),
                header.is_usage != 0 ? Error::Kind::usage : Error::Kind::input);
  return parcel;
}

}  // namespace

ChildDelivery deliver_from_child(const ChildLimits& limits,
                                 const std::function<ChildParcel()>& work) {
  const ChildOutcome outcome = run_in_child(limits, [&](const ByteSink& sink) {
    Header header;
    ChildParcel parcel;
    try {
      parcel = work();
    } catch (const Error& error) {
      header.is_error = 1;
      header.is_usage = error.kind() == Error::Kind::usage ? 1 : 0;
      parcel = {{}, {error.code(), error.what()}, {}};
    }
    send(header, parcel, sink);
  });
  if (outcome.end != ChildOutcome::End::done) return {outcome.end, {}};
  std::optional<ChildParcel> parcel = receive(outcome.bytes);
  if (!parcel) return {ChildOutcome::End::crashed, {}};
  return {outcome.end, *std::move(parcel)};
}

}  // namespace mrsim
