// A file in the making: it appears under its name whole or not at all.
#pragma once

#include "core/output/output_place.h"
#include <mrsim/files.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace mrsim {

/// Before it is published nobody sees the file, and however the program ends, nothing of it is
/// left. File systems without unnamed files are the exception: there the draft lies beside its
/// place under a name that begins with .mrsim-; the destructor removes it, and where the program is
/// killed, the next run into that folder does (publish.h). Written bytes are sent to the disk
/// at once, so that finish() does not have to wait for all of them. What is meant for a device,
/// FIFO or socket is kept until it is published. Throws Error "output-folder", "output-unwritable",
/// "output-full".
class DraftFile {
 public:
  explicit DraftFile(const std::string& path);
  DraftFile(const DraftFile&) = delete;
  DraftFile& operator=(const DraftFile&) = delete;
  ~DraftFile();

  /// The path as it was given.
  const std::string& path() const { return place_.given; }
  const OutputPlace& place() const { return place_; }
  /// Appends.
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
  /// Bytes written so far.
  std::uint64_t size() const { return written_ + buffer_.size(); }
  /// SHA-256 of all bytes. Requires: finish() was called.
  std::string sha256() const;

  /// Takes its place alone; several drafts together: publish() in publish.h. Requires:
  /// finish() was called.
  void publish();
  /// Gets a name in its folder. Requires: its place is a file.
  void name_as(const std::string& name);
  /// Writes all bytes to its device, FIFO or socket. Requires: its place is one.
  void pour() const;

 private:
  bool open_nameless(const std::string& folder);
  void open_named();
  std::size_t read_at(char* data, std::size_t size, std::uint64_t offset) const;
  void write_at(const char* data, std::size_t size, std::uint64_t offset);
  void write_behind(const char* data, std::size_t size);
  void flush();
  [[noreturn]] void fail(int error) const { fail_output(path(), error); }

  OutputPlace place_;
  std::string name_;  ///< of the temporary file, empty where it has none
  std::string buffer_;
  int fd_ = -1;
  std::uint64_t written_ = 0, started_ = 0;  ///< bytes: in the file, on their way to the disk
};

}  // namespace mrsim
