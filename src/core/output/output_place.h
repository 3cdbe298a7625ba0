// Where the bytes of an output go: a regular file is replaced, a device, FIFO or socket is written
// to. An output that would replace an input or another output is refused.
#pragma once

#include <mrsim/files.h>

#include <cstddef>
#include <span>
#include <string>

namespace mrsim {

/// A regular file, which is replaced as a whole, or a device, FIFO or socket, which is written to.
struct OutputPlace {
  enum class Kind { file, stream };
  Kind kind = Kind::file;
  std::string given;    ///< as typed
  std::string path;     ///< absolute, links followed
  std::string folder;   ///< of `path`
  int descriptor = -1;  ///< of this process, for "-", /dev/stdout, /dev/fd/N; else -1
};

/// Follows symbolic links, dangling ones too; "-" is the standard output. Throws Error
/// "output-folder" (the folder is missing) and "output-unwritable" (no name, a directory, a circle
/// of links).
OutputPlace output_place(const std::string& path);

/// Throws Error "output-unwritable" where a draft could be made beside the place but not renamed to
/// it, nor removed: by attributes of the folder or file (chattr), or because the file is mounted.
/// Requires: `place` is a file.
void check_replaceable(const OutputPlace& place);

/// Throws what a DraftFile would throw for a place where no file can be made, before any work.
void check_writable(const std::string& path);

/// Throws Error "output-is-input" or "output-twice", of kind usage, that names both, where an
/// output is the same file as an input or as another output: by name or through a link. Two outputs
/// may go to one device, as /dev/null.
void refuse_overwrites(std::span<const NamedPath> outputs, std::span<const NamedPath> inputs);

/// The folder of a path, "." where it names none.
std::string folder_of(const std::string& path);

/// Throws Error "output-full" or "output-unwritable" for an errno.
[[noreturn]] void fail_output(const std::string& path, int error);

/// The near end of a device, FIFO or socket, for an output that is written to it.
class StreamEnd {
 public:
  /// Opens `place`; of a FIFO, waits for its reader. Throws what write() throws.
  explicit StreamEnd(const OutputPlace& place);
  StreamEnd(const StreamEnd&) = delete;
  StreamEnd& operator=(const StreamEnd&) = delete;
  ~StreamEnd();

  /// Throws Error "output-full" or "output-unwritable", also where the reader has gone.
  void write(const char* data, std::size_t size);

 private:
  const OutputPlace& place_;
  int fd_ = -1;
};

}  // namespace mrsim
