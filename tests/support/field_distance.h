// How far a mesh lies from the exact part, by samples.
#pragma once

#include "core/numbers/vec.h"
#include "removal/field/field.h"
#include <mrsim/types.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace mrsim::testing {

/// Largest |d| over the mesh, 30 samples to a side of a triangle at most.
inline double largest_distance(const ExactField& field, const TriMesh& mesh) {
  const auto vec = [](const std::array<float, 3>& v) { return Vec3{v[0], v[1], v[2]}; };
  const Candidates all = field.all();
  double most = 0;
  for (const auto& t : mesh.triangles) {
    const Vec3 a = vec(mesh.vertices[t[0]]), b = vec(mesh.vertices[t[1]]),
               c = vec(mesh.vertices[t[2]]);
    const double longest = std::max({distance(a, b), distance(b, c), distance(c, a)});
    const int n = std::clamp(static_cast<int>(longest / 0.1), 4, 30);
    for (int i = 0; i <= n; ++i)
      for (int j = 0; i + j <= n; ++j) {
        const Vec3 p = (1.0 / n) * ((n - i - j) * a + i * b + j * c);
        most = std::max(most, std::abs(field.sample(p, all).distance));
      }
  }
  return most;
}

}  // namespace mrsim::testing
