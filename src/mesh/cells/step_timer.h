// Seconds by step of the mesher, and a sign of life after each.
#pragma once

#include "core/process/error.h"
#include "mesh/cells/mesh_report.h"

#include <chrono>
#include <utility>

namespace mrsim::detail {

/// The number of rounds is not known in advance: the share done is estimated from how long all may
/// take, and approaches 1.
class StepTimer {
 public:
  StepTimer(MeshReport& report, Progress progress)
      : report_(report), progress_(std::move(progress)), begin_(Clock::now()), step_begin_(begin_) {
    tell();
  }

  /// Seconds that what comes will take, about.
  void expect(double seconds) { expected_ = since(begin_) + seconds; }

  /// Ends a step. Throws Error "cancelled" when the caller wants no more.
  void step(const char* name) {
    tell();
    const double seconds = since(step_begin_);
    step_begin_ = Clock::now();
    for (auto& [known, sum] : report_.seconds)
      if (known == name) {
        sum += seconds;
        return;
      }
    report_.seconds.emplace_back(name, seconds);
  }

 private:
  using Clock = std::chrono::steady_clock;
  static double since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
  }
  void tell() const {
    if (progress_ && !progress_("meshing", share()))
      throw Error("cancelled", "the run was stopped");
  }
  // Follows the time up to one half, then goes slower, since more time may be needed than expected.
  double share() const {
    if (expected_ <= 0) return 0;
    const double x = since(begin_) / expected_;
    return x < 0.5 ? x : 1 - 0.25 / x;
  }

  MeshReport& report_;
  Progress progress_;
  double expected_ = 0;  // seconds from the beginning
  Clock::time_point begin_, step_begin_;
};

}  // namespace mrsim::detail
