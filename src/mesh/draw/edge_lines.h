// The drawn edges: creases and outlines, as dark lines where nothing hides them.
#pragma once

#include "mesh/creases.h"
#include "mesh/picture.h"
#include "mesh/ray_scene.h"
#include "mesh/view.h"

namespace mrsim {

/// Draws the creases of `shape` and the outlines (where the surface turns away from the eye).
/// Lines fade where they lie so close that they would only darken the part.
void draw_edges(const TriMesh& mesh, const SurfaceShape& shape, const RayScene& scene,
                const View& view, int threads, Picture& picture);

}  // namespace mrsim
