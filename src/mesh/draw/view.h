// The camera: a mild perspective that shows the whole part, as large as the frame allows.
#pragma once

#include "core/numbers/vec.h"
#include <mrsim/options.h>
#include <mrsim/types.h>

namespace mrsim {

/// Pixels of the picture that the part may use.
struct PixelBox {
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

struct View {
  Vec3 eye;                 ///< mm
  Vec3 right, up, forward;  ///< unit, orthogonal
  double focal = 1;         ///< pixels a mm at 1 mm distance
  Vec2 center;              ///< pixel that the optical axis meets

  /// Unit direction through a point of the picture.
  Vec3 direction(Vec2 pixel) const {
    return normalized((pixel.x - center.x) * right - (pixel.y - center.y) * up + focal * forward);
  }
  /// The picture of p. Requires: p before the eye.
  Vec2 project(const Vec3& p) const {
    const Vec3 d = p - eye;
    const double scale = focal / dot(d, forward);
    return {center.x + scale * dot(d, right), center.y - scale * dot(d, up)};
  }
  /// Size of a pixel at p, mm.
  double pixel_at(const Vec3& p) const { return dot(p - eye, forward) / focal; }
};

/// Looks at the mesh from azimuth and elevation, fitted into the frame. Requires: a vertex.
View fit_view(const TriMesh& mesh, const RenderOptions& options, const PixelBox& frame);

}  // namespace mrsim
