#include "core/text/text_io.h"

#include "core/output/publish.h"
#include "core/process/error.h"
#include "core/process/memory_limit.h"

#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <mutex>
#include <set>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

namespace mrsim {
namespace {

constexpr std::size_t kMostOfPipe = std::size_t(256) << 20;

class FileDescriptor {
 public:
  explicit FileDescriptor(int fd) : fd_(fd) {}
  FileDescriptor(const FileDescriptor&) = delete;
  FileDescriptor& operator=(const FileDescriptor&) = delete;
  ~FileDescriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  int get() const { return fd_; }

 private:
  int fd_;
};

// Length of the UTF-8 sequence at the head of `s`, 0 when it is not one (overlong forms and
// surrogates included).
std::size_t utf8_sequence(std::string_view s) {
  const auto at = [&](std::size_t i) { return static_cast<unsigned char>(s[i]); };
  const unsigned lead = at(0);
  if (lead < 0x80) return 1;
  const std::size_t n = lead >= 0xC2 && lead < 0xE0   ? 2
                        : lead >= 0xE0 && lead < 0xF0 ? 3
                        : lead >= 0xF0 && lead < 0xF5 ? 4
                                                      : 0;
  if (n == 0 || s.size() < n) return 0;
  for (std::size_t i = 1; i < n; ++i)
    if ((at(i) & 0xC0) != 0x80) return 0;
  const unsigned second = at(1);
  if ((lead == 0xE0 && second < 0xA0) || (lead == 0xED && second > 0x9F) ||
      (lead == 0xF0 && second < 0x90) || (lead == 0xF4 && second > 0x8F))
    return 0;
  return n;
}

// ISO 8859-2, code points of the bytes 0xA0 to 0xFF.
constexpr std::array<char16_t, 96> kLatin2 = {
    0x00A0, 0x0104, 0x02D8, 0x0141, 0x00A4, 0x013D, 0x015A, 0x00A7, 0x00A8, 0x0160, 0x015E, 0x0164,
    0x0179, 0x00AD, 0x017D, 0x017B, 0x00B0, 0x0105, 0x02DB, 0x0142, 0x00B4, 0x013E, 0x015B, 0x02C7,
    0x00B8, 0x0161, 0x015F, 0x0165, 0x017A, 0x02DD, 0x017E, 0x017C, 0x0154, 0x00C1, 0x00C2, 0x0102,
    0x00C4, 0x0139, 0x0106, 0x00C7, 0x010C, 0x00C9, 0x0118, 0x00CB, 0x011A, 0x00CD, 0x00CE, 0x010E,
    0x0110, 0x0143, 0x0147, 0x00D3, 0x00D4, 0x0150, 0x00D6, 0x00D7, 0x0158, 0x016E, 0x00DA, 0x0170,
    0x00DC, 0x00DD, 0x0162, 0x00DF, 0x0155, 0x00E1, 0x00E2, 0x0103, 0x00E4, 0x013A, 0x0107, 0x00E7,
    0x010D, 0x00E9, 0x0119, 0x00EB, 0x011B, 0x00ED, 0x00EE, 0x010F, 0x0111, 0x0144, 0x0148, 0x00F3,
    0x00F4, 0x0151, 0x00F6, 0x00F7, 0x0159, 0x016F, 0x00FA, 0x0171, 0x00FC, 0x00FD, 0x0163, 0x02D9};

bool is_utf8(std::string_view s) {
  while (!s.empty()) {
    const std::size_t n = utf8_sequence(s);
    if (n == 0) return false;
    s.remove_prefix(n);
  }
  return true;
}

bool looks_like_number(std::string_view text, bool exponent) {
  std::size_t digits = 0, dots = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c >= '0' && c <= '9') {
      ++digits;
    } else if (c == '.') {
      if (++dots > 1) return false;
    } else if ((c == 'e' || c == 'E') && exponent && digits > 0) {
      return true;  // from_chars judges the rest
    } else {
      return false;
    }
  }
  return digits > 0;
}

// Pipes that have been read to their end. They may never be filled again, and opening one then
// waits for a writer.
class ReadPipes {
 public:
  bool contains(const struct stat& info) {
    const std::lock_guard<std::mutex> lock(mutex_);
    return S_ISFIFO(info.st_mode) && all_.contains({info.st_dev, info.st_ino});
  }
  void add(const struct stat& info) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (S_ISFIFO(info.st_mode)) all_.emplace(info.st_dev, info.st_ino);
  }

 private:
  std::mutex mutex_;
  std::set<std::pair<dev_t, ino_t>> all_;
};

ReadPipes& read_pipes() {
  static ReadPipes& all = *new ReadPipes;  // outlives all threads
  return all;
}

// By what errno says.
[[noreturn]] void fail_unreadable(const std::string& path) {
  throw Error("file-unreadable", fmt::format("cannot read {}: {}", path, std::strerror(errno)));
}

[[noreturn]] void fail_read_once(const std::string& path) {
  throw Error(
      "file-read-once",
      fmt::format("{} is a pipe and gives its text once, which has been read; store it in a file",
                  path));
}

[[noreturn]] void fail_too_large(const std::string& path, const struct stat& info,
                                 std::size_t most) {
  throw Error("file-too-large",
              S_ISREG(info.st_mode)
                  ? fmt::format("{} is larger than {} bytes", path, most)
                  : fmt::format("{} is no file and gives more than {} bytes; store in a file what "
                                "is meant to be read",
                                path, most));
}

int open_to_read(const std::string& path, int flags) {
  const int fd = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | flags);
  if (fd >= 0) return fd;
  if (errno == ENOENT || errno == ENOTDIR)
    throw Error("file-missing", fmt::format("{}: no such file", path));
  fail_unreadable(path);
}

}  // namespace

std::optional<double> parse_number(std::string_view text, bool exponent) {
  bool negative = false;
  if (!text.empty() && (text[0] == '+' || text[0] == '-')) {
    negative = text[0] == '-';
    text.remove_prefix(1);
  }
  if (!looks_like_number(text, exponent)) return std::nullopt;
  double value = 0;
  const auto format = exponent ? std::chars_format::general : std::chars_format::fixed;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, format);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
    return std::nullopt;
  return negative ? -value : value;
}

std::string read_file(const std::string& path, std::size_t limit) {
  struct stat info {};
  bool was_read = ::stat(path.c_str(), &info) == 0 && read_pipes().contains(info);
  const FileDescriptor fd(open_to_read(path, was_read ? O_NONBLOCK : 0));
  if (::fstat(fd.get(), &info) != 0) fail_unreadable(path);
  if (S_ISDIR(info.st_mode))
    throw Error("file-is-directory", fmt::format("{} is a directory, a file is needed", path));
  // A pipe or a device may never end.
  if (!S_ISREG(info.st_mode)) limit = std::min(limit, kMostOfPipe);
  require_memory(static_cast<double>(std::max<off_t>(info.st_size, 0)), "reading " + path);
  std::string text;
  text.reserve(
      std::min<std::size_t>(static_cast<std::size_t>(std::max<off_t>(info.st_size, 0)), limit) + 1);
  std::vector<char> chunk(std::size_t(1) << 18);
  for (;;) {
    const ssize_t n = ::read(fd.get(), chunk.data(), chunk.size());
    if (n < 0 && errno == EINTR) continue;
    if (n == 0 && was_read) fail_read_once(path);
    if (was_read) {  // there is a writer again
      was_read = false;
      ::fcntl(fd.get(), F_SETFL, 0);
      if (n < 0 && errno == EAGAIN) continue;
    }
    if (n < 0) fail_unreadable(path);
    if (n == 0) {
      read_pipes().add(info);
      return text;
    }
    if (text.size() + static_cast<std::size_t>(n) > limit) fail_too_large(path, info, limit);
    if (text.size() + static_cast<std::size_t>(n) > text.capacity())
      // Twice as much room, beside the room that smaller ones have left in the heap.
      require_memory(3.0 * static_cast<double>(text.capacity()), "reading " + path);
    text.append(chunk.data(), static_cast<std::size_t>(n));
  }
}

void write_files_atomically(std::span<const OutputFile> files) {
  std::vector<std::unique_ptr<DraftFile>> drafts;
  drafts.reserve(files.size());
  for (const OutputFile& file : files) {
    drafts.push_back(std::make_unique<DraftFile>(file.path));
    file.writer(drafts.back()->sink());
    drafts.back()->finish();
  }
  std::vector<DraftFile*> all;
  all.reserve(drafts.size());
  for (const auto& draft : drafts) all.push_back(draft.get());
  publish(all);
}

void write_file_atomically(const std::string& path,
                           const std::function<void(const ByteSink&)>& writer) {
  const OutputFile file{path, writer};
  write_files_atomically({&file, 1});
}

std::string to_utf8(std::string_view bytes) {
  if (is_utf8(bytes)) return std::string(bytes);
  std::string out;
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    const unsigned code = byte < 0xA0 ? byte : kLatin2[byte - 0xA0];
    if (code < 0x80) {
      out += static_cast<char>(code);
    } else {
      out += static_cast<char>(0xC0 | (code >> 6));
      out += static_cast<char>(0x80 | (code & 0x3F));
    }
  }
  return out;
}

std::string xml_escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '"')
      out += "&quot;";
    else
      out += static_cast<unsigned char>(c) >= ' ' || c == '\n' || c == '\t' ? c : ' ';
  }
  return out;
}

}  // namespace mrsim
