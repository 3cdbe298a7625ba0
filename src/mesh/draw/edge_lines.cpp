#include "mesh/draw/edge_lines.h"

#include "core/numbers/disjoint_sets.h"
#include "core/process/parallel.h"
#include "mesh/solid/half_edges.h"

#include <algorithm>
#include <cmath>

namespace mrsim {
namespace {

constexpr double kStep = 2;       // pixels between two tests whether an edge is hidden
constexpr double kOneRow = 1e-9;  // pixels of height: a line that lies in one row of the picture
constexpr int kMostSteps = 8192;
constexpr double kShortestChain = 0.012;  // of the picture's width
constexpr Rgb kInk = {28, 33, 40};

struct Line {
  Vec2 from, to;
  float width, opacity;
};

struct LineStyle {
  double width, opacity;
};

class EdgeFinder {
 public:
  EdgeFinder(const TriMesh& mesh, const SurfaceShape& shape, const RayScene& scene,
             const View& view)
      : mesh_(mesh), shape_(shape), scene_(scene), view_(view) {}

  bool faces_eye(std::uint32_t h) const {
    return dot(shape_.face_normals[h / 3], view_.eye - corner(mesh_, h / 3, 0)) > 0;
  }
  bool is_outline(std::uint32_t h) const {
    const std::uint32_t o = shape_.opposite[h];
    return is_half_edge(o) && faces_eye(h) != faces_eye(o);
  }
  // The parts of the edge that can be seen, as lines.
  void add_visible(std::uint32_t h, const LineStyle& style, std::vector<Line>& lines) const;

 private:
  bool is_visible(const Vec3& p, const Vec3& away) const;
  const TriMesh& mesh_;
  const SurfaceShape& shape_;
  const RayScene& scene_;
  const View& view_;
};

// Tested from a point a pixel nearer to the eye and off the surface, so that the faces of the edge
// itself do not hide it.
bool EdgeFinder::is_visible(const Vec3& p, const Vec3& away) const {
  const Vec3 to_eye = normalized(view_.eye - p);
  const double pixel = view_.pixel_at(p);
  const Vec3 from = p + pixel * (1.0 * to_eye + 0.35 * away);
  return !scene_.is_blocked(from, to_eye, distance(view_.eye, from));
}

void EdgeFinder::add_visible(std::uint32_t h, const LineStyle& style,
                             std::vector<Line>& lines) const {
  const std::uint32_t o = shape_.opposite[h];
  if (!faces_eye(h) && !(is_half_edge(o) && faces_eye(o))) return;
  const Vec3 a = to_vec(mesh_.vertices[origin_of(mesh_, h)]),
             b = to_vec(mesh_.vertices[target_of(mesh_, h)]);
  Vec3 away = shape_.face_normals[h / 3];
  if (is_half_edge(o)) away = normalized(away + shape_.face_normals[o / 3]);
  const double pixels = length(view_.project(b) - view_.project(a));
  const int steps = std::clamp(int(std::ceil(pixels / kStep)), 1, kMostSteps);
  int begin = -1;  // of the visible piece that is being followed
  for (int i = 0; i <= steps; ++i) {
    const bool visible = i < steps && is_visible(lerp(a, b, (i + 0.5) / steps), away);
    if (visible && begin < 0) begin = i;
    if (visible || begin < 0) continue;
    lines.push_back({view_.project(lerp(a, b, double(begin) / steps)),
                     view_.project(lerp(a, b, double(i) / steps)), float(style.width),
                     float(style.opacity)});
    begin = -1;
  }
}

// Creases of a coarse or noisy mesh are short fragments; an edge of the part is a longer chain.
// Keeps the creases of connected chains that are longer than `shortest` mm.
std::vector<std::uint32_t> without_crumbs(const TriMesh& mesh,
                                          const std::vector<std::uint32_t>& creases,
                                          double shortest) {
  DisjointSets joined(mesh.vertices.size());
  for (const std::uint32_t h : creases) joined.join(origin_of(mesh, h), target_of(mesh, h));
  std::vector<double> chain(mesh.vertices.size(), 0);
  for (const std::uint32_t h : creases)
    chain[joined.least(target_of(mesh, h))] += distance(to_vec(mesh.vertices[origin_of(mesh, h)]),
                                                        to_vec(mesh.vertices[target_of(mesh, h)]));
  std::vector<std::uint32_t> kept;
  for (const std::uint32_t h : creases)
    if (chain[joined.least(target_of(mesh, h))] > shortest) kept.push_back(h);
  return kept;
}

using Coverage = std::vector<float>;

// A pixel keeps its strongest line: lines that meet or repeat do not add up.
void cover(const Line& line, int width, int height, Coverage& coverage) {
  const double reach = line.width / 2 + 1;
  const int y0 = std::max(0, int(std::min(line.from.y, line.to.y) - reach));
  const int y1 = std::min(height - 1, int(std::max(line.from.y, line.to.y) + reach));
  const Vec2 along = line.to - line.from;
  for (int y = y0; y <= y1; ++y) {
    // Columns near the line in this row, so that long slanted lines do not cost their whole box.
    double lo = std::min(line.from.x, line.to.x), hi = std::max(line.from.x, line.to.x);
    if (std::fabs(along.y) > kOneRow) {
      const double t0 = (y - reach - line.from.y) / along.y;
      const double t1 = (y + 1 + reach - line.from.y) / along.y;
      lo = std::max(lo, line.from.x + std::min(t0 * along.x, t1 * along.x));
      hi = std::min(hi, line.from.x + std::max(t0 * along.x, t1 * along.x));
    }
    const int x1 = std::min(width - 1, int(hi + reach));
    for (int x = std::max(0, int(lo - reach)); x <= x1; ++x) {
      const double c = stroke_coverage({x + 0.5, y + 0.5}, line.from, line.to, line.width);
      float& value = coverage[std::size_t(y) * width + x];
      value = std::max(value, float(c * line.opacity));
    }
  }
}

// Mean over a square of 2 kRadius + 1 pixels, by sums over rows and columns.
Coverage local_mean(const Coverage& coverage, int width, int height) {
  constexpr int kRadius = 7;
  const auto mean_along = [](const Coverage& in, int count, int stride, int lines,
                             int line_stride) {
    Coverage out(in.size());
    for (int line = 0; line < lines; ++line) {
      const std::size_t start = std::size_t(line) * line_stride;
      double sum = 0;
      for (int i = -kRadius; i < count; ++i) {
        if (i + kRadius < count) sum += in[start + std::size_t(i + kRadius) * stride];
        if (i > kRadius) sum -= in[start + std::size_t(i - kRadius - 1) * stride];
        if (i >= 0) out[start + std::size_t(i) * stride] = float(sum / (2 * kRadius + 1));
      }
    }
    return out;
  };
  return mean_along(mean_along(coverage, width, 1, height, width), height, width, width, 1);
}

std::vector<Line> visible_lines(const EdgeFinder& finder, const SurfaceShape& shape,
                                const std::vector<std::uint32_t>& sharp, double picture_width,
                                int threads) {
  const double unit = std::max(picture_width / 1600, 0.6);
  const LineStyle crease{1.35 * unit, 0.82}, outline{1.7 * unit, 0.92};
  const std::size_t creases = sharp.size();
  const std::size_t count = creases + shape.smooth_edges.size();
  constexpr std::size_t kBlock = 512;
  std::vector<std::vector<Line>> parts((count + kBlock - 1) / kBlock);
  parallel_for(parts.size(), threads, [&](std::size_t block) {
    for (std::size_t i = block * kBlock; i < std::min(count, (block + 1) * kBlock); ++i) {
      const std::uint32_t h = i < creases ? sharp[i] : shape.smooth_edges[i - creases];
      if (finder.is_outline(h))
        finder.add_visible(h, outline, parts[block]);
      else if (i < creases)
        finder.add_visible(h, crease, parts[block]);
    }
  });
  std::vector<Line> lines;
  for (const auto& part : parts) lines.insert(lines.end(), part.begin(), part.end());
  return lines;
}

}  // namespace

void draw_edges(const TriMesh& mesh, const SurfaceShape& shape, const RayScene& scene,
                const View& view, int threads, Picture& picture) {
  const EdgeFinder finder(mesh, shape, scene, view);
  const int width = picture.width(), height = picture.height();
  Coverage coverage(std::size_t(width) * std::size_t(height), 0.0f);
  const double reach = distance(view.eye, corner(mesh, 0, 0));
  const std::vector<std::uint32_t> sharp =
      without_crumbs(mesh, shape.creases, kShortestChain * width * reach / view.focal);
  for (const Line& line : visible_lines(finder, shape, sharp, width, threads))
    cover(line, width, height, coverage);
  const Coverage mean = local_mean(coverage, width, height);
  const Color ink = to_linear(kInk);
  parallel_for(std::size_t(height), threads, [&](std::size_t y) {
    for (int x = 0; x < width; ++x) {
      const std::size_t i = y * std::size_t(width) + std::size_t(x);
      if (coverage[i] <= 0) continue;
      const float fade = std::min(1.0f, 0.3f / std::max(mean[i], 1e-6f));
      picture.at(x, int(y)) = mix(picture.at(x, int(y)), ink, coverage[i] * fade);
    }
  });
}

}  // namespace mrsim
