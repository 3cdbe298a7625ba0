#include "core/output/output_place.h"

#include "core/output/real_path.h"
#include "core/process/error.h"

#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

namespace mrsim {
namespace {

namespace fs = std::filesystem;

// The number in "/proc/self/fd/7" or "/dev/fd/7".
std::optional<int> descriptor_in(const std::string& path) {
  for (const std::string_view head : {"/proc/self/fd/", "/dev/fd/"}) {
    if (!path.starts_with(head)) continue;
    int number = -1;
    const char* end = path.data() + path.size();
    if (std::from_chars(path.data() + head.size(), end, number).ptr == end && number >= 0)
      return number;
  }
  return std::nullopt;
}

// Absolute, without links in its folder; the last part may be a link, or missing.
fs::path settled(const fs::path& path) {
  std::error_code ignored;
  const fs::path whole = fs::absolute(path, ignored);
  const fs::path folder = fs::canonical(whole.parent_path(), ignored);
  return ignored ? whole.lexically_normal() : folder / whole.filename();
}

void to_stream(OutputPlace& place, int descriptor = -1) {
  place.kind = OutputPlace::Kind::stream;
  place.descriptor = descriptor;
}

void follow_links(OutputPlace& place) {
  // Absolute, but not settled: the link /proc/self/fd/1 is the descriptor, not what it shows.
  std::error_code failed;
  fs::path at = fs::absolute(place.given, failed);
  if (failed) fail_output(place.given, failed.value());
  for (int links = 0;; ++links) {
    if (const auto number = descriptor_in(at.lexically_normal().string()))
      to_stream(place, *number);
    at = settled(at);
    place.path = at.string();
    std::error_code none;
    if (place.kind == OutputPlace::Kind::stream || !fs::is_symlink(at, none)) return;
    if (links == kMostLinks) fail_output(place.given, ELOOP);
    const fs::path target = fs::read_symlink(at, none);
    if (none) fail_output(place.given, none.value());
    at = at.parent_path() / target;
  }
}

// The file that lies at the place; nothing where there is none.
std::optional<struct stat> facts(const OutputPlace& place) {
  struct stat info {};
  const int failed =
      place.descriptor >= 0 ? ::fstat(place.descriptor, &info) : ::stat(place.path.c_str(), &info);
  return failed != 0 ? std::nullopt : std::optional(info);
}

// Two names of one file, whether it is there or not.
bool is_same(const OutputPlace& a, const OutputPlace& b) {
  if (a.path == b.path && !a.path.empty()) return true;
  const auto of_a = facts(a), of_b = facts(b);
  return of_a && of_b && of_a->st_dev == of_b->st_dev && of_a->st_ino == of_b->st_ino;
}

// Whether the place takes one output only: a second one would follow the first in the same file,
// which nobody can read. /dev/null and the like take any number.
bool takes_one(const OutputPlace& place) {
  if (place.kind == OutputPlace::Kind::file) return true;
  const auto info = facts(place);
  return info && !S_ISCHR(info->st_mode);
}

std::string named(const NamedPath& file) { return fmt::format("{} ({})", file.path, file.role); }

}  // namespace

std::string folder_of(const std::string& path) {
  const fs::path folder = fs::path(path).parent_path();
  return folder.empty() ? "." : folder.string();
}

void fail_output(const std::string& path, int error) {
  const bool full = error == ENOSPC || error == EDQUOT;
  throw Error(full ? "output-full" : "output-unwritable",
              fmt::format("cannot write {}: {}", path, std::strerror(error)));
}

OutputPlace output_place(const std::string& path) {
  OutputPlace place;
  place.given = path;
  if (path == "-") {
    to_stream(place, STDOUT_FILENO);
    return place;
  }
  if (path.empty()) throw Error("output-unwritable", "an output has an empty name");
  follow_links(place);
  place.folder = folder_of(place.path);
  if (place.kind == OutputPlace::Kind::stream) return place;
  struct stat info {};
  const bool is_there = ::stat(place.path.c_str(), &info) == 0;
  if (is_there && S_ISDIR(info.st_mode))
    throw Error("output-unwritable", fmt::format("cannot write {}: it is a directory", path));
  if (is_there && !S_ISREG(info.st_mode)) to_stream(place);
  std::error_code ignored;
  if (!is_there && !fs::is_directory(place.folder, ignored))
    throw Error("output-folder",
                fmt::format("cannot write {}: the folder {} does not exist", path, place.folder));
  if (fs::path(place.path).filename().empty())
    throw Error("output-unwritable", fmt::format("cannot write {}: it names no file", path));
  return place;
}

void check_replaceable(const OutputPlace& place) {
#if defined(STATX_ATTR_APPEND) && defined(STATX_ATTR_IMMUTABLE)
  const auto attributes = [](const std::string& path) {
    struct statx info {};
    return ::statx(AT_FDCWD, path.c_str(), AT_SYMLINK_NOFOLLOW, STATX_TYPE, &info) == 0
               ? info.stx_attributes
               : 0;
  };
  const auto refuse = [&](const std::string& why) {
    throw Error("output-unwritable", fmt::format("cannot write {}: {}", place.given, why));
  };
  if ((attributes(place.folder) & STATX_ATTR_APPEND) != 0)
    refuse(fmt::format("nothing in {} can be renamed or removed (chattr +a)", place.folder));
  const auto own = attributes(place.path);
  if ((own & (STATX_ATTR_APPEND | STATX_ATTR_IMMUTABLE)) != 0)
    refuse("it cannot be replaced (chattr +a or +i)");
#ifdef STATX_ATTR_MOUNT_ROOT
  if ((own & STATX_ATTR_MOUNT_ROOT) != 0) refuse("it is mounted there and cannot be replaced");
#endif
#else
  (void)place;
#endif
}

void check_writable(const std::string& path) {
  const OutputPlace place = output_place(path);
  if (place.kind == OutputPlace::Kind::stream) return;
  check_replaceable(place);
  // A probe, because access() says yes to root on a read-only file system.
  int fd = -1;
#ifdef O_TMPFILE
  fd = ::open(place.folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0600);
#endif
  if (fd < 0) {
    std::string probe = place.folder + "/.mrsim-XXXXXX";
    fd = ::mkostemp(probe.data(), O_CLOEXEC);
    if (fd < 0) fail_output(path, errno);
    ::unlink(probe.c_str());
  }
  ::close(fd);
}

void refuse_overwrites(std::span<const NamedPath> outputs, std::span<const NamedPath> inputs) {
  std::vector<OutputPlace> places;
  for (const NamedPath& output : outputs) places.push_back(output_place(output.path));
  std::vector<OutputPlace> sources(inputs.size());
  for (std::size_t j = 0; j < inputs.size(); ++j)
    if (!inputs[j].path.empty()) sources[j].path = settled(inputs[j].path).string();
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t j = 0; j < sources.size(); ++j)
      if (places[i].kind == OutputPlace::Kind::file && !sources[j].path.empty() &&
          is_same(places[i], sources[j]))
        throw Error("output-is-input",
                    fmt::format("{} would overwrite {}: name another file", named(outputs[i]),
                                named(inputs[j])),
                    Error::Kind::usage);
    for (std::size_t j = 0; j < i; ++j)
      if (takes_one(places[i]) && is_same(places[i], places[j]))
        throw Error("output-twice",
                    fmt::format("{} and {} are one file: an output is given twice",
                                named(outputs[j]), named(outputs[i])),
                    Error::Kind::usage);
  }
}

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
