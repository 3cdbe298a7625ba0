// The programs a benchmark runs, each at a voxel, on one thread and on two.
#pragma once

#include <span>
#include <string>

#include <benchmark/benchmark.h>

namespace mrsim::bench {

struct Case {
  const char* program;  ///< a name of program_named()
  double voxel;         ///< mm
};

using CaseRun = void (*)(benchmark::State& state, const std::string& program, double voxel,
                         int threads);

/// What main() of such a benchmark does.
inline int run_cases(int argc, char** argv, std::span<const Case> cases, CaseRun run) {
  for (const Case& c : cases)
    for (const int threads : {1, 2})
      benchmark::RegisterBenchmark(
          (std::string(c.program) + "/voxel:" + std::to_string(c.voxel).substr(0, 4) +
           "/threads:" + std::to_string(threads))
              .c_str(),
          [c, threads, run](benchmark::State& state) { run(state, c.program, c.voxel, threads); })
          ->Unit(benchmark::kMillisecond)
          ->UseRealTime();
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}

}  // namespace mrsim::bench
