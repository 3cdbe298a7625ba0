#include "cli/console/stop.h"

#include "cli/console/temporary_place.h"
#include "core/process/memory_limit.h"

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <mutex>
#include <system_error>
#include <thread>

#include <poll.h>
#include <unistd.h>

namespace mrsim::cli {
namespace {

// A stop takes at most a second. kGrace, ns: time for the run to end in order. kWords, ns: time for
// its last words, which wait for the disk. The rest is for the system, which takes the memory back:
// 0.1 s for each GB on an idle machine. So a run with much memory has less grace.
constexpr long kGrace = 200'000'000, kWords = 300'000'000;

timespec grace() {
  const double gigabytes = static_cast<double>(peak_memory()) / 1e9;
  return {0, static_cast<long>(static_cast<double>(kGrace) / (1 + gigabytes))};
}

std::atomic<int> stopped = 0;
std::atomic<bool> is_written = false;
std::mutex words_mutex;
std::function<void(int)> last_words;

sigset_t stop_signals() {
  sigset_t out;
  ::sigemptyset(&out);
  ::sigaddset(&out, SIGINT);
  ::sigaddset(&out, SIGTERM);
  struct sigaction hangup {};
  ::sigaction(SIGHUP, nullptr, &hangup);
  if (hangup.sa_handler != SIG_IGN) ::sigaddset(&out, SIGHUP);  // ignored under nohup
  return out;
}

// Lets the printed text end with a whole line, because programs read JSON line by line. Gives up
// after 20 ms if nobody reads the output.
void end_line() {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::milliseconds(20);
  while (::ftrylockfile(stdout) != 0)  // the lock is kept, so that nothing is printed from here on
    if (Clock::now() > end) return;
  pollfd out{STDOUT_FILENO, POLLOUT, 0};
  if (::poll(&out, 1, 0) == 1) std::fflush(stdout);
}

[[noreturn]] void end_now(int code) {
  end_line();
  remove_temporary_places();
  std::fputs(is_written ? "mrsim: stopped\n" : "mrsim: stopped; nothing was written\n", stderr);
  ::_exit(code);
}

// `timeout`, for one, sends its signal to the process and to the group of it: that is one stop, not
// an impatient second.
void drop_twins(const sigset_t& set) {
  const timespec moment{0, 30'000'000}, none{0, 0};
  ::nanosleep(&moment, nullptr);
  while (::sigtimedwait(&set, nullptr, &none) > 0) {
  }
}

void wait_for_signals() {
  const sigset_t set = stop_signals();
  int signal = 0;
  while (::sigwait(&set, &signal) != 0) {
  }
  const int code = 128 + signal;
  stopped = code;
  drop_twins(set);
  const timespec in_order = grace();
  if (::sigtimedwait(&set, nullptr, &in_order) > 0) end_now(code);
  // The words are said beside this thread, so that they cannot hold up the end.
  std::thread([code] {
    const std::lock_guard<std::mutex> lock(words_mutex);
    if (last_words) last_words(code);
    end_now(code);
  }).detach();
  const timespec for_words{0, kWords};
  ::sigtimedwait(&set, nullptr, &for_words);
  end_now(code);
}

}  // namespace

void watch_signals() {
  const sigset_t set = stop_signals();
  sigset_t blocked = set;
  ::sigaddset(&blocked, SIGPIPE);  // a write fails instead (standard_streams.cpp)
  ::pthread_sigmask(SIG_BLOCK, &blocked, nullptr);
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
