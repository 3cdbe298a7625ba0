#include "interp/text/source.h"

#include "core/process/error.h"
#include "core/process/memory_limit.h"
#include "core/text/text_io.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <map>
#include <mutex>
#include <tuple>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

namespace mrsim {
namespace {

constexpr std::size_t kLongLine = std::size_t(1) << 20;

[[noreturn]] void fail(const std::string& path) {
  if (errno == ENOENT || errno == ENOTDIR)
    throw Error("file-missing", fmt::format("{}: no such file", path));
  throw Error("file-unreadable", fmt::format("cannot read {}: {}", path, std::strerror(errno)));
}

// A pipe gives its text only once, so the text is kept by the identity of its file.
std::shared_ptr<const std::string> read_pipe(const std::string& path, const struct stat& info) {
  using Key = std::tuple<std::string, dev_t, ino_t>;
  static std::mutex mutex;
  static std::map<Key, std::shared_ptr<const std::string>> texts;
  const std::lock_guard<std::mutex> lock(mutex);
  std::shared_ptr<const std::string>& text = texts[{path, info.st_dev, info.st_ino}];
  if (!text) text = std::make_shared<const std::string>(read_file(path));
  return text;
}

// Removes the leader of a tape (NUL, DEL), the characters that start and stop a transfer (DC1 to
// DC4) and form feeds from the ends of a line.
std::string_view without_transfer(std::string_view line) {
  const auto transfers = [](char c) {
    return c == '\0' || c == '\f' || c == '\x7F' || (c >= '\x11' && c <= '\x14');
  };
  while (!line.empty() && transfers(line.front())) line.remove_prefix(1);
  while (!line.empty() && transfers(line.back())) line.remove_suffix(1);
  return line;
}

}  // namespace

LineSource::LineSource(const std::string& name, std::size_t chunk)
    : path_(name == "-" ? "/dev/stdin" : name) {
  const std::string& path = path_;
  struct stat info {};
  if (::stat(path.c_str(), &info) != 0) fail(path);
  if (S_ISDIR(info.st_mode))
    throw Error("file-is-directory", fmt::format("{} is a directory, a file is needed", path));
  if (!S_ISREG(info.st_mode)) {
    piped_ = read_pipe(path, info);
    size_ = piped_->size();
  } else {
    fd_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (fd_ < 0) fail(path);
    size_ = static_cast<std::uint64_t>(info.st_size);
  }
  buffer_.resize(chunk);
}

LineSource::LineSource(LineSource&& other) noexcept
    : fd_(std::exchange(other.fd_, -1)),
      path_(std::move(other.path_)),
      piped_(std::move(other.piped_)),
      buffer_(std::move(other.buffer_)),
      buffer_offset_(other.buffer_offset_),
      begin_(other.begin_),
      end_(other.end_),
      lone_(other.lone_),
      size_(other.size_),
      line_(other.line_) {}

LineSource::~LineSource() {
  if (fd_ >= 0) ::close(fd_);
}

std::string_view LineSource::ahead(std::size_t bytes) {
  while (end_ - begin_ < bytes && refill()) {
  }
  return {buffer_.data() + begin_, std::min(bytes, end_ - begin_)};
}

void LineSource::seek(std::uint64_t offset, int line_number) {
  line_ = line_number;
  lone_ = 0;
  if (offset >= buffer_offset_ && offset <= buffer_offset_ + end_) {
    begin_ = static_cast<std::size_t>(offset - buffer_offset_);
    return;
  }
  buffer_offset_ = offset;
  begin_ = end_ = 0;
}

bool LineSource::refill() {
  // At the end all stays where it is, so that a subprogram in the last lines is not read again for
  // each call. Some files of the system have a size of 0 and a text.
  if (size_ > 0 && buffer_offset_ + end_ >= size_) return false;
  if (begin_ > 0) {
    std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
    buffer_offset_ += begin_;
    end_ -= begin_;
    begin_ = 0;
  }
  if (end_ == buffer_.size()) {
    if (end_ > kLongLine)  // measured: reading it takes three times its length
      require_memory(5.0 * double(end_), fmt::format("a line of more than {} bytes", end_));
    buffer_.resize(2 * buffer_.size());
  }
  const std::uint64_t from = buffer_offset_ + end_;
  if (piped_) {
    const std::size_t left = from < piped_->size() ? piped_->size() - from : 0;
    const std::size_t n = std::min(left, buffer_.size() - end_);
    std::memcpy(buffer_.data() + end_, piped_->data() + from, n);
    end_ += n;
    return n > 0;
  }
  for (;;) {
    const ssize_t n =
        ::pread(fd_, buffer_.data() + end_, buffer_.size() - end_, static_cast<off_t>(from));
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) fail(path_);
    end_ += static_cast<std::size_t>(n);
    return n > 0;
  }
}

// Finds the length of the line that begins at begin_, and that of its end: \n, \r, or any \r before
// \n. False: more must be read first. `searched`: so many bytes of the line have no end in them.
bool LineSource::find_end(std::size_t& searched, std::size_t& length, std::size_t& end) {
  const char* from = buffer_.data() + begin_;
  const std::size_t available = end_ - begin_;
  if (next_offset() < lone_) {
    length = 0;
    end = 1;
    return true;
  }
  if (available == searched) return false;
  const void* feed = std::memchr(from + searched, '\n', available - searched);
  const std::size_t limit =
      feed ? static_cast<std::size_t>(static_cast<const char*>(feed) - from) : available;
  const void* back = std::memchr(from + searched, '\r', limit - searched);
  if (!back) {
    searched = limit;
    length = limit;
    end = 1;
    return feed != nullptr;
  }
  length = static_cast<std::size_t>(static_cast<const char*>(back) - from);
  searched = length;
  std::size_t behind = length;
  while (behind < limit && from[behind] == '\r') ++behind;
  if (behind == available) return false;
  end = behind == limit ? behind + 1 - length : 1;
  if (behind < limit) lone_ = next_offset() + behind;
  return true;
}

bool LineSource::next(std::string_view& line) {
  std::size_t searched = 0, length = 0, end = 0;
  while (!find_end(searched, length, end)) {
    if (refill()) continue;
    const std::size_t available = end_ - begin_;
    if (available == 0) return false;
    length = available;  // the last line, with or without \r
    if (searched < available) length = searched;
    end = length < available ? 1 : 0;
    lone_ = next_offset() + available;
    break;
  }
  line = std::string_view(buffer_.data() + begin_, length);
  begin_ += length + end;
  if (line_ == 0 && line.starts_with("\xEF\xBB\xBF")) line.remove_prefix(3);
  line = without_transfer(line);
  ++line_;
  return true;
}

}  // namespace mrsim
