// Work that may crash or never end, in a process of its own.
#pragma once

#include <mrsim/files.h>
#include <mrsim/types.h>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace mrsim {

struct ChildLimits {
  int seconds = 60;       ///< of processor time; four times as many by the clock
  std::size_t bytes = 0;  ///< of memory beyond what this process has, or what its limit leaves
  std::string what;       ///< what the process does, for messages: "reading a.step"
  /// Asked now and then with the seconds by the clock so far. False: the work is given up.
  std::function<bool(double seconds)> goes_on = {};
};

struct ChildOutcome {
  enum class End { done, crashed, too_long, out_of_memory };
  End end = End::done;
  std::string bytes;  ///< what `work` has handed to its sink; whole where `end` is done
};

/// Runs `work` in a copy of this process and collects the bytes that it writes. Whatever happens
/// there, a crash or an endless loop, this process goes on. `work` must not use other threads.
/// Throws Error "process" where the system gives no process, "memory" where the limit of this
/// process (memory_limit.h) leaves less than the work or its bytes take, "cancelled" where it is
/// given up.
ChildOutcome run_in_child(const ChildLimits& limits,
                          const std::function<void(const ByteSink& sink)>& work);

/// How long a started program lives. `ours`: it dies with this process and shares its streams;
/// `own`: it lives on and is silent.
enum class ProgramLife { ours, own };
/// Starts a program that is found by PATH, with the signals as a shell would set them. Its process,
/// or -1 where it can not be started.
int start_program(const std::vector<std::string>& words, ProgramLife life);

/// What the work hands back.
struct ChildParcel {
  std::vector<double> numbers;
  std::vector<std::string> texts;
  TriMesh mesh;  ///< its vertices and triangles
};

struct ChildDelivery {
  ChildOutcome::End end = ChildOutcome::End::done;
  ChildParcel parcel;  ///< where `end` is done
};

/// Does what run_in_child() does, and gives back what `work` returns. An Error that `work` throws
/// is thrown here.
ChildDelivery deliver_from_child(const ChildLimits& limits,
                                 const std::function<ChildParcel()>& work);

}  // namespace mrsim
