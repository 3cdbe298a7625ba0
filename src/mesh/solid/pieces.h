// Detached pieces: parts of the mesh that no material joins.
#pragma once

#include "mesh/solid/mesh_audit.h"
#include "mesh/solid/mesh_source.h"
#include <mrsim/types.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace mrsim {

struct Piece {
  double volume = 0;  ///< mm^3, cavities subtracted
  Vec3 center;        ///< centre of volume, mm
  Box3 bounds;        ///< mm
  std::size_t triangles = 0;
  std::vector<std::uint32_t> components;  ///< as MeshAudit counts them: the outer one, then its
                                          ///< cavities
};

/// The pieces of a closed, oriented mesh, largest volume first (ties: the first triangle). A cavity
/// belongs to the piece around it; a solid within a cavity is a piece. `audit` took the blocks of
/// `mesh`, which is gone through once more where there are cavities.
std::vector<Piece> find_pieces(const MeshAudit& audit, const MeshSource& mesh);
std::vector<Piece> find_pieces(const TriMesh& mesh);

/// A surface of a mesh that contradicts those around it.
struct MisplacedBody {
  Vec3 place;           ///< on it, mm
  bool within = false;  ///< true: it looks outwards within a body; false: inwards outside of all
};
/// The first of them. Requires: a closed mesh whose surfaces do not cross.
std::optional<MisplacedBody> find_misplaced_body(const TriMesh& mesh);

/// "detached piece of 12.5 mm3 at (3, 4, 5) mm, 1.2 x 3 x 5 mm".
std::string describe_piece(const Piece& piece);

/// One piece of a mesh, with its owners and colours. Mesh and piece must outlive it.
class PieceOfMesh final : public MeshSource {
 public:
  PieceOfMesh(const MeshAudit& audit, const MeshSource& mesh, const Piece& piece);
  std::size_t vertices() const override { return vertices_; }
  std::size_t triangles() const override { return triangles_; }
  void for_each_block(const Body& body) const override;
  const OwnerTable& origin() const override { return mesh_.origin(); }
  bool has_owners() const override { return mesh_.has_owners(); }
  bool has_colors() const override { return mesh_.has_colors(); }
  const std::vector<ColorLabel>& legend() const override { return mesh_.legend(); }
  /// By component: whether it belongs to the piece.
  const std::vector<bool>& wanted() const { return wanted_; }

 private:
  const MeshAudit& audit_;
  const MeshSource& mesh_;
  std::vector<bool> wanted_;
  std::size_t vertices_ = 0, triangles_ = 0;
};

/// All of `mesh` in memory, without its legend.
TriMesh collected(const MeshSource& mesh);

}  // namespace mrsim
