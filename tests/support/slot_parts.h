// A plate with six slots whose faces know the lines that cut them, and ways to spoil it.
#pragma once

#include "mesh/solid/weld.h"
#include <mrsim/types.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace mrsim::testing {

inline constexpr float kTop = 10;

/// The solid below a height for each cell of a grid: columns of an NC-like part. `owner` cuts the
/// cell's floor and, being the deeper of two, the wall between.
struct Cells {
  std::vector<float> x, y;                    // borders
  std::function<float(float, float)> height;  // of a cell by its centre
  std::function<int(float, float)> owner;
};

inline void add_quad(TriMesh& mesh, int owner, std::array<std::array<float, 3>, 4> q) {
  const auto base = std::uint32_t(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), q.begin(), q.end());
  mesh.triangles.push_back({base, base + 1, base + 2});
  mesh.triangles.push_back({base, base + 2, base + 3});
  mesh.owners.insert(mesh.owners.end(), {owner, owner});
}

// Walls are cut at all heights that occur, so that the mesh is conforming.
inline TriMesh build(const Cells& g) {
  const std::size_t nx = g.x.size() - 1, ny = g.y.size() - 1;
  const auto centre = [](const std::vector<float>& v, std::size_t i) {
    return (v[i] + v[i + 1]) / 2;
  };
  const auto inside = [&](long i, long j) {
    return i >= 0 && j >= 0 && i < long(nx) && j < long(ny);
  };
  const auto height = [&](long i, long j) {
    return inside(i, j) ? g.height(centre(g.x, i), centre(g.y, j)) : 0.0f;
  };
  std::vector<float> levels{0};
  for (std::size_t i = 0; i < nx; ++i)
    for (std::size_t j = 0; j < ny; ++j) levels.push_back(height(long(i), long(j)));
  std::sort(levels.begin(), levels.end());
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  TriMesh mesh;
  const auto wall = [&](float ax, float ay, float bx, float by, float low, float high, int owner) {
    for (std::size_t k = 0; k + 1 < levels.size(); ++k)
      if (levels[k] >= low && levels[k + 1] <= high)
        add_quad(mesh, owner,
                 {{{ax, ay, levels[k]},
                   {bx, by, levels[k]},
                   {bx, by, levels[k + 1]},
                   {ax, ay, levels[k + 1]}}});
  };
  for (long i = 0; i < long(nx); ++i)
    for (long j = 0; j < long(ny); ++j) {
      const float x0 = g.x[i], x1 = g.x[i + 1], y0 = g.y[j], y1 = g.y[j + 1], h = height(i, j);
      const int owner = g.owner(centre(g.x, i), centre(g.y, j));
      add_quad(mesh, owner, {{{x0, y0, h}, {x1, y0, h}, {x1, y1, h}, {x0, y1, h}}});
      add_quad(mesh, -1, {{{x0, y0, 0}, {x0, y1, 0}, {x1, y1, 0}, {x1, y0, 0}}});
      const auto side = [&](long di, long dj, float ax, float ay, float bx, float by) {
        const float other = height(i + di, j + dj);
        const int cutter =
            inside(i + di, j + dj) ? g.owner(centre(g.x, i + di), centre(g.y, j + dj)) : -1;
        if (other < h) wall(ax, ay, bx, by, other, h, cutter);
      };
      side(1, 0, x1, y0, x1, y1);
      side(-1, 0, x0, y1, x0, y0);
      side(0, 1, x1, y1, x0, y1);
      side(0, -1, x0, y0, x1, y0);
    }
  const std::vector<std::int32_t> owners = mesh.owners;
  TriMesh welded = weld(mesh);
  welded.owners = owners;
  welded.origin.files = {"SLOTS.MPF"};
  welded.origin.tools = {"4", "7"};
  for (int owner = 0; owner < 6; ++owner)
    welded.origin.origins.push_back({owner, 0, 10 * (owner + 1), owner < 4 ? 0 : 1});
  return welded;
}

inline std::vector<std::vector<std::string>> texts() {
  std::vector<std::string> lines(80);
  for (int i = 0; i < 80; ++i) lines[std::size_t(i)] = "N" + std::to_string(i + 1) + " G1 X1";
  return {lines};
}

/// Six slots 6 wide, 14 apart, `depth[k]` deep, widened by `widen`, moved by `shift` along y.
inline Cells slots(std::array<float, 6> depth, float widen = 0, float shift = 0) {
  Cells g;
  for (int i = 0; i <= 12; ++i) g.x.push_back(float(10 * i));
  g.y = {0};
  for (int k = 0; k < 6; ++k) {
    g.y.push_back(float(7 + 14 * k) - widen + shift);
    g.y.push_back(float(13 + 14 * k) + widen + shift);
  }
  g.y.push_back(90);
  const auto slot = [=](float x, float y) {
    const int k = int(std::floor((y - shift) / 14));
    const float at = y - shift - float(14 * k);
    return x > 10 && x < 110 && k >= 0 && k < 6 && at > 7 - widen && at < 13 + widen ? k : -1;
  };
  g.height = [=](float x, float y) {
    const int k = slot(x, y);
    return k < 0 ? kTop : kTop - depth[std::size_t(k)];
  };
  g.owner = [=](float x, float y) {
    const int k = slot(x, y);
    return k >= 0 && depth[std::size_t(k)] > 0 ? k : -1;
  };
  return g;
}

inline constexpr std::array<float, 6> kRight{4, 4, 4, 4, 4, 4};

}  // namespace mrsim::testing
