#include "removal/vdb/grid_surface.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <map>

namespace mrsim {
namespace {

constexpr double kFinest = 1.0 / (1 << 20);  // of a voxel: the resolution of 32-bit floats

}  // namespace

TriMesh joined_surface(const std::vector<openvdb::Vec3s>& points,
                       const std::vector<openvdb::Vec3I>& triangles,
                       const std::vector<openvdb::Vec4I>& quads, double voxel) {
  const double step = kFinest * voxel;
  TriMesh mesh;
  std::map<std::array<float, 3>, std::uint32_t> known;
  std::vector<std::uint32_t> vertex_of;
  for (const openvdb::Vec3s& p : points) {
    const auto snapped = [&](float x) { return static_cast<float>(step * std::round(x / step)); };
    const std::array<float, 3> v{snapped(p.x()), snapped(p.y()), snapped(p.z())};
    const auto [at, is_new] = known.emplace(v, static_cast<std::uint32_t>(mesh.vertices.size()));
    if (is_new) mesh.vertices.push_back(v);
    vertex_of.push_back(at->second);
  }
  // OpenVDB's triangles run clockwise.
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const std::array<std::uint32_t, 3> t{vertex_of[c], vertex_of[b], vertex_of[a]};
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) mesh.triangles.push_back(t);
  };
  for (const openvdb::Vec3I& t : triangles) add(t[0], t[1], t[2]);
  for (const openvdb::Vec4I& q : quads) add(q[0], q[1], q[2]), add(q[0], q[2], q[3]);
  return mesh;
}

}  // namespace mrsim
