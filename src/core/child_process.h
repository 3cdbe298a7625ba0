// Work that may crash or never end, in a process of its own.
#pragma once

#include <mrsim/files.h>

#include <cstddef>
#include <functional>
#include <string>

namespace mrsim {

struct ChildLimits {
  int seconds = 60;       ///< of processor time; four times as many by the clock
  std::size_t bytes = 0;  ///< of memory beyond what this process has
};

struct ChildOutcome {
  enum class End { done, crashed, too_long, out_of_memory };
  End end = End::done;
  std::string bytes;  ///< what `work` has handed to its sink; whole where `end` is done
};

/// Runs `work` in a copy of this process and collects the bytes that it writes. Whatever happens
/// there, a crash or an endless loop, this process goes on. `work` must not use other threads.
/// Throws Error "process" where the system gives no process.
ChildOutcome run_in_child(const ChildLimits& limits,
                          const std::function<void(const ByteSink& sink)>& work);

}  // namespace mrsim
