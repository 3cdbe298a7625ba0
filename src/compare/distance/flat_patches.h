// The coplanar patches of a surface, and where a triangle stands to the borders of one.
//
// A CAD model's flat face is one patch, however it was cut into triangles. What lies over a patch
// without crossing its border is as far from the surface as it is high above the plane. On curved
// surfaces a triangle and those about it are nearly flat, and serve in the same way.
#pragma once

#include "compare/distance/nominal.h"

#include <optional>
#include <vector>

namespace mrsim {

using TrianglePiece = std::array<Vec3, 3>;

/// The plane through `point` with the unit normal `normal`.
struct CutPlane {
  Vec3 point, normal;
};

/// Widths below this (mm) are nothing; bounds that rest on FlatPatches are larger by it.
inline constexpr double kSliver = 1e-6;

/// Whether the plane leaves more than a sliver of the piece on both sides.
bool splits(const CutPlane& plane, const TrianglePiece& piece);

class FlatPatches {
 public:
  /// Requires: a mesh that passed require_comparable, and its surface; both must outlive this.
  FlatPatches(const TriMesh& mesh, const NominalSurface& surface, int threads);

  /// How a piece lies over a patch.
  struct Overlay {
    bool inside = false;          ///< the whole piece is over the patch
    double height = 0;            ///< if inside: no point of the piece is farther away
    std::optional<CutPlane> cut;  ///< if not: a border of the patch that divides the piece
  };
  /// Whether the patch of `triangle` has more triangles; overlay() is for those.
  bool is_joined(std::uint32_t triangle) const { return joined_[triangle]; }
  /// Over the patch of the triangle whose face holds `foot`, a point of the surface that lies below
  /// the piece. Neither inside nor a cut: too many borders about it to look at all of them.
  Overlay overlay(const TrianglePiece& piece, std::uint32_t triangle, const Vec3& foot) const;
  /// As overlay(), for the triangle and all that share a corner with it, in place of a patch: no
  /// point of a piece that lies over them is farther from the surface than this; infinite for
  /// others.
  double distance_over_ring(const TrianglePiece& piece, std::uint32_t triangle,
                            const Vec3& foot) const;

 private:
  void join();
  void find_borders();

  const TriMesh& mesh_;
  const TriangleTree& tree_;
  std::vector<std::uint32_t> opposite_;  ///< as find_opposites gives it
  double flatness_ = 0;                  ///< mm that a patch strays from its plane
  std::vector<std::uint32_t> seed_;      ///< #F: the triangle whose plane the patch has
  std::vector<bool> joined_;             ///< #F
  std::optional<TriangleTree> borders_;  ///< of joined patches
  std::vector<std::array<std::uint32_t, 2>> border_seeds_;  ///< of the patches on both sides
};

}  // namespace mrsim
