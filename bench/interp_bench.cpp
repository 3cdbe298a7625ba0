// How fast programs are read: blocks a second on one core, and memory that does not grow with the
// program. Run: interp_bench --benchmark_counters_tabular=true
#include "core/numbers/trig.h"
#include "interp/interpreter.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

namespace {

using namespace mrsim;

class CountingSink : public MotionSink {
 public:
  void motion(const Motion& m) override {
    ++motions;
    benchmark::DoNotOptimize(m.end.x);
  }
  void diagnostic(const Diagnostic&) override {}
  std::size_t motions = 0;
};

std::string program(const char* name, long blocks, const std::function<std::string(long)>& block) {
  const std::string path =
      (std::filesystem::temp_directory_path() / fmt::format("mrsim-bench-{}-{}", name, ::getpid()))
          .string();
  std::ofstream file(path);
  file << "%\nO1\n(T1 D=6. - FLAT END MILL)\nT1 M6\nG90 G54 G0 X0 Y0 Z5\nG1 Z-1 F500\n";
  for (long i = 0; i < blocks; ++i) file << block(i);
  file << "M30\n%\n";
  return path;
}

void read_all(benchmark::State& state, const std::string& path) {
  std::size_t motions = 0;
  for (auto _ : state) {
    CountingSink sink;
    interpret(path, {}, sink);
    motions += sink.motions;
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(motions));
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  state.counters["peak_MB"] = static_cast<double>(usage.ru_maxrss) / 1024;
  std::remove(path.c_str());
}

void BM_Lines(benchmark::State& state) {
  read_all(state, program("lines", state.range(0), [](long i) {
             const SinCos a = sincos(0.01 * static_cast<double>(i % 100000));
             return fmt::format("X{:.3f} Y{:.3f} Z{:.3f}\n", 50 + 40 * a.cos, 50 + 40 * a.sin,
                                a.sin - 1);
           }));
}
BENCHMARK(BM_Lines)->Arg(100000)->Arg(1000000)->Arg(4000000)->Unit(benchmark::kMillisecond);

// Three expressions a block: to be compared with BM_Lines, at most five times its time.
void BM_Expressions(benchmark::State& state) {
  read_all(state, program("expressions", state.range(0), [](long i) {
             return fmt::format("{}X[#1+{}.5] Y[#1*{}] Z-#1\n", i == 0 ? "#1=2\n" : "", i % 90,
                                i % 7);
           }));
}
BENCHMARK(BM_Expressions)->Arg(1000000)->Unit(benchmark::kMillisecond);

void BM_Arcs(benchmark::State& state) {
  read_all(state, program("arcs", state.range(0), [](long i) {
             return i % 2 == 0 ? std::string("G2 X10 Y0 I5 J0\n")
                               : std::string("G3 X0 Y0 I-5 J0\n");
           }));
}
BENCHMARK(BM_Arcs)->Arg(100000)->Arg(1000000)->Unit(benchmark::kMillisecond);

void BM_RadiusArcs(benchmark::State& state) {
  read_all(state, program("radius", state.range(0), [](long i) {
             return i % 2 == 0 ? std::string("G2 X10 Y0 R8\n") : std::string("G3 X0 Y0 R8\n");
           }));
}
BENCHMARK(BM_RadiusArcs)->Arg(1000000)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
