#include "mesh/draw/render.h"

#include "core/process/memory_limit.h"
#include "mesh/draw/edge_lines.h"
#include "mesh/draw/palette.h"
#include "mesh/draw/picture.h"
#include "mesh/draw/picture_text.h"
#include "mesh/draw/ray_image.h"
#include "mesh/draw/ray_scene.h"
#include "mesh/solid/check.h"
#include "mesh/solid/creases.h"
#include "mesh/solid/half_edges.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr Rgb kSteel = {196, 201, 207};
constexpr Rgb kText = {62, 70, 80};
constexpr double kDefaultCrease = 25;  // degrees, for shading where no edges are drawn
constexpr std::size_t kMostEntries = 14;

// Bytes, as measured. A triangle takes its shape for the light and its share of Embree's tree, and
// more where edges are drawn. A pixel takes its light; in the band that is being drawn also what
// its ray met; and more where edges are drawn.
constexpr double kDrawnTriangleBytes = 200, kLinedTriangleBytes = 260;
constexpr double kPixel = 12, kBandPixel = 112, kLinedPixel = 13;

void require_valid(const TriMesh& mesh, const RenderOptions& options) {
  const auto fail = [](const std::string& what) {
    throw Error("render-options", what, Error::Kind::usage);
  };
  for (const int side : {options.width, options.height})
    if (side < 16 || side > 8192)
      fail(fmt::format("a picture side of {} pixels is not in 16 .. 8192", side));
  if (!(std::fabs(options.azimuth) <= 3600) || !(std::fabs(options.elevation) <= 90))
    fail("the view needs an azimuth within 3600 and an elevation within 90 degrees");
  if (!(options.edge_angle >= 0 && options.edge_angle <= 180))
    fail(fmt::format("an edge angle of {} degrees is not in 0 .. 180", options.edge_angle));
  if (mesh.triangles.empty()) throw Error("mesh-empty", "there is nothing to draw");
  for (const auto& t : mesh.triangles)
    for (const std::uint32_t v : t)
      if (v >= mesh.vertices.size() || !std::isfinite(mesh.vertices[v][0]) ||
          !std::isfinite(mesh.vertices[v][1]) || !std::isfinite(mesh.vertices[v][2]))
        throw Error("mesh-invalid",
                    "a triangle has a vertex that is missing, or that has no finite place");
}

void require_picture_memory(const TriMesh& mesh, const RenderOptions& options) {
  const double triangles = double(mesh.triangles.size()), width = options.width,
               pixels = width * options.height,
               band = width * std::min(options.height, kMostHeldRows);
  const double drawn = kDrawnTriangleBytes * triangles + kBandPixel * band,
               lined = kLinedTriangleBytes * triangles + kLinedPixel * pixels;
  require_memory(kPixel * pixels + std::max(drawn, lined),
                 fmt::format("a picture of {} x {} pixels of {} triangles", options.width,
                             options.height, mesh.triangles.size()),
                 "a smaller --size or a coarser mesh takes less, --max-memory allows more");
}

std::vector<Color> face_paints(const FacePalette& palette) {
  if (palette.index.empty()) return {to_linear(kSteel)};
  std::vector<Color> of_entry, paints;
  for (const PaletteEntry& entry : palette.entries) of_entry.push_back(to_linear(entry.color));
  for (const std::uint32_t i : palette.index) paints.push_back(of_entry[i]);
  return paints;
}

// What the legend shows: the labels of the mesh's own colours, or those of the owners.
FacePalette palette_of(const TriMesh& mesh, ColorBy color) {
  if (mesh.colors.empty()) return make_palette(mesh, color);
  FacePalette out;
  for (const ColorLabel& label : mesh.legend) out.entries.push_back({label.color, label.text, -1});
  return out;
}

std::string size_text(const TriMesh& mesh) {
  const Box3 box = mesh_bounds(mesh);
  const Vec3 side = box.hi - box.lo;
  const auto rounded = [](double mm) { return std::round(mm * 100) / 100; };
  return fmt::format("{:g} x {:g} x {:g} mm", rounded(side.x), rounded(side.y), rounded(side.z));
}

// Entries to show: all, or those of the largest area.
std::vector<std::size_t> shown_entries(const TriMesh& mesh, const FacePalette& palette) {
  std::vector<double> area(palette.entries.size(), 0);
  for (std::size_t f = 0; f < palette.index.size(); ++f)
    area[palette.index[f]] += length(area_normal(mesh, f));
  std::vector<std::size_t> shown(palette.entries.size());
  for (std::size_t i = 0; i < shown.size(); ++i) shown[i] = i;
  if (shown.size() > kMostEntries) {
    std::stable_sort(shown.begin(), shown.end(),
                     [&](std::size_t a, std::size_t b) { return area[a] > area[b]; });
    shown.resize(kMostEntries);
    std::sort(shown.begin(), shown.end());
  }
  return shown;
}

void draw_legend(const TriMesh& mesh, const FacePalette& palette, double text, Picture& picture) {
  if (palette.entries.empty()) return;
  const std::vector<std::size_t> shown = shown_entries(mesh, palette);
  std::vector<std::string> labels;
  for (const std::size_t i : shown) labels.push_back(palette.entries[i].label);
  if (shown.size() < palette.entries.size())
    labels.push_back(fmt::format("and {} more", palette.entries.size() - shown.size()));
  const double row = 1.9 * text, pad = text, left = 1.6 * text, chip = 1.3 * text;
  double widest = 0;
  for (const std::string& label : labels) widest = std::max(widest, text_width(label, text));
  picture.fill_box({left, left}, {chip + widest + 3 * pad, row * double(labels.size()) + pad},
                   0.6 * text, to_linear({255, 255, 255}), 0.82);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const double y = left + pad + row * double(i);
    if (i < shown.size())
      picture.fill_box({left + pad, y - 0.05 * text}, {chip, 1.05 * text}, 0.25 * text,
                       to_linear(palette.entries[shown[i]].color));
    draw_text(picture, {left + 2 * pad + chip, y + text}, text, labels[i], to_linear(kText));
  }
}

constexpr double kAlong = 0.999;      // cosine: a face along Z says nothing
constexpr double kRadial = 0.1;       // sine: what a coarse mesh of a round wall is off
constexpr double kTurned = 0.9;       // share of the walls
constexpr double kLeastWalls = 0.02;  // share of the area

}  // namespace

void render_mesh(const TriMesh& part, const RenderOptions& options, const ByteSink& out) {
  require_valid(part, options);
  require_picture_memory(part, options);
  const bool lies = options.up == UpAxis::x || (options.up == UpAxis::automatic && is_turned(part));
  const TriMesh laid = lies ? laid_down(part) : TriMesh{};
  const TriMesh& mesh = lies ? laid : part;
  const double crease = options.edge_angle > 0 ? options.edge_angle : kDefaultCrease;
  const SurfaceShape shape = find_surface_shape(mesh, crease, options.threads);
  const RayScene scene(mesh, options.threads);
  const FacePalette palette = palette_of(mesh, options.color);
  const std::vector<Color> paints = face_paints(palette);

  const double text = std::max(6.0, options.height / 75.0);
  const double margin = 0.05 * std::min(options.width, options.height);
  const View view =
      fit_view(mesh, options,
               {margin, margin, options.width - margin, options.height - margin - 2.2 * text});
  Picture picture(options.width, options.height);
  draw_surface({mesh, shape, scene, view, paints, options}, picture);
  if (options.edge_angle > 0) draw_edges(mesh, shape, scene, view, options.threads, picture);
  draw_legend(mesh, palette, text, picture);
  draw_text(picture, {1.8 * text, options.height - 1.8 * text}, text,
            options.caption.empty() ? size_text(part) : options.caption, to_linear(kText));
  write_png(picture, out);
}

bool is_turned(const TriMesh& mesh) {
  double all = 0, walls = 0, turned = 0;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    const Vec3 n = area_normal(mesh, f);
    const double area = length(n);
    all += area;
    if (std::abs(n.z) >= kAlong * area) continue;
    Vec3 middle;
    for (const std::uint32_t v : mesh.triangles[f])
      middle = middle + (1.0 / 3) * to_vec(mesh.vertices[v]);
    const double radius = std::sqrt(middle.x * middle.x + middle.y * middle.y);
    walls += area;
    if (std::abs(n.x * middle.y - n.y * middle.x) <= kRadial * area * radius) turned += area;
  }
  return walls > kLeastWalls * all && turned >= kTurned * walls;
}

TriMesh laid_down(TriMesh mesh) {
  for (auto& [x, y, z] : mesh.vertices) {
    const float left = x;
    x = z, y = -y, z = left;
  }
  return mesh;
}

}  // namespace mrsim
