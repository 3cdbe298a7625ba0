#include "mesh/surface/loop_triangles.h"

#include "core/process/parallel.h"
#include "mesh/points/vertex.h"
#include "mesh/solid/exact_predicates.h"

#include <algorithm>

namespace mrsim::detail {
namespace {

bool is_on(const SurfacePoint& p, const SurfacePoint& crease) {
  return has_face(p, crease.faces[0]) && has_face(p, crease.faces[1]);
}

}  // namespace

void LoopTriangles::make() {
  mesh_.vertices.clear();
  mesh_.triangles.clear();
  mesh_.crossings.clear();
  mesh_.moved.clear();
  mesh_.vertices.reserve(2 * loops_.size());
  mesh_.triangles.reserve(4 * loops_.size());
  mesh_.crossings.reserve(4 * loops_.size());
  for (const Loop& loop : loops_) mesh_.vertices.push_back(loop.point.position);
  choose_explicit();
  for (std::size_t k = 0; k < crossings_.size(); ++k)
    if (crossings_[k].edge.owned) add_polygon(static_cast<std::int32_t>(k));
}

// A segment needs no vertex of its own where the line between the vertices on both sides passes
// through the face, and no crease is cut short.
bool LoopTriangles::may_be_implicit(const Segment& s) const {
  const CellFace& face = at(faces_, s.face);
  if (face.count != 2 || loops_in_cell_[static_cast<std::size_t>(face.low)] > 1 ||
      loops_in_cell_[static_cast<std::size_t>(face.high)] > 1)
    return false;
  const Loop &low = at(loops_, s.low), &high = at(loops_, s.high);
  if (s.crease >= 0) {
    const SurfacePoint& crease = at(creases_, s.crease).point;
    if (crease.count == 2 && !(is_on(low.point, crease) && is_on(high.point, crease))) return false;
  }
  return passes_inside(face_box(face), face.axis, low.point.position, high.point.position);
}

void LoopTriangles::choose_explicit() {
  std::vector<std::uint8_t> chosen(segments_.size());
  parallel_for(
      segments_.size(), options_.threads,
      [&](std::size_t k) {
        const CellFace& face = at(faces_, segments_[k].face);
        const Segment& s = segments_[k];
        const bool is_full = at(crossings_, s.from).detail == Detail::full ||
                             at(crossings_, s.to).detail == Detail::full;
        chosen[k] = face.low_complete && face.high_complete && (is_full || !may_be_implicit(s));
      },
      256);
  std::vector<std::int32_t> ids;
  for (std::size_t k = 0; k < chosen.size(); ++k) {
    segments_[k].vertex = -1;
    if (chosen[k]) {
      segments_[k].vertex = static_cast<std::int32_t>(mesh_.vertices.size() + ids.size());
      ids.push_back(static_cast<std::int32_t>(k));
    }
  }
  const std::size_t first = mesh_.vertices.size();
  mesh_.vertices.resize(first + ids.size());
  parallel_for(
      ids.size(), options_.threads,
      [&](std::size_t i) { mesh_.vertices[first + i] = explicit_vertex(at(segments_, ids[i])); },
      16);
}

Vec3 LoopTriangles::explicit_vertex(const Segment& s) const {
  const CellFace& face = at(faces_, s.face);
  const Box3 box = face_box(face);
  const Crossing &a = at(crossings_, s.from), &b = at(crossings_, s.to);
  SurfacePoint point;
  if (s.crease >= 0) point = at(creases_, s.crease).point;
  if (point.count == 0 && face.count == 2) {
    const Probe p = probe(face_cell(face));
    point = point_in_face(p, box, face.axis, 0.5 * (a.position + b.position), a.at);
    const Vec3 ends[] = {a.low_end(), a.high_end()};
    if (point.count == 0) point = point_towards_middle(p, box, ends);
  }
  if (face.count == 4) point = point_between(face, box, a, b);
  if (point.count == 0) point.position = 0.5 * (a.position + b.position);
  return snap_inside(point.position, box, face.axis);
}

// The vertex of a segment in a face with two: it lies between the corner that the segment cuts off
// and the face's centre, so that the two stay apart.
SurfacePoint LoopTriangles::point_between(const CellFace& face, const Box3& box, const Crossing& a,
                                          const Crossing& b) const {
  const Probe p = probe(face_cell(face));
  Vec3 corner = box.lo;
  for (const Crossing* c : {&a, &b}) {
    const int across = 3 - face.axis - c->edge.axis;
    mrsim::component(corner, across) = mrsim::component(c->position, across);
  }
  const Vec3 center = 0.5 * (box.lo + box.hi);
  SurfacePoint result;
  const bool corner_inside = is_inside(p.sample(corner).distance);
  result.position = corner_inside ? find_place(p, corner, center) : find_place(p, center, corner);
  result.faces[0] = p.sample(result.position);
  result.count = 1;
  return result;
}

void LoopTriangles::add_triangle(std::int32_t crossing, std::uint32_t a, std::uint32_t b,
                                 std::uint32_t c) {
  mesh_.triangles.push_back({a, b, c});
  mesh_.crossings.push_back(crossing);
}

// Two triangles (or one) without a vertex on the edge itself, if both separate the edge's ends.
bool LoopTriangles::add_flat_polygon(const Crossing& c, std::span<const std::uint32_t> ring,
                                     std::int32_t id) {
  Vec3 from = c.low_end(), to = c.high_end();
  if (!c.edge.low_inside) std::swap(from, to);
  const auto separates = [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
    const TriangleSide side(mesh_.vertices[i], mesh_.vertices[j], mesh_.vertices[k]);
    return side(to) > 0 && side(from) < 0;
  };
  if (ring.size() == 3) {
    if (!separates(ring[0], ring[1], ring[2])) return false;
    add_triangle(id, ring[0], ring[1], ring[2]);
    return true;
  }
  // The diagonal nearer to the surface, if it can be, else the other.
  const auto is_valid = [&](std::uint32_t d) {
    return separates(ring[d], ring[d + 1], ring[d + 2]) &&
           separates(ring[d], ring[d + 2], ring[(d + 3) & 3]);
  };
  const auto error = [&](std::uint32_t d) {
    const Vec3 middle = 0.5 * (mesh_.vertices[ring[d]] + mesh_.vertices[ring[d + 2]]);
    return std::abs(field_.patch_distance(middle, c.at));
  };
  std::uint32_t d = error(1) < error(0) ? 1 : 0;
  if (!is_valid(d) && !is_valid(d = 1 - d)) return false;
  add_triangle(id, ring[d], ring[d + 1], ring[d + 2]);
  add_triangle(id, ring[d], ring[d + 2], ring[(d + 3) & 3]);
  return true;
}

void LoopTriangles::add_polygon(std::int32_t id) {
  const Crossing& c = at(crossings_, id);
  const bool up = c.edge.low_inside;
  std::uint32_t vertices[8];  // of four cells and the faces between them
  std::size_t count = 0;
  bool plain = c.detail == Detail::flat;
  for (int k = 0; k < 4; ++k) {
    const int i = up ? k : 3 - k;
    const auto loop = static_cast<std::uint32_t>(c.loops[i]);
    if (count == 0 || vertices[count - 1] != loop) vertices[count++] = loop;
    const std::int32_t s = up ? c.segments[i] : c.segments[(i + 3) & 3];
    if (s >= 0 && at(segments_, s).vertex >= 0) {
      vertices[count++] = static_cast<std::uint32_t>(at(segments_, s).vertex);
      plain = false;
    }
  }
  if (vertices[count - 1] == vertices[0]) --count;
  if (count < 3) return;  // within a square of cells, or on its side
  const std::span<const std::uint32_t> ring(vertices, count);
  if (plain && add_flat_polygon(c, ring, id)) return;
  const auto apex = static_cast<std::uint32_t>(mesh_.vertices.size());
  mesh_.vertices.push_back(c.position);
  for (std::size_t k = 0; k < ring.size(); ++k)
    add_triangle(id, apex, ring[k], ring[(k + 1) % ring.size()]);
}

}  // namespace mrsim::detail
