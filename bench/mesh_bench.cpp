// Meshing alone: the exact mesher on the uniform grid, and the reference mesher (OpenVDB's
// VolumeToMesh, made manifold) on the same stock in the same run. Milliseconds of each step are
// printed.
//   mesh_bench --benchmark_filter=raster-1000000 --benchmark_repetitions=3
#include "core/process/heap.h"
#include "mesh/mesh_part.h"
#include "programs.h"
#include "reference/grid_mesh.h"
#include "removal/part/stock.h"
#include "removal/part/stock_grid.h"
#include "removal/vdb/vdb_grid.h"

#include <memory>

#include <benchmark/benchmark.h>

namespace mrsim::bench {
namespace {

using namespace mrsim::testing;

struct Case {
  const char* program;
  double voxel, tolerance;
};

constexpr Case kCases[] = {
    {"raster-10000", 0.25, 0},     {"raster-100000", 0.25, 0},     {"raster-1000000", 0.1, 0},
    {"arcs-5000", 0.25, 0},        {"turn-1000", 0.25, 0},         {"turn-10000", 0.25, 0},
    {"raster-10000", 0.25, 0.017}, {"raster-100000", 0.25, 0.017}, {"arcs-5000", 0.25, 0.02},
    {"turn-100", 0.05, 0.034},     {"turn-1000", 0.05, 0.034}};

// The stock of the last case, carved once.
const Stock& stock_of(const Case& c) {
  static std::string known;
  static std::unique_ptr<Stock> stock;
  const std::string wanted =
      std::string(c.program) + std::to_string(c.voxel) + (c.tolerance > 0 ? "T" : "");
  if (known == wanted) return *stock;
  const BenchProgram program = program_named(c.program);
  stock = std::make_unique<Stock>(carve(program.stock, program.motions, std::span(&program.tool, 1),
                                        {.voxel = c.voxel, .keep_grid = c.tolerance == 0}));
  known = wanted;
  return *stock;
}

void mesh(benchmark::State& state, const Case& c, int threads) {
  const Stock& stock = stock_of(c);
  MeshReport report;
  std::size_t triangles = 0;
  for (auto _ : state)
    triangles = mesh_part(stock.field(), stock.voxel(),
                          {.tolerance = c.tolerance, .threads = threads, .progress = {}}, &report)
                    .triangles.size();
  state.counters["triangles"] = static_cast<double>(triangles);
  state.counters["cells"] = static_cast<double>(report.cells);
  for (const auto& [step, seconds] : report.seconds) state.counters[step] = 1e3 * seconds;
}

void reference(benchmark::State& state, const Case& c, int threads) {
  const Stock& stock = stock_of(c);
  const auto& grid = static_cast<const VdbGrid&>(*stock.grid().voxels);
  for (auto _ : state)
    benchmark::DoNotOptimize(mesh_grid(*grid.distance, nullptr, threads).triangles.data());
}

}  // namespace
}  // namespace mrsim::bench

int main(int argc, char** argv) {
  using namespace mrsim::bench;
  mrsim::grow_heap_in_large_steps();
  for (const Case& c : kCases)
    for (const int threads : {1, 2}) {
      const std::string name =
          std::string(c.program) + "/voxel:" + std::to_string(c.voxel).substr(0, 4) +
          "/T:" + std::to_string(c.tolerance).substr(0, 5) + "/threads:" + std::to_string(threads);
      const auto add = [&](const std::string& what, auto body) {
        benchmark::RegisterBenchmark((name + "/" + what).c_str(),
                                     [=](benchmark::State& state) { body(state, c, threads); })
            ->Unit(benchmark::kMillisecond)
            ->UseRealTime();
      };
      add("mesh", mesh);
      if (c.tolerance == 0) add("reference", reference);
    }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
