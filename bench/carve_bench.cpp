// Removal alone: moves per second and active voxels per second, by program, voxel and threads.
//   carve_bench --benchmark_filter=raster-100000 --benchmark_repetitions=5
//   --benchmark_report_aggregates_only=true
#include "cases.h"
#include "core/process/heap.h"
#include "programs.h"
#include "removal/part/stock.h"

#include <benchmark/benchmark.h>

namespace mrsim::bench {
namespace {

void run(benchmark::State& state, const std::string& name, double voxel, int threads) {
  const BenchProgram program = program_named(name);
  std::size_t active = 0, bytes = 0;
  for (auto _ : state) {
    const Stock stock = carve(program.stock, program.motions, std::span(&program.tool, 1),
                              {.voxel = voxel, .threads = threads});
    active = stock.active_voxels();
    bytes = stock.memory();
  }
  const auto moves = static_cast<double>(program.motions.size());
  state.counters["moves/s"] =
      benchmark::Counter(moves, benchmark::Counter::kIsIterationInvariantRate);
  state.counters["voxels/s"] = benchmark::Counter(static_cast<double>(active),
                                                  benchmark::Counter::kIsIterationInvariantRate);
  state.counters["active"] = static_cast<double>(active);
  state.counters["MB"] = static_cast<double>(bytes) / 1e6;
}

constexpr Case kCases[] = {
    {"raster-10000", 0.25},     {"raster-100000", 0.25},    {"raster-100000", 0.1},
    {"raster-1000000", 0.1},    {"raster-10000000", 0.1},   {"adaptive-100000", 0.25},
    {"adaptive-1000000", 0.25}, {"helix-drill-2000", 0.25}, {"turn-1000", 0.1},
    {"turn-10000", 0.1},        {"turn-100000", 0.1},       {"arcs-5000", 0.25}};

}  // namespace
}  // namespace mrsim::bench

int main(int argc, char** argv) {
  using namespace mrsim::bench;
  mrsim::grow_heap_in_large_steps();
  return run_cases(argc, argv, kCases, run);
}
