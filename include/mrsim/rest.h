/// mrsim: what is left to cut of a part, piece by piece, and the largest tool that reaches it.
///
/// Pieces are found on voxels; their surfaces, volumes and thicknesses are measured against the
/// exact triangles of both meshes. Same inputs, same results, for any number of threads.
#pragma once

#include <mrsim/options.h>
#include <mrsim/types.h>

#include <cstddef>
#include <vector>

namespace mrsim {

struct RestOptions {
  /// Voxel in mm; 0 = the longest side of both meshes / 400. Requires: >= 0.
  double voxel = 0;
  /// Material that is no thicker, in mm, is not looked for; 0 = half a voxel. Requires: at most 2
  /// voxels.
  double above = 0;
  /// Pieces whose tools are looked for, the largest first.
  std::size_t searched = 20;
  int threads = 0;
};

/// The largest tool that comes to a piece and leaves at most Rest::leaves of it.
struct ReachingTool {
  double diameter = 0;    ///< mm; 0: none
  double error = 0;       ///< mm, either way, of the diameter for these triangles
  bool is_least = false;  ///< larger tools were not tried
  bool is_most = false;  ///< the piece has an inner edge, which no tool reaches: it leaves material
};

/// Material that the part has and the nominal has not, connected.
struct RestPiece {
  double volume = 0;     ///< mm^3
  double thickness = 0;  ///< mm: the largest distance of a place of the part from the nominal
  Vec3 place;            ///< where that is, mm
  Vec3 center;           ///< of volume, mm
  Box3 bounds;           ///< mm
  bool searched = false;
  /// False: too thin for the exact surfaces, so that all figures are those of its voxels.
  bool is_exact = true;
  ReachingTool ball;  ///< a ball from any side, without cutting the nominal
  ReachingTool flat;  ///< the largest flat end mill that stands upright and comes from above
  TriMesh surface;    ///< closed
};

struct Rest {
  double voxel = 0, above = 0;    ///< mm, as used
  double leaves = 0;              ///< mm: what a tool may leave of a piece
  double volume = 0;              ///< of all pieces, mm^3
  std::vector<RestPiece> pieces;  ///< the largest volume first
};

/// The material that `part` has and `nominal` has not, both in mm. Throws what compare() throws for
/// meshes that bound no solid, "rest-voxel" (usage) for a voxel that is too small for the meshes or
/// RestOptions::above of more than two voxels, "vdb-module". Cost: the voxels near both surfaces,
/// then searches in a tree of triangles for each piece whose tools are looked for.
MRSIM_API Rest find_rest(const TriMesh& part, const TriMesh& nominal,
                         const RestOptions& options = {});

/// The surfaces of all pieces as one mesh, in the order of Rest::pieces.
MRSIM_API TriMesh joined_pieces(const Rest& rest);

}  // namespace mrsim
