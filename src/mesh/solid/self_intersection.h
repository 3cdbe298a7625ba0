// Finds pairs of triangles that intersect, by exact predicates.
#pragma once

#include "core/numbers/vec.h"
#include <mrsim/types.h>

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace mrsim::detail {

/// All pairs of triangles that touch or cross outside of the vertex or edge they share, ascending;
/// where `chosen` is not empty, only pairs whose second triangle has a mark there (then, of two
/// marked ones, the pair is ascending).
/// Requires: coordinates as vertex_lattice.h says, no degenerate triangle. O(n log n) on meshes
/// whose triangles are spread out.
std::vector<std::pair<std::uint32_t, std::uint32_t>> self_intersections(
    std::span<const Vec3> vertices, std::span<const std::array<std::uint32_t, 3>> triangles,
    int threads, std::span<const char> chosen = {});

/// True for a mesh without degenerate triangles and self-intersections whose coordinates are as
/// vertex_lattice.h says, as those of the meshes that mrsim makes; false of all others. Ends at the
/// first pair: thousands of bodies in one place have more than fit into memory.
bool is_sound(const TriMesh& mesh, int threads);

}  // namespace mrsim::detail
