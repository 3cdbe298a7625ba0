// The surfaces of a stock's history: a face between two neighbouring voxels that are removed at
// different moments is visible from the first removal to the second. The sweep that removes the
// first voxel gives the face its place and normal, so that the faces of one moment can be joined to
// the part of that moment (docs/report.md).
#pragma once

#include "removal/history/cut_volume.h"
#include "removal/part/part_field.h"
#include <mrsim/play.h>

#include <cstdint>
#include <vector>

namespace mrsim {

/// When a voxel with this cut is removed. Motions before `inherited` are over when the play begins.
inline std::int32_t moment_of(std::int32_t cut, std::int32_t inherited) {
  if (cut == kStillThere) return kNeverGoes;
  return cut < inherited ? 0 : cut - inherited + 1;
}

struct CutFaces {
  /// What Play::faces holds.
  std::vector<FaceSurface> faces;
  std::vector<LateSurface> late;  ///< ascending by face, at most one for each
};

/// Same result on any number of threads. `volume` is that of `field`; a place is within a
/// thousandth of a voxel of the sweep's surface. Throws Error "memory".
CutFaces make_cut_faces(const PartField& field, const CutVolume& volume, std::int32_t inherited,
                        int threads);

}  // namespace mrsim
