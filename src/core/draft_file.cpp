#include "core/draft_file.h"

#include "core/error.h"
#include "core/text_io.h"

#include <cerrno>
#include <cstring>
#include <filesystem>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

namespace mrsim {
namespace {

constexpr std::size_t kSmall = std::size_t(1) << 16;      // bytes: pieces that are collected
constexpr std::size_t kBuffer = std::size_t(1) << 20;     // and written together
constexpr std::uint64_t kStart = std::uint64_t(8) << 20;  // written out together

std::string folder_of(const std::string& path) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  return folder.empty() ? "." : folder.string();
}

// The link by which a file without a name gets one.
std::string link_of(int fd) { return fmt::format("/proc/self/fd/{}", fd); }

void sync_folder(const std::string& folder) {
  const int fd = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (fd < 0) return;
  ::fsync(fd);  // best effort: some file systems refuse to sync a folder
  ::close(fd);
}

}  // namespace

DraftFile::DraftFile(const std::string& path) : path_(path) {
  check_writable(path);
  const std::string folder = folder_of(path);
  if (open_nameless(folder)) return;
  name_ = folder + "/.mrsim-XXXXXX";
  fd_ = ::mkostemp(name_.data(), O_CLOEXEC);
  if (fd_ < 0) {
    name_.clear();
    fail(errno);
  }
}

DraftFile::~DraftFile() {
  if (fd_ >= 0) ::close(fd_);
  if (!name_.empty()) ::unlink(name_.c_str());
}

bool DraftFile::open_nameless(const std::string& folder) {
#ifdef O_TMPFILE
  fd_ = ::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0600);
  if (fd_ >= 0 && ::access(link_of(fd_).c_str(), F_OK) == 0) return true;
  if (fd_ >= 0) ::close(fd_);
  fd_ = -1;
#else
  (void)folder;
#endif
  return false;
}

void DraftFile::fail(int error) const {
  throw Error(error == ENOSPC ? "output-full" : "output-unwritable",
              fmt::format("cannot write {}: {}", path_, std::strerror(error)));
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
  // As open(2) would have made it: 0666 less the umask; an existing file keeps its mode.
  struct stat old {};
  const mode_t mask = ::umask(0);
  ::umask(mask);
  const mode_t mode = ::stat(path_.c_str(), &old) == 0 ? old.st_mode & 07777 : 0666 & ~mask;
  if (::fchmod(fd_, mode) != 0 || ::fsync(fd_) != 0) fail(errno);
}

void DraftFile::publish() {
  const std::string folder = folder_of(path_);
  for (int number = 0; name_.empty(); ++number) {
    std::string name = fmt::format("{}/.mrsim-{}-{}", folder, ::getpid(), number);
    if (::linkat(AT_FDCWD, link_of(fd_).c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0)
      name_ = std::move(name);
    else if (errno != EEXIST)
      fail(errno);
  }
  if (::rename(name_.c_str(), path_.c_str()) != 0) fail(errno);
  name_.clear();
  sync_folder(folder);
}

}  // namespace mrsim
