// Tools drawn from the side, one beside the other, each to a scale of its own: .svg or .png.
#include "run/tools/tool_picture.h"

#include "core/numbers/trig.h"
#include "core/numbers/units.h"
#include "core/numbers/vec.h"
#include "core/text/text_io.h"
#include "mesh/draw/picture.h"
#include "mesh/draw/picture_text.h"
#include "removal/tool/tool.h"
#include <mrsim/mrsim.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr double kCell = 200, kText = 40, kMargin = 16;  // pixels
constexpr std::size_t kColumns = 5, kMostDrawn = 500;

/// A closed outline, x to the right and y up, mm; `width` is the thickness of its pen.
struct Outline {
  std::vector<Vec2> points;
  Rgb color{};
  double width = 0;
};
constexpr Rgb kCutting = {32, 96, 192}, kShank = {120, 120, 120}, kHolder = {60, 60, 60};

Rgb color_of(const std::string& part) {
  return part == "shank" ? kShank : part == "holder" ? kHolder : kCutting;
}

// The half outlines and their mirror images.
std::vector<Outline> outlines(const Tool& tool) {
  std::vector<Outline> out;
  for (const ToolOutline& half : tool_outlines(tool)) {
    Outline whole;
    whole.color = color_of(half.part);
    whole.width = 2 * half.round;
    for (const auto& [x, y] : half.points) whole.points.push_back({x, y});
    if (!half.insert)
      for (std::size_t i = half.points.size(); i-- > 0;)
        whole.points.push_back({-half.points[i][0], half.points[i][1]});
    out.push_back(std::move(whole));
  }
  return out;
}

/// Where the outlines of one tool stand in the picture.
struct Place {
  Vec2 corner;  ///< of its cell, pixels
  Vec2 low, high;
  double scale = 1;
  Vec2 at(Vec2 p) const {
    const double x = corner.x + kCell / 2 + scale * (p.x - (low.x + high.x) / 2);
    return {x, corner.y + kCell - kMargin - scale * (p.y - low.y)};
  }
};

Place place_of(const std::vector<Outline>& shapes, std::size_t index) {
  Place place;
  const std::size_t row = index / kColumns;
  place.corner = {kCell * double(index % kColumns), (kCell + kText) * double(row)};
  place.low = place.high = shapes.front().points.front();
  for (const Outline& o : shapes)
    for (const Vec2 p : o.points) {
      place.low = {std::min(place.low.x, p.x - o.width / 2),
                   std::min(place.low.y, p.y - o.width / 2)};
      place.high = {std::max(place.high.x, p.x + o.width / 2),
                    std::max(place.high.y, p.y + o.width / 2)};
    }
  const double size = std::max({place.high.x - place.low.x, place.high.y - place.low.y, 1e-3});
  place.scale = (kCell - 2 * kMargin) / size;
  return place;
}

std::string label(const Tool& tool) {
  std::string text = tool.id.empty() ? "any tool" : "T" + tool.id;
  if (tool.diameter > 0) text += fmt::format(" D{:.6g}", tool.diameter);
  if (tool.corner_radius > 0) text += fmt::format(" R{:.6g}", tool.corner_radius);
  if (tool.nose_radius > 0) text += fmt::format(" R{:.3g}", tool.nose_radius);
  return text.substr(0, 28);
}

struct Drawing {
  std::vector<std::vector<Outline>> tools;
  std::vector<std::string> labels;
  double width() const { return kCell * double(std::min(tools.size(), kColumns)); }
  double height() const {
    const std::size_t rows = (tools.size() + kColumns - 1) / kColumns;
    return (kCell + kText) * double(rows);
  }
};

std::string svg(const Drawing& drawing) {
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:g} {1:g}\" width=\"{0:g}\" "
      "height=\"{1:g}\" font-family=\"sans-serif\" font-size=\"14\" stroke-linejoin=\"round\">\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n",
      drawing.width(), drawing.height());
  for (std::size_t i = 0; i < drawing.tools.size(); ++i) {
    const Place place = place_of(drawing.tools[i], i);
    for (const Outline& o : drawing.tools[i]) {
      std::string path;
      for (const Vec2 p : o.points)
        path +=
            fmt::format("{}{:.2f} {:.2f}", path.empty() ? "M" : "L", place.at(p).x, place.at(p).y);
      const std::string color =
          fmt::format("#{:02x}{:02x}{:02x}", o.color[0], o.color[1], o.color[2]);
      out += fmt::format(
          "<path d=\"{}Z\" fill=\"{}\" fill-opacity=\"0.4\" stroke=\"{}\" "
          "stroke-width=\"{:.2f}\"/>\n",
          path, color, color, std::max(1.5, o.width * place.scale));
    }
    out += fmt::format("<text x=\"{:g}\" y=\"{:g}\" text-anchor=\"middle\">{}</text>\n",
                       place.corner.x + kCell / 2, place.corner.y + kCell + 16,
                       xml_escaped(drawing.labels[i]));
  }
  return out + "</svg>\n";
}

Picture raster(const Drawing& drawing) {
  Picture picture(int(drawing.width()), int(drawing.height()));
  picture.fill_box({0, 0}, {drawing.width(), drawing.height()}, 0, {1, 1, 1});
  for (std::size_t i = 0; i < drawing.tools.size(); ++i) {
    const Place place = place_of(drawing.tools[i], i);
    for (const Outline& o : drawing.tools[i])
      for (std::size_t k = 0; k < o.points.size(); ++k)
        picture.stroke(place.at(o.points[k]), place.at(o.points[(k + 1) % o.points.size()]),
                       std::max(1.5, o.width * place.scale), to_linear(o.color));
    const double wide = text_width(drawing.labels[i], 10);
    draw_text(picture, {place.corner.x + (kCell - wide) / 2, place.corner.y + kCell + 16}, 10,
              drawing.labels[i], {0, 0, 0});
  }
  return picture;
}

}  // namespace

void encode_tools_picture(const std::vector<Tool>& tools, const std::string& name,
                          const ByteSink& sink) {
  const std::string extension = std::filesystem::path(name).extension().string();
  if (extension != ".svg" && extension != ".png")
    throw Error("output-format", fmt::format("{}: tools are drawn as .svg or .png", name),
                Error::Kind::usage);
  Drawing drawing;
  for (const Tool& tool : tools) {
    if (drawing.tools.size() == kMostDrawn) break;
    drawing.tools.push_back(outlines(tool));
    drawing.labels.push_back(label(tool));
  }
  if (drawing.tools.empty()) throw Error("tools-empty", "there is no tool to draw");
  if (extension == ".png") return write_png(raster(drawing), sink);
  const std::string text = svg(drawing);
  sink(text.data(), text.size());
}

void write_tools_picture(const std::vector<Tool>& tools, const std::string& path) {
  write_file_atomically(path,
                        [&](const ByteSink& sink) { encode_tools_picture(tools, path, sink); });
}

namespace {

using Points = std::vector<std::array<double, 2>>;

void add_edge(const ProfileEdge& e, double top, Points& out) {
  if (e.radius > 0) {
    constexpr int kSteps = 24;
    const double from = atan2(e.a.y - e.center.y, e.a.x - e.center.x);
    double turn = atan2(e.b.y - e.center.y, e.b.x - e.center.x) - from;
    if (e.convex && turn < 0) turn += kTwoPi;
    if (!e.convex && turn > 0) turn -= kTwoPi;
    for (int i = 1; i < kSteps; ++i) {
      const SinCos sc = sincos(from + turn * i / kSteps);
      out.push_back({e.center.x + e.radius * sc.cos, e.center.y + e.radius * sc.sin});
    }
  }
  out.push_back({e.b.x, std::isinf(e.b.y) ? top : e.b.y});
}

double stack(const std::vector<ToolSegment>& segments, double z, const char* part,
             std::vector<ToolOutline>& out) {
  for (const ToolSegment& s : segments) {
    const double top = z + s.length;
    out.push_back({part, {{s.diameter_low / 2, z}, {s.diameter_high / 2, top}}, 0, false});
    z = top;
  }
  return z;
}

double drawn_top(const Profile& cutter) {
  if (!std::isinf(cutter.top())) return cutter.top();
  double top = 3 * cutter.max_radius();
  for (const ProfileEdge& e : cutter.edges())
    if (!std::isinf(e.b.y)) top = std::max(top, e.b.y * 1.2);
  return top;
}

}  // namespace

std::vector<ToolOutline> tool_outlines(const Tool& tool) {
  const ToolShape shape = make_tool_shape(tool);
  if (shape.turning) {
    ToolOutline insert{"insert", {}, shape.insert.round, true};
    for (const Vec2 p : shape.insert.core) insert.points.push_back({p.x, p.y});
    return {insert};
  }
  const double top = drawn_top(shape.cutter);
  const Vec2 tip = shape.cutter.edges().front().a;
  ToolOutline cutter{"cutter", {{tip.x, tip.y}}, 0, false};
  for (const ProfileEdge& e : shape.cutter.edges()) add_edge(e, top, cutter.points);
  std::vector<ToolOutline> out{cutter};
  stack(tool.holder, stack(tool.shank, top, "shank", out), "holder", out);
  return out;
}

}  // namespace mrsim
