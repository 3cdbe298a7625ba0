// Detached pieces: parts of the mesh that no material joins.
#pragma once

#include <mrsim/types.h>

#include <cstdint>
#include <string>
#include <vector>

namespace mrsim {

struct Piece {
  double volume = 0;  ///< mm^3, cavities subtracted
  Vec3 center;        ///< centre of volume, mm
  Box3 bounds;        ///< mm
  std::size_t triangles = 0;
  std::vector<std::uint32_t> components;  ///< of its surface: the outer one, then its cavities
};

/// The pieces of a closed, oriented mesh, largest volume first (ties: the first triangle). A cavity
/// belongs to the piece around it; a solid within a cavity is a piece.
std::vector<Piece> find_pieces(const TriMesh& mesh);

/// "detached piece of 12.5 mm3 at (3, 4, 5) mm, 1.2 x 3 x 5 mm".
std::string describe_piece(const Piece& piece);

/// The triangles of one piece, owners and colours with them.
TriMesh extract_piece(const TriMesh& mesh, const Piece& piece);

}  // namespace mrsim
