// A file in the making: it appears under its name whole or not at all.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace mrsim {

/// Takes the bytes of an output file, in order.
using ByteSink = std::function<void(const void* data, std::size_t size)>;

/// Until publish() nothing is seen of it, and nothing is left of it however the program ends, where
/// the file system has files without a name; elsewhere it lies beside `path` under a name that
/// begins with .mrsim-, and goes away with this object. What is written goes on its way to the disk
/// at once, so that finish() need not wait for all of it. Throws Error "output-folder",
/// "output-unwritable", "output-full".
class DraftFile {
 public:
  explicit DraftFile(const std::string& path);
  DraftFile(const DraftFile&) = delete;
  DraftFile& operator=(const DraftFile&) = delete;
  ~DraftFile();

  const std::string& path() const { return path_; }
  /// Behind what was written before.
  void append(const void* data, std::size_t size);
  ByteSink sink() {
    return [this](const void* data, std::size_t size) { append(data, size); };
  }
  /// Replaces bytes at the file's beginning. Requires: they have been written.
  void patch(std::string_view bytes);
  /// Forgets all that was written.
  void clear();
  /// The bytes are on the disk, with the mode of the file that they replace.
  void finish();
  /// Takes the place of `path`. Requires: finish() was called.
  void publish();

 private:
  bool open_nameless(const std::string& folder);
  void write_at(const char* data, std::size_t size, std::uint64_t offset);
  void write_behind(const char* data, std::size_t size);
  void flush();
  [[noreturn]] void fail(int error) const;

  std::string path_, name_;  ///< name_: of the temporary file, empty where it has none
  std::string buffer_;
  int fd_ = -1;
  std::uint64_t written_ = 0, started_ = 0;  ///< bytes: in the file, on their way to the disk
};

}  // namespace mrsim
