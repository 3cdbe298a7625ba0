// Lines of a text file through one reused buffer, so that memory depends on the longest line and
// not on the length of the file.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace mrsim {

class LineSource {
 public:
  /// "-" is the standard input. The text of a pipe is needed more than once, so it is read as a
  /// whole and kept while the program runs. Throws Error "file-missing", "file-is-directory",
  /// "file-unreadable".
  explicit LineSource(const std::string& path, std::size_t chunk = std::size_t(1) << 17);
  LineSource(LineSource&& other) noexcept;
  LineSource& operator=(LineSource&&) = delete;
  ~LineSource();

  /// The next line without its end (\n, \r\n or \r); valid until the next call. False at the end.
  bool next(std::string_view& line);
  /// Up to `bytes` bytes that come next, which next() will still give; valid until the next call.
  std::string_view ahead(std::size_t bytes);
  /// Bytes of the whole file.
  std::uint64_t size() const { return size_; }
  /// Goes on at the start of a line that was read earlier.
  void seek(std::uint64_t offset, int line_number);

  /// Offset of the start of the next line, and the number of the last line returned (1-based).
  std::uint64_t next_offset() const { return buffer_offset_ + begin_; }
  int line_number() const { return line_; }

 private:
  bool refill();
  bool find_end(std::size_t& searched, std::size_t& length, std::size_t& end);

  int fd_ = -1;
  std::string path_;
  std::shared_ptr<const std::string> piped_;  ///< the text of a pipe, else null
  std::vector<char> buffer_;
  std::uint64_t buffer_offset_ = 0;  ///< offset in the file of buffer_[0]
  std::size_t begin_ = 0, end_ = 0;  ///< unread part of the buffer
  std::uint64_t lone_ = 0;           ///< offset behind a row of \r, each of which ends a line
  std::uint64_t size_ = 0;
  int line_ = 0;
};

}  // namespace mrsim
