// Meshes that were meant to be solids, made solids where nothing has to be guessed.
//
// Repaired, because the solid meant is the same: vertices of one place that are several (or, on
// open edges, a few float steps apart) are welded, triangles without corners or twice the same and
// closed sheets without thickness are dropped, triangles are turned to look outwards (also those of
// cavities). Refused, with the place: holes, bodies that touch along an edge (a part of them would
// be no 2-manifold), surfaces that cannot be oriented or that cross each other, bodies within
// others or inside out beside them. No hole is filled: what was there is not known.
#pragma once

#include <mrsim/types.h>

#include <string>

namespace mrsim {

/// Makes `mesh` the boundary of a solid and says what was done ("12 triangles turned outwards"); ""
/// and an untouched mesh where nothing was needed. Owners and colours are dropped with a repair.
/// Throws the errors of require_solid() for faults that are left after the repair.
std::string make_solid(TriMesh& mesh, const std::string& name);

/// Throws Error with a place: "mesh-crosses-itself" unless the surface is free of
/// self-intersections (bodies may touch in corners and edges, not in faces); "mesh-nested" where a
/// body lies within another, "mesh-inverted" where one is inside out. Requires: a mesh that
/// require_solid takes. O(n log n).
void require_clean_bodies(const TriMesh& mesh, const std::string& name);

}  // namespace mrsim
