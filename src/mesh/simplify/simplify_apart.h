// Simplification whose result does not meet itself. Where walls are so thin that it would, the
// vertices about the place stay; if that is not enough, all of them (docs/mesh.md, Simplification).
#pragma once

#include "mesh/simplify/simplify.h"

#include <functional>

namespace mrsim::detail {

/// A simplified mesh, and the vertices that stay because their places would meet without them.
struct ApartMesh {
  LabelledMesh mesh;
  std::size_t kept = 0;
};

/// simplify(locked) again and again, with more vertices locked about the places that meet: within
/// `margin` mm of them at first, three times as far each time. After some rounds: `mesh` itself.
/// Requires: `mesh` does not meet itself.
ApartMesh simplify_apart(const LabelledMesh& mesh, double margin, int threads,
                         const std::function<LabelledMesh(const std::vector<char>&)>& simplify);

}  // namespace mrsim::detail
