#include "cli/console/shortage.h"

#include "cli/console/exit_codes.h"
#include <mrsim/types.h>

#include <cstdio>
#include <new>
#include <string_view>
#include <system_error>

#include <pthread.h>
#include <sys/resource.h>
#include <unistd.h>

namespace mrsim::cli {
namespace {

constexpr Shortage kMemory{"memory",
                           "memory ran out: free some, or raise its limit (ulimit -v); a run needs "
                           "less with a larger --voxel or --tolerance"};
constexpr Shortage kThreads{"threads",
                            "the system gives no more threads: fewer --threads, or a higher limit "
                            "of threads or memory"};

std::terminate_handler other_ends = nullptr;

bool has_threads() {
  pthread_t thread{};
  const auto nothing = [](void*) -> void* { return nullptr; };
  if (::pthread_create(&thread, nullptr, nothing, nullptr) != 0) return false;
  ::pthread_join(thread, nullptr);
  return true;
}

const Shortage* shortage_at_end() {
  const std::exception_ptr thrown = std::current_exception();
  // Without an exception: threads were left behind when the next one could not be started.
  if (!thrown) return has_threads() ? nullptr : &kThreads;
  try {
    std::rethrow_exception(thrown);
  } catch (const std::exception& error) {
    return find_shortage(error);
  } catch (...) {
    return nullptr;
  }
}

void end() {
  const Shortage* shortage = shortage_at_end();
  if (!shortage) other_ends();
  // Nothing here asks for memory.
  std::fprintf(stderr, "mrsim: error: %s [%s]\n", shortage->text, shortage->code);
  ::_exit(kFailed);  // drafts have no names
}

}  // namespace

const Shortage* find_shortage(const std::exception& error) {
  if (dynamic_cast<const std::bad_alloc*>(&error)) return &kMemory;
  const auto* system = dynamic_cast<const std::system_error*>(&error);
  if (system && system->code() == std::errc::resource_unavailable_try_again) return &kThreads;
  const bool by_tbb = std::string_view(error.what()).starts_with("pthread_create has failed");
  return by_tbb ? &kThreads : nullptr;
}

void catch_shortages() { other_ends = std::set_terminate(end); }

void require_stack() {
  constexpr rlim_t kLeast = rlim_t(1) << 20;
  rlimit limit{};
  if (::getrlimit(RLIMIT_STACK, &limit) == 0 && limit.rlim_cur < kLeast)
    throw Error("memory", "a run needs a stack of 1 MB: raise its limit (ulimit -s)");
}

}  // namespace mrsim::cli
