#include "interp/show/path_picture.h"

#include "core/numbers/rounding.h"
#include "core/numbers/units.h"
#include "core/numbers/vec.h"
#include "core/process/memory_limit.h"
#include "core/text/text_io.h"
#include "interp/path/arc.h"
#include "interp/show/motion_text.h"
#include "interp/text/characters.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

// The axes of the picture: X right and Y up for a mill, Z right and X up for a lathe.
struct PathView {
  bool lathe = false;
  Vec2 at(const Vec3& p) const { return lathe ? Vec2{p.z, p.x} : Vec2{p.x, p.y}; }
  Vec3 towards() const { return lathe ? Vec3{0, 1, 0} : Vec3{0, 0, 1}; }
};

int arc_steps(const Motion& m) {
  const double per_step = radians(5);
  return std::clamp(static_cast<int>(std::ceil(std::abs(m.sweep) / per_step)), 2, 4096);
}

std::string svg_point(const PathView& view, const Vec3& p) {
  const Vec2 q = view.at(p);
  return fmt::format("{} {}", number_text(q.x), number_text(-q.y));  // SVG's y grows downwards
}

// An arc seen along its axis becomes SVG arcs (two halves, so that full circles work), any other
// one a polyline.
std::string svg_arc(const PathView& view, const Motion& m) {
  std::string out;
  const double facing = dot(m.axis, view.towards());
  if (std::abs(facing) < 1 - kTurnRounding) {
    const int n = arc_steps(m);
    for (int i = 1; i <= n; ++i)
      out += fmt::format("L{}", svg_point(view, arc_point(m, double(i) / n)));
    return out;
  }
  const int pieces =
      std::clamp(static_cast<int>(std::ceil(std::abs(m.sweep) / (0.9 * kPi))), 1, 2000);
  const bool ccw = (m.sweep > 0) == (facing > 0);
  for (int i = 1; i <= pieces; ++i) {
    const Vec3 p = i == pieces ? m.end : arc_point(m, double(i) / pieces);
    const std::string r = number_text(m.radius);
    out += fmt::format("A{} {} 0 0 {} {}", r, r, ccw ? 0 : 1, svg_point(view, p));
  }
  return out;
}

Box3 bounds(const Program& program) {
  Box3 box;
  for (const Motion& m : program.motions) {
    extend(box, m.start);
    extend(box, m.end);
    if (m.kind != MotionKind::arc) continue;
    const int n = arc_steps(m);
    for (int i = 1; i < n; ++i) extend(box, arc_point(m, double(i) / n));
  }
  if (is_empty(box)) extend(box, Vec3{});
  return box;
}

const char* colour(MotionKind kind) {
  return kind == MotionKind::rapid ? "#c05020" : kind == MotionKind::line ? "#2060c0" : "#208040";
}

// A text that grows by doubling.
void require_picture_memory(const Program& program, bool is_svg) {
  constexpr double kPoint = 300;  // bytes
  double points = 0;
  for (const Motion& m : program.motions)
    points += m.kind == MotionKind::arc && !is_svg ? arc_steps(m) : 1;
  require_memory(kPoint * points, fmt::format("a picture of {} motions", program.motions.size()));
}

}  // namespace

std::string path_svg(const Program& program) {
  const PathView view{program.machine == MachineKind::lathe};
  const Box3 box = bounds(program);
  const Vec2 lo = view.at(box.lo), hi = view.at(box.hi);
  const double size = std::max({hi.x - lo.x, hi.y - lo.y, 1.0}), margin = 0.05 * size;
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{} {} {} {}\" fill=\"none\" "
      "stroke-width=\"{}\" stroke-linecap=\"round\">\n",
      number_text(lo.x - margin), number_text(-hi.y - margin),
      number_text(hi.x - lo.x + 2 * margin), number_text(hi.y - lo.y + 2 * margin),
      number_text(size / 400));
  const std::string dash = number_text(size / 80);
  for (const Motion& m : program.motions) {
    const std::string path =
        m.kind == MotionKind::arc ? svg_arc(view, m) : fmt::format("L{}", svg_point(view, m.end));
    const std::string style = m.kind == MotionKind::rapid
                                  ? fmt::format(" stroke-dasharray=\"{0} {0}\"", dash)
                                  : std::string();
    out += fmt::format(
        "<path class=\"{}\" stroke=\"{}\"{} d=\"M{}{}\"><title>line {}</title></path>\n",
        m.kind == MotionKind::rapid  ? "rapid"
        : m.kind == MotionKind::line ? "line"
                                     : "arc",
        colour(m.kind), style, svg_point(view, m.start), path, m.line);
  }
  out += "</svg>\n";
  return out;
}

std::string path_ply(const Program& program) {
  std::string points, edges;
  std::size_t vertices = 0, count = 0;
  for (const Motion& m : program.motions) {
    const int n = m.kind == MotionKind::arc ? arc_steps(m) : 1;
    const char* rgb = m.kind == MotionKind::rapid  ? "192 80 32"
                      : m.kind == MotionKind::line ? "32 96 192"
                                                   : "32 128 64";
    for (int i = 0; i <= n; ++i) {
      const Vec3 p = i == 0 ? m.start : i == n ? m.end : arc_point(m, double(i) / n);
      points += fmt::format("{} {} {}\n", number_text(p.x), number_text(p.y), number_text(p.z));
      if (i == 0) continue;
      edges += fmt::format("{} {} {}\n", vertices + static_cast<std::size_t>(i) - 1,
                           vertices + static_cast<std::size_t>(i), rgb);
      ++count;
    }
    vertices += static_cast<std::size_t>(n) + 1;
  }
  return fmt::format(
             "ply\nformat ascii 1.0\ncomment tool path, mm\nelement vertex {}\nproperty double x\n"
             "property double y\nproperty double z\nelement edge {}\nproperty int vertex1\n"
             "property int vertex2\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
             "end_header\n",
             vertices, count) +
         points + edges;
}

void write_path_picture(const Program& program, const std::string& path) {
  const std::size_t dot = path.find_last_of('.');
  const std::string extension =
      dot == std::string::npos ? std::string() : upper_case(path.substr(dot));
  if (extension != ".SVG" && extension != ".PLY")
    throw Error("output-format",
                fmt::format("{}: a tool path is written as .svg, .ply or .html", path),
                Error::Kind::usage);
  require_picture_memory(program, extension == ".SVG");
  const std::string text = extension == ".SVG" ? path_svg(program) : path_ply(program);
  write_file_atomically(path, [&](const ByteSink& sink) { sink(text.data(), text.size()); });
}

}  // namespace mrsim
