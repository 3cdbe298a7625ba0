// The drawn edges: creases and outlines, as dark lines where nothing hides them.
#pragma once

#include "mesh/draw/picture.h"
#include "mesh/draw/ray_scene.h"
#include "mesh/draw/view.h"
#include "mesh/solid/creases.h"

namespace mrsim {

/// Draws the creases of `shape` and the outlines (where the surface turns away from the eye).
/// Lines fade where they lie so close that they would only darken the part.
void draw_edges(const TriMesh& mesh, const SurfaceShape& shape, const RayScene& scene,
                const View& view, int threads, Picture& picture);

}  // namespace mrsim
