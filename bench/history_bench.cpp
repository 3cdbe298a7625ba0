// What each motion removes, by program, voxel and threads; without the sweeps and their field.
//   history_bench --benchmark_filter=raster-100000
#include "cases.h"
#include "programs.h"
#include "removal/history/removed_volumes.h"

#include <algorithm>
#include <numeric>

#include <benchmark/benchmark.h>

namespace mrsim::bench {
namespace {

void run(benchmark::State& state, const std::string& name, double voxel, int threads) {
  const BenchProgram program = program_named(name);
  const PartField field(StockSolid(program.stock),
                        SweepTable(program.motions, std::span(&program.tool, 1)));
  const CutLattice lattice = history_lattice(field, voxel);
  std::vector<double> removed;
  for (auto _ : state) removed = removed_volumes(field, lattice, program.motions.size(), threads);
  state.counters["mm3"] = std::accumulate(removed.begin(), removed.end(), 0.0);
  state.counters["air"] = static_cast<double>(std::count(removed.begin(), removed.end(), 0.0));
}

constexpr Case kCases[] = {{"raster-10000", 0.25},   {"raster-100000", 0.25},
                           {"raster-100000", 0.5},   {"adaptive-100000", 0.5},
                           {"helix-drill-200", 0.5}, {"arcs-5000", 0.25},
                           {"turn-1000", 0.25},      {"turn-10000", 0.25}};

}  // namespace
}  // namespace mrsim::bench

int main(int argc, char** argv) {
  using namespace mrsim::bench;
  return run_cases(argc, argv, kCases, run);
}
