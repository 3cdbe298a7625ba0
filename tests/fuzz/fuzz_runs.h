// Whole runs of fuzz targets, and what every one of them has to keep.
#pragma once

#include "fuzz_files.h"
#include <mrsim/mrsim.h>

#include <chrono>
#include <cmath>
#include <cstddef>

namespace mrsim::fuzz {

/// One thread, voxels of 2 mm, so much memory and 3 s, far above what a run of this size takes; one
/// that does not ask is found by -timeout.
inline void limit(Job& job, std::size_t megabytes) {
  job.carve.voxel = 2;
  job.carve.threads = job.mesh.threads = job.collisions.threads = 1;
  job.carve.max_memory = megabytes << 20;
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(3);
  job.carve.progress = job.mesh.progress = job.collisions.progress = job.stock_options.progress =
      [end](const char*, double) { return std::chrono::steady_clock::now() < end; };
}

/// A part whose mesh keeps its promises, or diagnostics.
inline JobResult checked_run(const Job& job) {
  JobResult result = simulate(job);
  if (!result.ok) {
    require(!result.program.diagnostics.empty());
    return result;
  }
  require(result.summary.closed && result.summary.manifold && result.summary.degenerate == 0);
  require(std::isfinite(result.volume));
  return result;
}

}  // namespace mrsim::fuzz
