// How much memory the process may use while this thread works. Stages that read or write large data
// ask before they allocate, so that too much is an Error and not a crash.
//
// Callers estimate what they need. Memory that nobody asks for is not limited.
#pragma once

#include <cstddef>
#include <string>

namespace mrsim {

/// Bytes that every process takes before it reads anything: code, stacks, libraries.
inline constexpr double kProgramMemory = 10e6;

/// While this object lives, require_memory() on this thread keeps the whole process to `bytes`; 0
/// means what is in use now plus what the machine has free. Limits may be nested; the inner one
/// holds.
class MemoryLimit {
 public:
  explicit MemoryLimit(std::size_t bytes);
  MemoryLimit(const MemoryLimit&) = delete;
  MemoryLimit& operator=(const MemoryLimit&) = delete;
  ~MemoryLimit();

 private:
  std::size_t outer_;
};

/// MemoryLimit for the rest of the thread's life.
void set_thread_limit(std::size_t bytes);

/// Throws Error "memory" where `bytes` more would exceed the limit. Both texts go into the message:
/// `what` needs the memory ("reading a.stl"), `advice` says how to need less. Does nothing without
/// a limit.
void require_memory(double bytes, const std::string& what, const std::string& advice = "");

/// The part of the limit that is not in use yet, in bytes; infinity without a limit.
double memory_left();

/// "684 bytes", "38.6 MB": an amount of memory, or the size of a file.
std::string size_text(double bytes);

/// Gives memory that was freed back to the machine: after a stage whose memory is of no use to the
/// next one, whose peak would come on top of it.
void release_freed_memory();

/// The most memory that the process has held at any time, in bytes.
std::size_t peak_memory();

/// Whether the process may still map that many bytes at once (ulimit -v).
bool has_address_space(std::size_t bytes);
/// Whether its address space has a limit.
bool is_address_space_limited();

/// Throws Error "memory" where the address space has a limit and too little of it is free for that
/// many threads to start. No error can be raised later: the C library ends the process where the
/// first object of a thread does not fit.
void require_address_space(int threads);

}  // namespace mrsim
