#include "programs.h"

#include "core/numbers/trig.h"
#include "core/numbers/units.h"
#include "core/numbers/vec.h"
#include "core/process/error.h"
#include "support/shapes.h"
#include "support/tools.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

namespace mrsim::bench {
namespace {

using testing::ballmill;
using testing::box_stock;
using testing::endmill;
using testing::round_stock;

double sine(double x) { return sincos(x).sin; }
double cosine(double x) { return sincos(x).cos; }

// What the NC text can hold: six decimals.
double rounded(double x) { return std::round(x * 1e6) / 1e6; }
Vec3 rounded(const Vec3& p) { return {rounded(p.x), rounded(p.y), rounded(p.z)}; }

class PathWriter {
 public:
  PathWriter(BenchProgram& program, const Vec3& start) : program_(program), at_(rounded(start)) {}

  void rapid(const Vec3& to) { push(MotionKind::rapid, to); }
  void line(const Vec3& to) { push(MotionKind::line, to); }
  void arc(const Vec3& to, const Vec3& center, double sweep, double rise) {
    Motion& m = push(MotionKind::arc, to);
    m.center = center;
    m.radius = length(Vec3{m.start.x - center.x, m.start.y - center.y, 0});
    m.sweep = sweep;
    m.rise = rise;
  }

 private:
  Motion& push(MotionKind kind, const Vec3& to) {
    Motion m;
    m.kind = kind;
    m.start = at_;
    m.end = rounded(to);
    m.tool = 0;
    m.line = static_cast<int>(program_.motions.size()) + 3;
    m.feed = 1000;
    m.speed = 8000;
    at_ = m.end;
    program_.motions.push_back(m);
    return program_.motions.back();
  }

  BenchProgram& program_;
  Vec3 at_;
};

}  // namespace

BenchProgram raster(std::size_t n) {
  BenchProgram program{
      fmt::format("raster-{}", n), box_stock({0, 0, 0}, {100, 100, 20}), ballmill(6), {}};
  const auto rows =
      std::max<std::size_t>(2, static_cast<std::size_t>(std::sqrt(static_cast<double>(n))));
  const std::size_t per_row = std::max<std::size_t>(1, n / rows);
  const auto point = [&](std::size_t row, std::size_t i) {
    const double y = 100.0 * static_cast<double>(row) / static_cast<double>(rows - 1);
    const double along = 100.0 * static_cast<double>(i) / static_cast<double>(per_row);
    const double x = row % 2 ? 100.0 - along : along;
    return Vec3{x, y, 10 + 3 * sine(x / 8) * cosine(y / 7)};
  };
  PathWriter path(program, {0, 0, 30});
  for (std::size_t row = 0; row < rows; ++row) {
    path.rapid(point(row, 0));
    for (std::size_t i = 1; i <= per_row; ++i) path.line(point(row, i));
  }
  return program;
}

BenchProgram adaptive(std::size_t n) {
  BenchProgram program{
      fmt::format("adaptive-{}", n), box_stock({0, 0, 0}, {200, 200, 40}), endmill(10), {}};
  constexpr std::size_t kLevels = 5, kRows = 25, kSegments = 20;
  const std::size_t loops = std::max<std::size_t>(1, n / (kLevels * kRows * kSegments));
  PathWriter path(program, {0, 0, 50});
  for (std::size_t level = 0; level < kLevels; ++level) {
    const double z = 40 - 6.0 * static_cast<double>(level + 1);
    for (std::size_t row = 0; row < kRows; ++row) {
      const double y = 4 + 8.0 * static_cast<double>(row);
      path.rapid({4, y, 50});
      path.rapid({4, y, z});
      for (std::size_t i = 1; i <= loops * kSegments; ++i) {
        const double turns = static_cast<double>(i) / kSegments;
        const double x = 200.0 * turns / static_cast<double>(loops);
        path.line({x + 4 * cosine(kTwoPi * turns), y + 4 * sine(kTwoPi * turns), z});
      }
    }
  }
  return program;
}

BenchProgram helix_drill(std::size_t holes) {
  BenchProgram program{
      fmt::format("helix-drill-{}", holes), box_stock({0, 0, 0}, {200, 200, 20}), endmill(2), {}};
  const auto columns = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(holes))));
  const double pitch = 200.0 / static_cast<double>(columns);
  PathWriter path(program, {0, 0, 30});
  for (std::size_t i = 0; i < holes; ++i) {
    const Vec3 center = rounded(Vec3{pitch * (0.5 + static_cast<double>(i % columns)),
                                     pitch * (0.5 + static_cast<double>(i / columns)), 20});
    const Vec3 start = center + Vec3{0.6, 0, 0};
    path.rapid({start.x, start.y, 25});
    path.line(start);
    path.arc(start - Vec3{0, 0, 10}, center, 20 * kTwoPi, -10);
    path.rapid({start.x, start.y, 25});
  }
  return program;
}

BenchProgram turn(std::size_t n) {
  BenchProgram program{fmt::format("turn-{}", n), {}, {}, {}};
  program.stock = round_stock(40, 0, 0, 200);
  program.tool.id = "1";
  program.tool.type = ToolType::turning;
  program.tool.insert_angle = radians(35);
  program.tool.lead_angle = radians(93);
  program.tool.edge_length = 16;
  program.tool.nose_radius = 0.4;
  PathWriter path(program, {45, 0, 205});
  for (std::size_t i = 0; i <= n; ++i) {
    const double z = 200.0 - 199.0 * static_cast<double>(i) / static_cast<double>(n);
    const Vec3 to{35 + 3 * sine(z / 10), 0, z};
    if (i == 0)
      path.rapid(to);
    else
      path.line(to);
  }
  return program;
}

BenchProgram arcs(std::size_t n) {
  BenchProgram program{
      fmt::format("arcs-{}", n), box_stock({0, 0, 0}, {200, 200, 40}), endmill(6), {}};
  PathWriter path(program, {100, 100, 50});
  Vec3 at{100, 100, 30};
  path.rapid({at.x, at.y, 50});
  path.line(at);
  const double growth = 90.0 / static_cast<double>(n);
  for (std::size_t i = 0; i < n;
       ++i) {  // semicircles of growing radius about two centres: a spiral
    const double radius = 1 + growth * static_cast<double>(i + 1), side = i % 2 ? -1 : 1;
    const Vec3 center{rounded(at.x - side * radius), at.y, at.z};
    const Vec3 to{rounded(2 * center.x - at.x), at.y, at.z};
    path.arc(to, center, kPi, 0);
    at = to;
  }
  return program;
}

BenchProgram program_named(const std::string& name) {
  const std::size_t dash = name.rfind('-');
  const std::string kind = name.substr(0, dash);
  std::size_t n = 0;
  if (dash != std::string::npos)
    std::from_chars(name.data() + dash + 1, name.data() + name.size(), n);
  if (n > 0 && kind == "raster") return raster(n);
  if (n > 0 && kind == "adaptive") return adaptive(n);
  if (n > 0 && kind == "helix-drill") return helix_drill(n);
  if (n > 0 && kind == "turn") return turn(n);
  if (n > 0 && kind == "arcs") return arcs(n);
  throw Error("bench-unknown",
              "no such program: " + name + " (raster-N, adaptive-N, helix-drill-N, turn-N, arcs-N)",
              Error::Kind::usage);
}

std::string nc_text(const BenchProgram& program) {
  const bool lathe = is_turning(program.tool.type);
  std::string text = lathe ? "G54 G18 G90 DIAMOF\nT1 D1\nG95 S800 F0.1 M4\n"
                           : "G54 G17 G90 G94\nT1 D1 M6\nS8000 F1000 M3\n";
  const auto out = std::back_inserter(text);
  for (const Motion& m : program.motions) {
    const int g = m.kind == MotionKind::rapid  ? 0
                  : m.kind == MotionKind::line ? 1
                  : m.sweep < 0                ? 2
                                               : 3;
    fmt::format_to(out, "G{} X{:.6f}", g, m.end.x);
    if (!lathe) fmt::format_to(out, " Y{:.6f}", m.end.y);
    fmt::format_to(out, " Z{:.6f}", m.end.z);
    if (m.kind == MotionKind::arc) {
      fmt::format_to(out, " I{:.6f} J{:.6f}", m.center.x - m.start.x, m.center.y - m.start.y);
      const double turns = std::floor(std::abs(m.sweep) / kTwoPi - 1e-9);
      if (turns > 0) fmt::format_to(out, " TURN={}", static_cast<int>(turns));
    }
    text += '\n';
  }
  return text + "M30\n";
}

}  // namespace mrsim::bench
