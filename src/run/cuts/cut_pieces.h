// Cuts in pieces, so that what happens along a motion can be reported.
#pragma once

#include "run/cuts/cuts.h"

#include <cstddef>
#include <span>
#include <vector>

namespace mrsim {

/// The larger of two lengths.
struct PieceLength {
  double diameters = 0;  ///< of the tool
  double voxels = 0;     ///< of the voxel that is sampled; above 0
};

/// How long pieces are; longer where they would be too many.
struct PieceRule {
  PieceLength length;
  double most = 0;         ///< pieces of one motion
  std::size_t in_all = 0;  ///< motions of a program that has more are not divided
  bool arcs = false;       ///< arcs, too; else an arc is one piece
  PieceLength plunge;      ///< of a mill's or drill's way along its axis
};

/// The motions of a list in pieces that sweep together what these do.
struct CutPieces {
  std::vector<Motion> motions;
  std::vector<std::size_t> first;  ///< #motions of the list + 1: first piece of each, and the end

  /// The pieces; the motions of the list where none is divided.
  std::span<const Motion> of(const CutList& cuts) const {
    return motions.empty() ? cuts.motions() : std::span<const Motion>(motions);
  }
};

/// Number of pieces of one motion, at least 1. `voxel` in mm.
int pieces_of(const Motion& motion, const Tool& tool, double voxel, const PieceRule& rule);

/// The smallest voxel (mm, `voxel` times a power of two) by which the motions are not divided into
/// too many pieces. Infinite where the motions alone are too many.
double piece_voxel(const CutList& cuts, double voxel, const PieceRule& rule);

/// With an infinite voxel each motion is a piece of its own: `motions` is then empty.
CutPieces divide_cuts(const CutList& cuts, double voxel, const PieceRule& rule);

}  // namespace mrsim
