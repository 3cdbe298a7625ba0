#include "mesh/pieces.h"

#include "core/trig.h"
#include "core/units.h"
#include "mesh/half_edges.h"
#include "mesh/weld.h"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

namespace mrsim {
namespace {

// A closed component of the surface: outwards (a solid) or inwards (a cavity).
struct Shell {
  std::uint32_t component = 0;
  double volume = 0;  // signed
  Vec3 moment;        // volume times centre
  Box3 bounds;
  std::vector<std::uint32_t> triangles;
};

std::vector<Shell> find_shells(const TriMesh& mesh) {
  std::vector<std::uint32_t> component;
  std::vector<Shell> shells(find_components(mesh, component));
  if (shells.empty()) return shells;
  const Vec3 center = corner(mesh, 0, 0);
  for (std::uint32_t f = 0; f < component.size(); ++f) {
    Shell& shell = shells[component[f]];
    shell.component = component[f];
    shell.triangles.push_back(f);
    const Vec3 a = corner(mesh, f, 0) - center, b = corner(mesh, f, 1) - center,
               c = corner(mesh, f, 2) - center;
    const double volume = dot(a, cross(b, c)) / 6;
    shell.volume += volume;
    shell.moment += 0.25 * volume * (a + b + c);
    for (const Vec3& p : {a, b, c}) extend(shell.bounds, p + center);
  }
  for (Shell& shell : shells) shell.moment += shell.volume * center;
  return shells;
}

// How often the shell winds about p, by solid angles [van Oosterom and Strackee 1983]: 1 inside, 0
// outside, for any p off the surface.
bool winds_about(const TriMesh& mesh, const Shell& shell, const Vec3& p) {
  double angle = 0;
  for (const std::uint32_t f : shell.triangles) {
    const Vec3 a = corner(mesh, f, 0) - p, b = corner(mesh, f, 1) - p, c = corner(mesh, f, 2) - p;
    const double la = length(a), lb = length(b), lc = length(c);
    angle += 2 * mrsim::atan2(dot(a, cross(b, c)),
                              la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
  }
  return angle > kTwoPi;  // half of the full 4 pi
}

bool contains(const Box3& outer, const Box3& inner) {
  return outer.lo.x <= inner.lo.x && outer.lo.y <= inner.lo.y && outer.lo.z <= inner.lo.z &&
         outer.hi.x >= inner.hi.x && outer.hi.y >= inner.hi.y && outer.hi.z >= inner.hi.z;
}

Piece piece_of(const Shell& shell) {
  Piece piece;
  piece.volume = shell.volume;
  piece.center = shell.moment;  // divided at the end
  piece.bounds = shell.bounds;
  piece.triangles = shell.triangles.size();
  piece.components = {shell.component};
  return piece;
}

}  // namespace

std::vector<Piece> find_pieces(const TriMesh& mesh) {
  const std::vector<Shell> shells = find_shells(mesh);
  std::vector<Piece> pieces;
  std::vector<const Shell*> outer;
  for (const Shell& shell : shells)
    if (shell.volume > 0) {
      pieces.push_back(piece_of(shell));
      outer.push_back(&shell);
    }
  for (const Shell& cavity : shells) {
    if (cavity.volume > 0) continue;
    // The smallest solid around it; none only where the mesh is not what was asked for.
    std::size_t best = pieces.size();
    for (std::size_t i = 0; i < outer.size(); ++i)
      if (contains(outer[i]->bounds, cavity.bounds) &&
          (best == pieces.size() || outer[i]->volume < outer[best]->volume) &&
          winds_about(mesh, *outer[i], corner(mesh, cavity.triangles[0], 0)))
        best = i;
    if (best == pieces.size()) continue;
    pieces[best].volume += cavity.volume;
    pieces[best].center += cavity.moment;
    pieces[best].triangles += cavity.triangles.size();
    pieces[best].components.push_back(cavity.component);
  }
  for (Piece& piece : pieces) piece.center = (1 / piece.volume) * piece.center;
  std::stable_sort(pieces.begin(), pieces.end(),
                   [](const Piece& a, const Piece& b) { return a.volume > b.volume; });
  return pieces;
}

std::string describe_piece(const Piece& piece) {
  const Vec3 side = piece.bounds.hi - piece.bounds.lo;
  return fmt::format(
      "detached piece of {:.4g} mm3 at ({:.4g}, {:.4g}, {:.4g}) mm, {:.4g} x {:.4g} "
      "x {:.4g} mm",
      piece.volume, piece.center.x + 0.0, piece.center.y + 0.0, piece.center.z + 0.0, side.x,
      side.y, side.z);
}

TriMesh extract_piece(const TriMesh& mesh, const Piece& piece) {
  std::vector<std::uint32_t> component;
  const std::size_t count = find_components(mesh, component);
  std::vector<bool> wanted(count, false);
  for (const std::uint32_t c : piece.components) wanted[c] = true;
  TriMesh out;
  out.vertices = mesh.vertices;
  out.colors = mesh.colors;
  out.origin = mesh.origin;
  for (std::size_t f = 0; f < component.size(); ++f) {
    if (!wanted[component[f]]) continue;
    out.triangles.push_back(mesh.triangles[f]);
    if (!mesh.owners.empty()) out.owners.push_back(mesh.owners[f]);
  }
  drop_unused_vertices(out);
  return out;
}

}  // namespace mrsim
