// The near end of a device, FIFO or socket, for an output that is written to it.
#pragma once

#include "core/output/output_place.h"

#include <cstddef>

namespace mrsim {

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
