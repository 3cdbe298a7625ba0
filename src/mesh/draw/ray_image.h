// The shaded picture of a mesh, without lines and letters.
//
// One ray for each pixel finds the surface. Rays to the sky and to the key light find how much
// light it gets: the pixels of a 4 x 4 square take turns with them, and their light is averaged
// over neighbours on the same surface. Pixels where surface, direction or colour change are drawn
// again with 16 rays.
#pragma once

#include "mesh/draw/picture.h"
#include "mesh/draw/ray_scene.h"
#include "mesh/draw/studio.h"
#include "mesh/draw/view.h"
#include "mesh/solid/creases.h"

#include <vector>

namespace mrsim {

struct RayImageInput {
  const TriMesh& mesh;
  const SurfaceShape& shape;
  const RayScene& scene;
  const View& view;
  const std::vector<Color>& paints;  ///< #F, or one for all
  const RenderOptions& options;
};

/// Rows of the picture that are worked on at once.
inline constexpr int kMostHeldRows = 800;

/// Draws into all of `picture`.
void draw_surface(const RayImageInput& input, Picture& picture);

}  // namespace mrsim
