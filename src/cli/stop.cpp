#include "cli/stop.h"

#include "cli/temporary_place.h"

#include <atomic>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <mutex>
#include <system_error>
#include <thread>

#include <unistd.h>

namespace mrsim::cli {
namespace {

// ns in which the run may end in order, then say its last words; what is left of the second goes to
// the system, which takes the memory back.
constexpr long kGrace = 400'000'000, kWords = 100'000'000;

std::atomic<int> stopped = 0;
std::atomic<bool> is_written = false;
std::mutex words_mutex;
std::function<void(int)> last_words;

sigset_t stop_signals() {
  sigset_t out;
  ::sigemptyset(&out);
  ::sigaddset(&out, SIGINT);
  ::sigaddset(&out, SIGTERM);
  return out;
}

[[noreturn]] void end_now(int code) {
  remove_temporary_places();
  std::fputs(is_written ? "mrsim: stopped\n" : "mrsim: stopped; nothing was written\n", stderr);
  ::_exit(code);
}

void wait_for_signals() {
  const sigset_t set = stop_signals();
  int signal = 0;
  while (::sigwait(&set, &signal) != 0) {
  }
  const int code = 128 + signal;
  stopped = code;
  const timespec grace{0, kGrace};
  if (::sigtimedwait(&set, nullptr, &grace) > 0) end_now(code);
  // The words are said beside this thread, so that they cannot hold up the end.
  std::thread([code] {
    const std::lock_guard<std::mutex> lock(words_mutex);
    if (last_words) last_words(code);
    end_now(code);
  }).detach();
  const timespec little{0, kWords};
  ::sigtimedwait(&set, nullptr, &little);
  end_now(code);
}

}  // namespace

void watch_signals() {
  const sigset_t set = stop_signals();
  ::pthread_sigmask(SIG_BLOCK, &set, nullptr);
  try {
    std::thread(wait_for_signals).detach();
  } catch (const std::system_error&) {  // no thread: signals end the process at once
    ::pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
  }
}

int stop_code() { return stopped; }

void set_last_words(std::function<void(int code)> say) {
  const std::lock_guard<std::mutex> lock(words_mutex);
  last_words = std::move(say);
}

void all_is_written() { is_written = true; }

}  // namespace mrsim::cli
