// Seconds by step of the mesher, and a sign of life after each.
#pragma once

#include "core/error.h"
#include "mesh/surface/mesh_report.h"

#include <chrono>
#include <utility>

namespace mrsim::detail {

/// How many rounds there will be is not known: the share done approaches 1.
class StepTimer {
 public:
  StepTimer(MeshReport& report, Progress progress)
      : report_(report), progress_(std::move(progress)), start_(Clock::now()) {}
  /// Ends a step. Throws Error "cancelled" when the caller wants no more.
  void step(const char* name) {
    done_ += kStepShare * (1 - done_);
    if (progress_ && !progress_("meshing", done_)) throw Error("cancelled", "the run was stopped");
    const auto now = Clock::now();
    const double seconds = std::chrono::duration<double>(now - start_).count();
    start_ = now;
    for (auto& [known, sum] : report_.seconds)
      if (known == name) {
        sum += seconds;
        return;
      }
    report_.seconds.emplace_back(name, seconds);
  }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr double kStepShare = 0.15;
  MeshReport& report_;
  Progress progress_;
  double done_ = 0;
  Clock::time_point start_;
};

}  // namespace mrsim::detail
