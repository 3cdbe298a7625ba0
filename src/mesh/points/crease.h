// Creases, in which faces of the part meet: whether two faces join smoothly, and where their crease
// passes a cell or a face of one (docs/mesh.md, Vertices).
#pragma once

#include "mesh/points/surface_search.h"

#include <optional>
#include <span>

namespace mrsim::detail {

/// Share of a room's diagonal: how far a ridge may lie beyond it.
inline constexpr double kRidgeReach = 2;

/// A point of the surface and the unit normal of the part's face there.
struct SurfaceElement {
  Vec3 position, normal;
};
/// True where the surface between the two points leaves their chord so little that a cell of `size`
/// mm may cut off a crease between them. A sufficient test, for any faces.
bool is_nearly_flat(const Probe& probe, const SurfaceElement& a, const SurfaceElement& b,
                    double size);

/// True where the two faces join smoothly about p, or so nearly that a cell of `size` mm may cut
/// off their crease: none is looked for.
bool join_smoothly(const Probe& probe, const Vec3& p, const FieldSample& a, const FieldSample& b,
                   double size);
/// join_smoothly() for faces with these unit normals.
bool join_smoothly(const Probe& probe, const Vec3& n, const Vec3& m, double size);

/// Newton's iteration from p to the common zero of up to three faces of the part, within the plane
/// where coordinate `plane_axis` is kept (-1: none). False where it does not settle near `room`.
/// `planes`: of the faces at p, if they are known.
bool solve_faces(const ExactField& field, std::span<const FieldSample> faces, int plane_axis,
                 const Box3& room, Vec3& p, const FacePlane* planes = nullptr);

/// Whether p is on the surface and strictly inside the room (`flat`: the axis on which the room has
/// no extent, or -1).
bool accept(const Probe& probe, const Vec3& p, const Box3& room, int flat);

/// Whether the crease between two faces was found; `none`: there is none to be found.
enum class CreaseSearch : std::uint8_t { found, not_found, none };

/// The crease between two faces in the room, searched from p on, in the plane across the given axis
/// (-1: in space). Where a third face lies between the two, it replaces the one whose normal is
/// like its own: along rows of short moves few pairs of faces meet in the crease. None where the
/// third face joins both smoothly.
CreaseSearch crease_by_exchange(const Probe& probe, const Box3& room, int axis, Vec3 p,
                                FieldSample a, FieldSample b, SurfacePoint& found);

/// A crease in the room on the surface between two of its points. False where that joins their
/// faces smoothly; true and count = 0 where none is found.
bool crease_between(const Probe& probe, const Box3& room, int axis, const Vec3& from, FieldSample a,
                    const Vec3& to, FieldSample b, SurfacePoint& found);

/// Where a crease passes the rectangle between two points of the surface on its border, which lie
/// on faces a and b of the part; count = 0: not found. Nothing where the surface between them joins
/// both smoothly.
std::optional<SurfacePoint> crease_in_face(const Probe& probe, const Box3& room, int axis,
                                           const Vec3& from, const FieldSample& a, const Vec3& to,
                                           const FieldSample& b);

}  // namespace mrsim::detail
