// Runs work in parts: several threads make them at once, and they are taken in their order.
#pragma once

#include "core/process/parallel.h"

#include <algorithm>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <mutex>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace mrsim {

namespace detail {

/// A run of make_in_order(): its parts, and how far they are begun, made and taken.
template <typename Make, typename Take>
class OrderedParts {
 public:
  OrderedParts(std::size_t count, std::size_t workers, std::size_t together, Make& make, Take& take)
      : count_(count),
        together_(together),
        make_(make),
        take_(take),
        parts_(2 * (together + workers) - 2),
        done_(parts_.size(), 0) {}

  /// What each thread does until all parts are taken or one has failed.
  void work() {
    Lock lock(mutex_);
    try {
      while (taken_ < count_ && !failed_) {
        if (may_take()) {
          take_some(lock);
        } else if (next_ < count_ && next_ < taken_ + parts_.size()) {
          make_next(lock);
        } else {
          changed_.wait(lock);
          continue;
        }
        changed_.notify_all();
      }
    } catch (...) {
      if (!lock.owns_lock()) lock.lock();
      failed_ = true;
      changed_.notify_all();
      throw;
    }
  }

 private:
  using Lock = std::unique_lock<std::mutex>;
  struct Part {
    std::optional<std::invoke_result_t<Make&, std::size_t>> made;
    std::exception_ptr error;
  };

  bool may_take() const {
    return !is_taking_ && (ready_ >= taken_ + together_ || (ready_ == count_ && ready_ > taken_));
  }

  void make_next(Lock& lock) {
    const std::size_t k = next_++;
    lock.unlock();
    Part& part = parts_[k % parts_.size()];
    try {
      part.made.emplace(make_(k));
    } catch (...) {
      part.error = std::current_exception();
    }
    lock.lock();
    done_[k % parts_.size()] = 1;
    while (ready_ < next_ && done_[ready_ % parts_.size()]) ++ready_;
  }

  void take_some(Lock& lock) {
    const std::size_t first = taken_, end = std::min(first + together_, ready_);
    is_taking_ = true;
    lock.unlock();
    for (std::size_t k = first; k < end; ++k) {
      Part part = std::move(parts_[k % parts_.size()]);
      parts_[k % parts_.size()] = {};
      if (part.error) std::rethrow_exception(part.error);
      take_(std::move(*part.made));
    }
    lock.lock();
    for (std::size_t k = first; k < end; ++k) done_[k % parts_.size()] = 0;
    taken_ = end;
    is_taking_ = false;
  }

  const std::size_t count_, together_;
  Make& make_;
  Take& take_;
  std::vector<Part> parts_;  // of part k: number k modulo its size
  std::mutex mutex_;         // of all below
  std::vector<char> done_;
  std::condition_variable changed_;
  std::size_t next_ = 0, ready_ = 0, taken_ = 0;  // first part not begun, not done, not taken
  bool is_taking_ = false, failed_ = false;
};

}  // namespace detail

/// Calls take(make(k)) for k = 0, 1, ... count - 1, one after another, while other threads make
/// later parts. A thread waits only where there is nothing else to do. Parts are taken `together`
/// at a time, as soon as that many are ready. At most twice as many parts, and two for each thread,
/// exist at once. Throws what the first faulty part throws.
template <typename Make, typename Take>
void make_in_order(std::size_t count, int threads, Make make, Take take, std::size_t together = 1) {
  const std::size_t workers = std::min(static_cast<std::size_t>(resolve_threads(threads)), count);
  detail::OrderedParts<Make, Take> parts(count, workers, together, make, take);
  parallel_for(workers, threads, [&](std::size_t) { parts.work(); });
}

}  // namespace mrsim
