// A file for data that does not fit into memory. It has no name, so nothing is left of it however
// the run ends.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace mrsim {

/// $TMPDIR where that is a folder, else /tmp.
std::string temporary_folder();

class ScratchFile {
 public:
  /// Makes the file in `folder`. Throws Error "output-unwritable".
  explicit ScratchFile(const std::string& folder);
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;
  ~ScratchFile();

  /// Throws Error "output-full" where the disk is full, "output-unwritable".
  void append(const void* data, std::size_t size);
  /// Throws Error "output-unwritable" when the bytes can not be read back.
  void read(std::uint64_t offset, void* data, std::size_t size) const;
  std::uint64_t size() const { return size_; }
  void clear();

 private:
  [[noreturn]] void fail(int error) const;
  std::string folder_;
  int fd_ = -1;
  std::uint64_t size_ = 0;
};

}  // namespace mrsim
