// Nanoseconds for one distance, one sweep and one point, by kind of tool and of move: lists of 256
// sweeps about one point (distances), as the carver's and the mesher's samples ask them.
// MRSIM_SIMD=scalar (or avx2) in the environment gives the ratio of the kernels.
#include "core/numbers/units.h"
#include "removal/simd/sweep_kernels.h"
#include "removal/sweep/sweep_table.h"

#include <numeric>
#include <random>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

namespace mrsim {
namespace {

enum class Move { level, slanted, plunge, arc, upright_arc, helix, turn_line, turn_arc };

Tool tool_of(ToolType type, double corner = 0) {
  Tool tool;
  tool.id = "1";
  tool.type = type;
  tool.diameter = is_turning(type) ? 0 : 6;
  tool.corner_radius = corner;
  if (type == ToolType::taper) tool.tip_diameter = 2, tool.taper_angle = 0.2;
  if (type == ToolType::turning) tool.insert = "D", tool.nose_radius = 0.4;
  return tool;
}

Motion motion_of(Move move, std::mt19937_64& random) {
  const auto number = [&](double lo, double hi) {
    return std::uniform_real_distribution<double>(lo, hi)(random);
  };
  const bool turning = move >= Move::turn_line;
  Motion m;
  m.tool = 0;
  m.kind = MotionKind::line;
  m.start = {number(10, 20), turning ? 0 : number(-5, 5), number(-3, 3)};
  m.end = {m.start.x + number(-1, 1), turning ? 0 : m.start.y + number(-1, 1), m.start.z};
  if (move == Move::slanted || move == Move::turn_line) m.end.z += number(-1, 1);
  if (move == Move::plunge) m.end = {m.start.x, m.start.y, m.start.z - 1};
  if (move < Move::arc || move == Move::turn_line) return m;
  m.kind = MotionKind::arc;
  m.radius = number(1, 5);
  m.center = {m.start.x - m.radius, m.start.y, m.start.z};
  m.axis = move == Move::arc || move == Move::helix ? Vec3{0, 0, 1} : Vec3{0, 1, 0};
  m.sweep = number(0.3, 3);
  m.rise = move == Move::helix ? -1 : 0;
  m.end = m.start;
  return m;
}

void distances(benchmark::State& state, const Tool& tool, Move move) {
  std::mt19937_64 random(1);
  std::vector<Motion> motions;
  for (int k = 0; k < 256; ++k) motions.push_back(motion_of(move, random));
  const SweepTable table(motions, std::span(&tool, 1));
  std::vector<std::uint32_t> ids(table.size());
  std::iota(ids.begin(), ids.end(), 0u);
  std::vector<double> out(ids.size());
  std::uniform_real_distribution<double> place(-6, 6);
  for (auto _ : state) {
    const Vec3 p{15 + place(random), place(random), 0.5 * place(random)};
    table.distances(ids, p, out.data());
    benchmark::DoNotOptimize(out.data());
  }
  const auto asked = static_cast<double>(state.iterations()) * static_cast<double>(ids.size());
  state.counters["ns"] =
      benchmark::Counter(asked * 1e-9, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void register_all() {
  const std::pair<const char*, Tool> mills[] = {{"flat", tool_of(ToolType::endmill)},
                                                {"bull", tool_of(ToolType::bullmill, 1)},
                                                {"ball", tool_of(ToolType::ballmill)},
                                                {"taper", tool_of(ToolType::taper)},
                                                {"drill", tool_of(ToolType::drill)}};
  const std::pair<const char*, Move> moves[] = {
      {"level line", Move::level}, {"slanted line", Move::slanted},
      {"plunge", Move::plunge},    {"level arc", Move::arc},
      {"helix", Move::helix},      {"upright arc", Move::upright_arc}};
  const auto add = [](const std::string& name, const Tool& tool, Move move) {
    benchmark::RegisterBenchmark(name.c_str(),
                                 [=](benchmark::State& state) { distances(state, tool, move); });
  };
  for (const auto& [tool_name, tool] : mills)
    for (const auto& [name, move] : moves) add(std::string(tool_name) + ", " + name, tool, move);
  add("insert, line", tool_of(ToolType::turning), Move::turn_line);
  add("insert, arc", tool_of(ToolType::turning), Move::turn_arc);
}

}  // namespace
}  // namespace mrsim

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  benchmark::AddCustomContext("kernels", mrsim::sweep_kernels().name);
  mrsim::register_all();
  benchmark::RunSpecifiedBenchmarks();
}
