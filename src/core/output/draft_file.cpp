#include "core/output/draft_file.h"

#include "core/numbers/hash.h"
#include "core/output/output_place.h"
#include "core/output/publish.h"
#include "core/output/scratch_file.h"
#include "core/process/error.h"

#include <algorithm>
#include <cerrno>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace mrsim {
namespace {

constexpr std::size_t kSmall = std::size_t(1) << 16;      // bytes: writes that are collected
constexpr std::size_t kBuffer = std::size_t(1) << 20;     // and written together
constexpr std::uint64_t kStart = std::uint64_t(8) << 20;  // written out together

// The link by which a file without a name gets one.
std::string link_of(int fd) { return fmt::format("/proc/self/fd/{}", fd); }

}  // namespace

DraftFile::DraftFile(const std::string& path) : place_(output_place(path)) {
  if (place_.kind == OutputPlace::Kind::file) {
    check_replaceable(place_);
    if (!open_nameless(place_.folder)) open_named();
    return;
  }
  if (open_nameless(temporary_folder())) return;
  fd_ = ::memfd_create("mrsim", MFD_CLOEXEC);
  if (fd_ < 0) fail(errno);
}

DraftFile::~DraftFile() {
  if (!name_.empty()) ::unlink(name_.c_str());
  if (fd_ >= 0) ::close(fd_);
}

bool DraftFile::open_nameless(const std::string& folder) {
#ifdef O_TMPFILE
  fd_ = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
  if (fd_ >= 0 && ::access(link_of(fd_).c_str(), F_OK) == 0) return true;
  if (fd_ >= 0) ::close(fd_);
  fd_ = -1;
#else
  (void)folder;
#endif
  return false;
}

// Locked as long as this process lives: a next run removes the drafts of dead ones. One that is
// removed before it could be locked is made again.
void DraftFile::open_named() {
  for (;;) {
    name_ = place_.folder + "/.mrsim-XXXXXX";
    fd_ = ::mkostemp(name_.data(), O_CLOEXEC);
    if (fd_ < 0) {
      name_.clear();
      fail(errno);
    }
    ::flock(fd_, LOCK_EX | LOCK_NB);
    struct stat info {};
    if (::fstat(fd_, &info) == 0 && info.st_nlink > 0) return;
    ::close(fd_);
  }
}

void DraftFile::write_at(const char* data, std::size_t size, std::uint64_t offset) {
  while (size > 0) {
    const ssize_t n = ::pwrite(fd_, data, size, static_cast<off_t>(offset));
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) fail(errno);
    data += n;
    size -= static_cast<std::size_t>(n);
    offset += static_cast<std::uint64_t>(n);
  }
}

void DraftFile::append(const void* data, std::size_t size) {
  if (buffer_.size() + size > kBuffer || size >= kSmall) flush();
  const char* bytes = static_cast<const char*>(data);
  if (size < kSmall) {
    buffer_.append(bytes, size);
    return;
  }
  write_behind(bytes, size);
}

void DraftFile::write_behind(const char* data, std::size_t size) {
  write_at(data, size, written_);
  written_ += size;
#ifdef SYNC_FILE_RANGE_WRITE
  if (written_ - started_ < kStart) return;
  // No more than advice: what is refused is left to finish().
  ::sync_file_range(fd_, static_cast<off_t>(started_), static_cast<off_t>(written_ - started_),
                    SYNC_FILE_RANGE_WRITE);
  started_ = written_;
#endif
}

void DraftFile::flush() {
  write_behind(buffer_.data(), buffer_.size());
  buffer_.clear();
}

void DraftFile::patch(std::string_view bytes) {
  flush();
  MRSIM_ASSERT(bytes.size() <= written_);
  write_at(bytes.data(), bytes.size(), 0);
}

void DraftFile::clear() {
  buffer_.clear();
  written_ = started_ = 0;
  if (::ftruncate(fd_, 0) != 0) fail(errno);
}

void DraftFile::finish() {
  flush();
  buffer_.shrink_to_fit();  // many may be waiting for their places
  if (place_.kind == OutputPlace::Kind::stream) return;
  // As open(2) would have made it: 0666 less the umask; an existing file keeps its mode.
  struct stat old {};
  const mode_t mask = ::umask(0);
  ::umask(mask);
  const mode_t mode = ::stat(place_.path.c_str(), &old) == 0 ? old.st_mode & 07777 : 0666 & ~mask;
  if (::fchmod(fd_, mode) != 0 || ::fsync(fd_) != 0) fail(errno);
}

std::size_t DraftFile::read_at(char* data, std::size_t size, std::uint64_t offset) const {
  for (;;) {
    const ssize_t n = ::pread(fd_, data, size, static_cast<off_t>(offset));
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) fail(errno);
    return static_cast<std::size_t>(n);
  }
}

std::string DraftFile::sha256() const {
  Sha256 hash;
  std::vector<char> chunk(kBuffer);
  std::uint64_t at = 0;
  while (const std::size_t n = read_at(chunk.data(), chunk.size(), at)) {
    hash.update(chunk.data(), n);
    at += n;
  }
  return hash.hex();
}

void DraftFile::publish() {
  DraftFile* const alone[] = {this};
  mrsim::publish(alone);
}

void DraftFile::name_as(const std::string& name) {
  const int failed = name_.empty() ? ::linkat(AT_FDCWD, link_of(fd_).c_str(), AT_FDCWD,
                                              name.c_str(), AT_SYMLINK_FOLLOW)
                                   : ::rename(name_.c_str(), name.c_str());
  if (failed != 0) fail(errno);
  name_.clear();
}

void DraftFile::pour() const {
  StreamEnd end(place_);
  std::vector<char> chunk(kBuffer);
  std::uint64_t at = 0;
  while (const std::size_t n = read_at(chunk.data(), chunk.size(), at)) {
    end.write(chunk.data(), n);
    at += n;
  }
}

}  // namespace mrsim
