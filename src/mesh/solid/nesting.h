// Which surfaces of a mesh lie within which.
#pragma once

#include "mesh/solid/mesh_audit.h"
#include "mesh/solid/mesh_source.h"
#include <mrsim/types.h>

#include <cstdint>
#include <functional>
#include <map>
#include <vector>

namespace mrsim {

/// The middle of the first triangle of each component.
std::vector<Vec3> first_places(const MeshAudit& audit, const MeshSource& mesh);

/// For each component of `inner`, the smallest one (by its volume without sign, then by its number)
/// that winds about it and for which may_hold(outer, inner) is true; none where nothing does.
/// `audit` took the blocks of `mesh`. The components are asked from the smallest to the largest, a
/// few of them in each passage through the mesh: where bodies lie in one another like the skins of
/// an onion, each question is about the next skin, not about all of them.
using MayHold = std::function<bool(std::uint32_t outer, std::uint32_t inner)>;
std::map<std::uint32_t, std::uint32_t> find_surfaces_around(const MeshAudit& audit,
                                                            const MeshSource& mesh,
                                                            const std::vector<std::uint32_t>& inner,
                                                            const MayHold& may_hold);

}  // namespace mrsim
