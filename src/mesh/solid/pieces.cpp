#include "mesh/solid/pieces.h"

#include "core/numbers/trig.h"
#include "core/numbers/units.h"
#include "mesh/solid/half_edges.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include <fmt/format.h>

namespace mrsim {
namespace {

// Whether a component winds about a point off it.
struct WindingQuestion {
  std::uint32_t component = 0;
  Vec3 point;
  double angle = 0;
  bool is_yes() const { return std::fabs(angle) > kTwoPi; }  // half of the full 4 pi
};

// Solid angles [van Oosterom and Strackee 1983]: 4 pi about a point inside, 0 outside.
double solid_angle(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double la = length(a), lb = length(b), lc = length(c);
  return 2 * mrsim::atan2(dot(a, cross(b, c)),
                          la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
}

// Calls body(component, corners) for each triangle.
template <class Body>
void for_each_triangle(const MeshAudit& audit, const MeshSource& mesh, Body body) {
  std::size_t index = 0;
  mesh.for_each_block([&](const MeshBlock& block) {
    const std::vector<std::uint32_t> components = audit.components_of(index++, block);
    for (std::size_t f = 0; f < components.size(); ++f) {
      const auto& t = block.triangles[f];
      body(components[f], to_vec(block.points[t[0]]), to_vec(block.points[t[1]]),
           to_vec(block.points[t[2]]));
    }
  });
}

// The middle of the first triangle of each component.
std::map<std::uint32_t, Vec3> first_places(const MeshAudit& audit, const MeshSource& mesh) {
  std::map<std::uint32_t, Vec3> out;
  for_each_triangle(audit, mesh,
                    [&](std::uint32_t component, const Vec3& a, const Vec3& b, const Vec3& c) {
                      if (out.count(component) == 0) out.emplace(component, 1.0 / 3 * (a + b + c));
                    });
  return out;
}

bool contains(const Box3& outer, const Box3& inner) {
  return outer.lo.x <= inner.lo.x && outer.lo.y <= inner.lo.y && outer.lo.z <= inner.lo.z &&
         outer.hi.x >= inner.hi.x && outer.hi.y >= inner.hi.y && outer.hi.z >= inner.hi.z;
}

Piece piece_of(const SurfaceComponent& surface, std::uint32_t index) {
  Piece piece;
  piece.bounds = surface.bounds;
  piece.triangles = surface.triangles;
  piece.components = {index};
  return piece;
}

// Solids around each cavity by their bounds, the smallest first.
std::vector<std::uint32_t> solids_around(const SurfaceComponent& cavity,
                                         const std::vector<SurfaceComponent>& surfaces) {
  std::vector<std::uint32_t> out;
  for (std::uint32_t c = 0; c < surfaces.size(); ++c)
    if (surfaces[c].volume() > 0 && contains(surfaces[c].bounds, cavity.bounds)) out.push_back(c);
  std::stable_sort(out.begin(), out.end(), [&](std::uint32_t a, std::uint32_t b) {
    return surfaces[a].volume() < surfaces[b].volume();
  });
  return out;
}

using Lists = std::map<std::uint32_t, std::vector<std::uint32_t>>;

// For each component, those of its candidates that it lies in, in their order.
Lists components_around(const MeshAudit& audit, const MeshSource& mesh, const Lists& candidates) {
  Lists out;
  if (candidates.empty()) return out;
  const std::map<std::uint32_t, Vec3> places = first_places(audit, mesh);
  std::map<std::uint32_t, std::vector<WindingQuestion>> questions;
  std::multimap<std::uint32_t, WindingQuestion*> asked;  // by the component around
  for (const auto& [inner, list] : candidates)
    for (const std::uint32_t outer : list) questions[inner].push_back({outer, places.at(inner)});
  for (auto& [inner, list] : questions)
    for (WindingQuestion& question : list) asked.emplace(question.component, &question);
  for_each_triangle(audit, mesh,
                    [&](std::uint32_t component, const Vec3& a, const Vec3& b, const Vec3& c) {
                      const auto [first, last] = asked.equal_range(component);
                      for (auto at = first; at != last; ++at) {
                        const Vec3& p = at->second->point;
                        at->second->angle += solid_angle(a - p, b - p, c - p);
                      }
                    });
  for (const auto& [inner, list] : questions)
    for (const WindingQuestion& question : list)
      if (question.is_yes()) out[inner].push_back(question.component);
  return out;
}

// The solid that each cavity lies in; a cavity of a faulty mesh may have none.
std::map<std::uint32_t, std::uint32_t> solids_of_cavities(const MeshAudit& audit,
                                                          const MeshSource& mesh) {
  const std::vector<SurfaceComponent>& surfaces = audit.components();
  Lists candidates;
  for (std::uint32_t c = 0; c < surfaces.size(); ++c)
    if (!(surfaces[c].volume() > 0)) candidates[c] = solids_around(surfaces[c], surfaces);
  std::map<std::uint32_t, std::uint32_t> out;
  for (const auto& [cavity, solids] : components_around(audit, mesh, candidates))
    out.emplace(cavity, solids.front());
  return out;
}

void set_volume(Piece& piece, const MeshAudit& audit) {
  OrderlessSum volume6, moment24[3];
  for (const std::uint32_t c : piece.components) {
    const SurfaceComponent& surface = audit.components()[c];
    volume6.add(surface.volume6);
    for (int a = 0; a < 3; ++a) moment24[a].add(surface.moment24[a]);
  }
  piece.volume = volume6.value() / 6;
  for (int a = 0; a < 3; ++a)
    component(piece.center, a) =
        component(audit.center(), a) + moment24[a].value() / 24 / piece.volume;
}

}  // namespace

std::vector<Piece> find_pieces(const MeshAudit& audit, const MeshSource& mesh) {
  const std::vector<SurfaceComponent>& surfaces = audit.components();
  std::vector<Piece> pieces;
  std::map<std::uint32_t, std::size_t> piece_of_solid;
  for (std::uint32_t c = 0; c < surfaces.size(); ++c) {
    if (!(surfaces[c].volume() > 0)) continue;
    piece_of_solid.emplace(c, pieces.size());
    pieces.push_back(piece_of(surfaces[c], c));
  }
  for (const auto& [cavity, solid] : solids_of_cavities(audit, mesh)) {
    Piece& piece = pieces[piece_of_solid.at(solid)];
    piece.triangles += surfaces[cavity].triangles;
    piece.components.push_back(cavity);
  }
  for (Piece& piece : pieces) set_volume(piece, audit);
  std::stable_sort(pieces.begin(), pieces.end(),
                   [](const Piece& a, const Piece& b) { return a.volume > b.volume; });
  return pieces;
}

std::vector<Piece> find_pieces(const TriMesh& mesh) {
  MeshAudit audit;
  audit.take(whole_block(mesh));
  return find_pieces(audit, MemoryMesh(mesh));
}

namespace {

// The axis along which these boxes overlap least: the sum of their widths over that of all.
int sparse_axis(const std::vector<SurfaceComponent>& surfaces) {
  Box3 all;
  Vec3 sum;
  for (const SurfaceComponent& s : surfaces) {
    extend(all, s.bounds.lo);
    extend(all, s.bounds.hi);
    sum = sum + (s.bounds.hi - s.bounds.lo);
  }
  int best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const double share = component(sum, axis) / component(all.hi - all.lo, axis);
    if (share < least) least = share, best = axis;
  }
  return best;
}

// For each component, those whose box holds its box. A plane goes along an axis and keeps the boxes
// that it passes: O(n log n + n m), m of them at once.
Lists boxes_around(const std::vector<SurfaceComponent>& surfaces) {
  const int axis = sparse_axis(surfaces);
  const auto low = [&](std::uint32_t c) { return component(surfaces[c].bounds.lo, axis); };
  const auto high = [&](std::uint32_t c) { return component(surfaces[c].bounds.hi, axis); };
  std::vector<std::uint32_t> order(surfaces.size()), passed;
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return low(a) < low(b); });
  Lists out;
  for (const std::uint32_t c : order) {
    const Box3& box = surfaces[c].bounds;
    std::erase_if(passed, [&](std::uint32_t other) { return high(other) < low(c); });
    for (const std::uint32_t other : passed) {
      if (contains(surfaces[other].bounds, box)) out[c].push_back(other);
      if (contains(box, surfaces[other].bounds)) out[other].push_back(c);
    }
    passed.push_back(c);
  }
  return out;
}

}  // namespace

std::optional<MisplacedBody> find_misplaced_body(const TriMesh& mesh) {
  MeshAudit audit;
  audit.take(whole_block(mesh));
  const std::vector<SurfaceComponent>& surfaces = audit.components();
  const Lists around = components_around(audit, MemoryMesh(mesh), boxes_around(surfaces));
  for (std::uint32_t c = 0; c < surfaces.size(); ++c) {
    const auto at = around.find(c);
    const bool within = at != around.end() && at->second.size() % 2 == 1;
    if (within != (surfaces[c].volume() > 0)) continue;
    return MisplacedBody{first_places(audit, MemoryMesh(mesh)).at(c), within};
  }
  return std::nullopt;
}

std::string describe_piece(const Piece& piece) {
  const Vec3 side = piece.bounds.hi - piece.bounds.lo;
  return fmt::format(
      "detached piece of {:.4g} mm3 at ({:.4g}, {:.4g}, {:.4g}) mm, {:.4g} x {:.4g} "
      "x {:.4g} mm",
      piece.volume, piece.center.x + 0.0, piece.center.y + 0.0, piece.center.z + 0.0, side.x,
      side.y, side.z);
}

PieceOfMesh::PieceOfMesh(const MeshAudit& audit, const MeshSource& mesh, const Piece& piece)
    : audit_(audit), mesh_(mesh), wanted_(audit.components().size(), false) {
  for (const std::uint32_t c : piece.components) {
    wanted_[c] = true;
    vertices_ += audit.components()[c].vertices;
    triangles_ += audit.components()[c].triangles;
  }
}

// Vertices keep their order and are numbered anew, those of a former block as long as they are
// unfinished.
void PieceOfMesh::for_each_block(const Body& body) const {
  constexpr std::uint32_t kDropped = ~0u;
  std::map<std::uint32_t, std::uint32_t> renumbered;  // unfinished vertices
  std::uint32_t first_new = 0;
  std::size_t index = 0;
  mesh_.for_each_block([&](const MeshBlock& block) {
    const std::vector<std::uint32_t> components = audit_.components_of(index++, block);
    std::vector<std::uint32_t> at(block.points.size(), kDropped), borrowed, unfinished;
    for (std::size_t f = 0; f < components.size(); ++f)
      if (wanted_[components[f]])
        for (const std::uint32_t v : block.triangles[f]) at[v] = 0;
    TriMesh kept;
    for (std::size_t v = 0; v < at.size(); ++v) {
      if (at[v] == kDropped) continue;
      at[v] = static_cast<std::uint32_t>(kept.vertices.size());
      kept.vertices.push_back(block.points[v]);
      if (v < block.borrowed.size())
        borrowed.push_back(renumbered.at(block.borrowed[v]));
      else if (!block.colors.empty())
        kept.colors.push_back(block.colors[v - block.borrowed.size()]);
    }
    for (std::size_t f = 0; f < components.size(); ++f) {
      if (!wanted_[components[f]]) continue;
      const auto& t = block.triangles[f];
      kept.triangles.push_back({at[t[0]], at[t[1]], at[t[2]]});
      if (!block.owners.empty()) kept.owners.push_back(block.owners[f]);
    }
    std::map<std::uint32_t, std::uint32_t> still;
    for (const std::uint32_t number : block.unfinished) {
      const auto known = renumbered.find(number);
      std::uint32_t renamed = kDropped;
      if (known != renumbered.end())
        renamed = known->second;
      else if (number >= block.first_new)
        renamed = at[number - block.first_new + block.borrowed.size()];
      if (renamed == kDropped) continue;
      if (known == renumbered.end())
        renamed += first_new - static_cast<std::uint32_t>(borrowed.size());
      still.emplace_hint(still.end(), number, renamed);
      unfinished.push_back(renamed);
    }
    const MeshBlock out{kept.vertices, borrowed,    first_new, kept.triangles,
                        kept.owners,   kept.colors, unfinished};
    first_new += static_cast<std::uint32_t>(out.fresh().size());
    renumbered = std::move(still);
    body(out);
  });
}

TriMesh collected(const MeshSource& mesh) {
  MeshCollector collector;
  mesh.for_each_block([&](const MeshBlock& block) { collector.take(block); });
  collector.mesh().origin = mesh.origin();
  return std::move(collector.mesh());
}

TriMesh extract_piece(const TriMesh& mesh, const Piece& piece) {
  MeshAudit audit;
  audit.take(whole_block(mesh));
  return collected(PieceOfMesh(audit, MemoryMesh(mesh), piece));
}

}  // namespace mrsim
