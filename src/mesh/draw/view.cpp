#include "mesh/draw/view.h"

#include "core/numbers/trig.h"
#include "mesh/solid/half_edges.h"

#include <algorithm>

namespace mrsim {
namespace {

constexpr double kFieldOfView = 22;  // degrees over the frame's height: a long lens

// Nearest eye from which all points (x across, z along) lie within |x - c| <= tan (d + z).
struct Slab {
  double high = -1e300, low = -1e300;
  void add(double x, double z, double tan) {
    high = std::max(high, x - tan * z);
    low = std::max(low, -x - tan * z);
  }
  double center() const { return (high - low) / 2; }
  double distance(double tan) const { return (high + low) / (2 * tan); }
};

}  // namespace

View fit_view(const TriMesh& mesh, const RenderOptions& options, const PixelBox& frame) {
  const SinCos az = sincos_deg(options.azimuth), el = sincos_deg(options.elevation);
  View view;
  view.right = {az.cos, az.sin, 0};
  view.forward = {-az.sin * el.cos, az.cos * el.cos, -el.sin};
  view.up = cross(view.right, view.forward);
  view.center = {(frame.x0 + frame.x1) / 2, (frame.y0 + frame.y1) / 2};
  const SinCos half = sincos_deg(kFieldOfView / 2);
  const double tan_y = half.sin / half.cos;
  const double tan_x = tan_y * (frame.x1 - frame.x0) / (frame.y1 - frame.y0);
  view.focal = (frame.y1 - frame.y0) / 2 / tan_y;
  Slab across, upward;
  double nearest = 1e300, farthest = -1e300;
  for (const auto& t : mesh.triangles)
    for (const std::uint32_t v : t) {
      const Vec3 p = to_vec(mesh.vertices[v]);
      const double z = dot(p, view.forward);
      across.add(dot(p, view.right), z, tan_x);
      upward.add(dot(p, view.up), z, tan_y);
      nearest = std::min(nearest, z);
      farthest = std::max(farthest, z);
    }
  const double depth = std::max(farthest - nearest, 1e-3);
  const double back =
      std::max({across.distance(tan_x), upward.distance(tan_y), 0.05 * depth - nearest});
  view.eye = across.center() * view.right + upward.center() * view.up - back * view.forward;
  return view;
}

}  // namespace mrsim
