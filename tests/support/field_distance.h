// How far a mesh lies from the exact part, by samples.
#pragma once

#include "core/numbers/vec.h"
#include "removal/field/field.h"
#include "support/random.h"
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

/// Distance of a place in the air from the material, searched: never too small, and too large by a
/// thousandth where the material is a wedge.
inline double distance_from_material(const ExactField& field, const Vec3& p) {
  const Candidates all = field.all();
  Random random(1);
  const auto way = [&] {
    for (;;)
      if (const Vec3 v{random(-1, 1), random(-1, 1), random(-1, 1)};
          length(v) > 0.1 && length(v) < 1)
        return v;
  };
  const double d = std::max(field.sample(p, all).distance, 0.0);
  Vec3 nearest = p;
  double least = 0;
  for (double r = d + 1e-7; least == 0; r *= 1.05)
    for (int k = 0; k < 300 && least == 0; ++k) {
      const Vec3 v = way(), q = p + (r / length(v)) * v;
      if (field.sample(q, all).distance < 0) nearest = q, least = r;
    }
  double step = 0.3 * least;
  for (int k = 0; k < 1500; ++k) {
    const Vec3 q = nearest + step * way();
    const bool is_nearer = distance(p, q) < least && field.sample(q, all).distance < 0;
    if (is_nearer) nearest = q, least = distance(p, q);
    step = is_nearer ? 1.5 * step : std::max(0.97 * step, 1e-5 * least);
  }
  return least;
}

}  // namespace mrsim::testing
