// A solid round a surface that is none: a scan, an open mesh, bodies with gaps between them.
//
// Openings with one border are closed first, each by triangles between its corners; then CGAL wraps
// all of it (Alpha_wrap_3; Portaneri et al. 2022): a ball of half the gap's diameter rolls over the
// surface, and where it does not come through, the wrap closes. Its vertices, a distance outside of
// the surface, are moved back onto it. What a hole was meant to be is guessed: the caller measures
// how far the wrap lies from the surface.
#pragma once

#include <mrsim/options.h>
#include <mrsim/types.h>

#include <cstddef>

namespace mrsim {

struct Wrap {
  TriMesh solid;
  TriMesh closed;            ///< what was given, with its openings closed
  std::size_t openings = 0;  ///< closed
  double widest = 0;         ///< mm: of those, its largest side
};

/// About how many triangles the wrap of a mesh has.
double wrapped_triangles(const TriMesh& mesh, const StockWrap& options);

/// Throws Error "stock-wrap" (usage) for a distance that would take too many triangles, and where
/// no solid is found.
Wrap wrap_surface(const TriMesh& mesh, const StockWrap& options);

}  // namespace mrsim
