// How much memory a mesh with a tolerance is going to take, estimated from its first cells
// (docs/removal.md, Memory).
#pragma once

#include "removal/field/field.h"

#include <cstddef>
#include <string>

namespace mrsim::detail {

class CellOctree;

/// Bytes that a node of the octree takes.
inline constexpr double kNodeMemory = 320;

/// Bytes of a node that comes of splitting cells, with its faces and candidates; and of what is
/// made of the surface in it.
inline constexpr double kSplitMemory = 450, kSurfaceMemory = 500;

/// Bytes of a loop when its vertex and triangles are made: 600 on walls and floors, more where they
/// are thin.
inline constexpr double kLoopMemory = 900;

/// Bytes of a triangle while a round is certified, and while ridges are tested for what meets.
inline constexpr double kCertifyMemory = 260, kSharpenMemory = 130;

/// Bytes at the mesher's peak, an estimate: within a factor of 1.5 where it was measured. Looks at
/// some thousands of the cells. Requires: a tree as it was made, before any split().
double expected_memory(const ExactField& field, const CellOctree& tree, double tolerance,
                       int threads);

/// Throws Error "memory" where the mesher needs more than `available` bytes; 0 = any amount.
void require_mesh_memory(double needed, std::size_t available, double tolerance);

/// Nodes of the octree in the end, once its cells are split, by what expected_memory() says.
double expected_nodes(double memory);

/// Bytes at the mesher's peak, an estimate by what there is in the end: the octree, and its
/// triangles before any is merged. Within a factor of 1.3 where it was measured.
double memory_of_mesh(const CellOctree& tree, std::size_t triangles);

/// The same before there are triangles: the octree, and the loops of surface in its cells.
double memory_of_loops(const CellOctree& tree, std::size_t loops);

/// Throws Error "mesh-unresolved" where the octree has more nodes, or will have, than `most`; 0 =
/// any number.
void require_cells(double nodes, double most);
/// The sentence of that error.
std::string too_many_cells(double most);

/// Does what require_memory does, for what splitting cells takes beyond the estimate, where the
/// thread has a limit.
void require_room(double bytes, bool has_tolerance = true);

}  // namespace mrsim::detail
