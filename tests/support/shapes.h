// Closed triangle meshes of plain solids for tests, with their volumes in closed form.
#pragma once

#include "core/numbers/trig.h"
#include "core/numbers/units.h"
#include <mrsim/types.h>

#include <utility>

namespace mrsim::testing {

inline std::array<float, 3> to_float(double x, double y, double z) {
  return {float(x), float(y), float(z)};
}

inline TriMesh box_mesh(const Vec3& lo, const Vec3& hi) {
  TriMesh m;
  for (int i = 0; i < 8; ++i)
    m.vertices.push_back(to_float(i & 1 ? hi.x : lo.x, i & 2 ? hi.y : lo.y, i & 4 ? hi.z : lo.z));
  m.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                 {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return m;
}

/// A prism of n sides inscribed in a circle about (x, y), caps fanned from their centres.
inline TriMesh cylinder_mesh(int n, double radius, double z0, double z1, double x = 0,
                             double y = 0) {
  TriMesh m;
  for (int i = 0; i < n; ++i) {
    const SinCos a = sincos_deg(360.0 * i / n);
    m.vertices.push_back(to_float(x + radius * a.cos, y + radius * a.sin, z0));
    m.vertices.push_back(to_float(x + radius * a.cos, y + radius * a.sin, z1));
  }
  const std::uint32_t bottom = 2 * n, top = bottom + 1;
  m.vertices.push_back(to_float(x, y, z0));
  m.vertices.push_back(to_float(x, y, z1));
  for (std::uint32_t i = 0; i < std::uint32_t(n); ++i) {
    const std::uint32_t a = 2 * i, b = 2 * ((i + 1) % n);
    m.triangles.insert(m.triangles.end(),
                       {{a, b, b + 1}, {a, b + 1, a + 1}, {bottom, b, a}, {top, a + 1, b + 1}});
  }
  return m;
}

inline TriMesh tube_mesh(int n, double outer, double inner, double z0, double z1) {
  TriMesh m;
  for (int i = 0; i < n; ++i) {
    const SinCos a = sincos_deg(360.0 * i / n);
    for (const double r : {outer, inner})
      for (const double z : {z0, z1}) m.vertices.push_back(to_float(r * a.cos, r * a.sin, z));
  }
  for (std::uint32_t i = 0; i < std::uint32_t(n); ++i) {
    const std::uint32_t a = 4 * i,
                        b = 4 * ((i + 1) % n);  // + 0 outer low, 1 outer high, 2, 3 inner
    m.triangles.insert(m.triangles.end(), {{a, b, b + 1},
                                           {a, b + 1, a + 1},
                                           {a + 2, b + 3, b + 2},
                                           {a + 2, a + 3, b + 3},
                                           {a, a + 2, b + 2},
                                           {a, b + 2, b},
                                           {a + 1, b + 3, a + 3},
                                           {a + 1, b + 1, b + 3}});
  }
  return m;
}

/// Latitudes and longitudes, poles as fans.
inline TriMesh sphere_mesh(int n, double radius, const Vec3& c = {}) {
  TriMesh m;
  const int rings = n / 2;
  m.vertices.push_back(to_float(c.x, c.y, c.z - radius));
  for (int j = 1; j < rings; ++j)
    for (int i = 0; i < n; ++i) {
      const SinCos lat = sincos_deg(180.0 * j / rings - 90), lon = sincos_deg(360.0 * i / n);
      m.vertices.push_back(to_float(c.x + radius * lat.cos * lon.cos,
                                    c.y + radius * lat.cos * lon.sin, c.z + radius * lat.sin));
    }
  m.vertices.push_back(to_float(c.x, c.y, c.z + radius));
  const auto at = [&](int j, int i) { return std::uint32_t(1 + (j - 1) * n + i % n); };
  const auto last = std::uint32_t(m.vertices.size() - 1);
  for (int i = 0; i < n; ++i) {
    m.triangles.push_back({0, at(1, i + 1), at(1, i)});
    m.triangles.push_back({last, at(rings - 1, i), at(rings - 1, i + 1)});
    for (int j = 1; j + 1 < rings; ++j) {
      m.triangles.push_back({at(j, i), at(j, i + 1), at(j + 1, i + 1)});
      m.triangles.push_back({at(j, i), at(j + 1, i + 1), at(j + 1, i)});
    }
  }
  return m;
}

/// Inside out.
inline TriMesh flipped(TriMesh m) {
  for (auto& t : m.triangles) std::swap(t[1], t[2]);
  return m;
}

/// Both meshes in one.
inline TriMesh joined(TriMesh a, const TriMesh& b) {
  const auto shift = std::uint32_t(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const auto& t : b.triangles)
    a.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  return a;
}

inline StockShape box_stock(const Vec3& lo, const Vec3& hi) {
  StockShape s;
  s.box = {lo, hi};
  return s;
}

/// A bar about the Z axis, or a tube where `inner` is above 0, as an exact stock.
inline StockShape round_stock(double outer, double inner, double z0, double z1) {
  StockShape s;
  s.kind = inner > 0 ? StockShape::Kind::tube : StockShape::Kind::cylinder;
  s.outer_radius = outer;
  s.inner_radius = inner;
  s.box = {{-outer, -outer, z0}, {outer, outer, z1}};
  return s;
}

}  // namespace mrsim::testing
