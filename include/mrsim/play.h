/// mrsim: what a page needs to play a run: the stock at every moment, and the tools.
///
/// Motions are divided into pieces; moment n is the end of the n-th piece, and moment 0 is the
/// stock before the first one. The stock is divided into voxels, each with the moment from which it
/// is gone. A face between two voxels that go at different moments is seen from the first of the
/// two until the second (docs/report.md). Standard library types only.
#pragma once

#include <mrsim/types.h>

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace mrsim {

/// The moment of a voxel that no motion removes.
inline constexpr std::int32_t kNeverGoes = std::numeric_limits<std::int32_t>::max();

/// Where the part's surface crosses the way between the centres of two voxels, and its outward
/// normal.
struct FaceSurface {
  std::uint8_t share = 0;         ///< of the way from the lower voxel to the upper, / 255
  std::uint8_t u = 127, v = 127;  ///< octahedral map of the normal: -1 .. 1 as 0 .. 254
};

/// A later motion that moves a face, within its voxels, to where it stays.
struct LateSurface {
  std::uint32_t face = 0;   ///< index into Play::faces
  std::int32_t moment = 0;  ///< from which on
  FaceSurface surface;
};

/// Half of a tool's section, mm: (r, z) from the axis and the tip upwards; of an insert, (x, z)
/// about the programmed point, a closed polygon.
struct ToolOutline {
  std::string part;  ///< "cutter", "shank", "holder" or "insert"
  std::vector<std::array<double, 2>> points;
  double round = 0;  ///< the polygon is thickened by this
  bool insert = false;
};

struct Play {
  double voxel = 0;                    ///< mm; 0 = without a stock
  bool half_plane = false;             ///< voxels stand for rings about the Z axis: (x, 0, z)
  Vec3 origin;                         ///< mm, centre of the first voxel
  std::array<std::int32_t, 3> size{};  ///< voxels by axis
  std::vector<std::int32_t> gone;      ///< by voxel, z fastest, then y: moment, 0 = never there
  /// One for each two neighbouring voxels of different moments: by the lower voxel in the order of
  /// `gone`, then by axis. The surface is that of the motion that removes the first of the two.
  std::vector<FaceSurface> faces;
  std::vector<LateSurface> late;  ///< ascending by face, at most one for each
  /// #motions + 1: the moment at which each motion begins; empty = nothing was prepared
  std::vector<std::int32_t> first;
  std::vector<double> removed;                  ///< #motions, mm^3
  std::vector<std::vector<ToolOutline>> tools;  ///< as Program::tools
};

/// The path alone, without a stock: motions that remove nothing, and outlines of the tools whose
/// shapes are valid; the others have none. Throws nothing. Cost: linear in motions and tools.
MRSIM_API Play path_play(const Program& program);

}  // namespace mrsim
