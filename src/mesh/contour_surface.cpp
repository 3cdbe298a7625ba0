// From loops to triangles. A loop's vertex lies strictly inside its cell, a segment's strictly
// inside its face, a crossing strictly inside its edge: cones from the loops' vertices over their
// segments can not meet, and where face and edge vertices are left out, orientation tests see to it
// that each polygon stays in the envelope of its edge [Ju and Udeshi 2006].
#include "mesh/contour_surface.h"

#include "core/error.h"
#include "core/parallel.h"
#include "mesh/contour_hash.h"
#include "mesh/exact_predicates.h"

#include <algorithm>

namespace mrsim::detail {
namespace {

template <class T>
const T& at(const std::vector<T>& v, std::int32_t i) {
  return v[static_cast<std::size_t>(i)];
}

bool has_face(const SurfacePoint& p, const FieldSample& face) {
  for (int k = 0; k < p.count; ++k)
    if (same_face(p.faces[k], face)) return true;
  return false;
}

void add(PlaceHash& hash, const Crossing& c) {
  hash.add(c.position);
  hash.add(c.at);
}

}  // namespace

const BaseMesh& ContourSurface::make_triangles() {
  mesh_ = {};
  place_creases();
  place_loops();
  mesh_.vertices.reserve(2 * loops_.size());
  mesh_.triangles.reserve(4 * loops_.size());
  mesh_.crossings.reserve(4 * loops_.size());
  for (const Loop& loop : loops_) mesh_.vertices.push_back(loop.point.position);
  choose_explicit();
  for (std::size_t k = 0; k < crossings_.size(); ++k)
    if (crossings_[k].edge.owned) add_polygon(static_cast<std::int32_t>(k));
  return mesh_;
}

void ContourSurface::place_creases() {
  std::vector<std::uint64_t> fresh(segments_.size(), 0);  // keys of what is not known yet
  parallel_for(
      segments_.size(), options_.threads,
      [&](std::size_t k) {
        Segment& s = segments_[k];
        const CellFace& face = at(faces_, s.face);
        if (same_face(at(crossings_, s.from).at, at(crossings_, s.to).at) ||
            (!cells_.is_complete(face.low) && !cells_.is_complete(face.high)))
          return;
        const std::uint64_t key = options_.remember ? key_of(s) : 0;
        if (const PlacedPoints::Place* known = key ? placed_creases_.find(key) : nullptr) {
          s.point = known->point;
          s.outside = known->outside;
          s.is_crease = known->is_crease;
          return;
        }
        place_crease(s);
        fresh[k] = key;
      },
      64);
  for (std::size_t k = 0; k < fresh.size(); ++k)
    if (fresh[k])
      placed_creases_.add(fresh[k],
                          {segments_[k].point, segments_[k].outside, segments_[k].is_crease});
}

// Where the faces of the part at a segment's ends meet in a crease, find where it passes the face
// of the cell.
void ContourSurface::place_crease(Segment& s) const {
  const Crossing &a = at(crossings_, s.from), &b = at(crossings_, s.to);
  const Vec3 middle = 0.5 * (a.position + b.position);
  const CellFace& face = at(faces_, s.face);
  const Box3 box = face_box(face);
  const Probe p = probe(face_cell(face));
  if (join_smoothly(p, middle, a.at, b.at, length(box.hi - box.lo))) return;
  s.is_crease = true;
  s.point = crease_in_face(p, box, face.axis, a.position, a.at, b.position, b.at);
  const FieldSample ends[2] = {a.at, b.at};
  if (options_.sharpen && s.point.count == 0)
    s.outside = crease_near(p, box, face.axis, middle, ends);
}

void ContourSurface::place_loops() {
  std::vector<std::uint64_t> fresh(loops_.size(), 0);
  parallel_for(
      loops_.size(), options_.threads,
      [&](std::size_t k) {
        Loop& loop = loops_[k];
        if (!cells_.is_complete(loop.cell)) return;
        const std::uint64_t key = options_.remember ? key_of(loop) : 0;
        if (const PlacedPoints::Place* known = key ? placed_loops_.find(key) : nullptr) {
          loop.point = known->point;
          loop.outside = known->outside;
          return;
        }
        place_loop(loop);
        fresh[k] = key;
      },
      32);
  for (std::size_t k = 0; k < fresh.size(); ++k)
    if (fresh[k]) placed_loops_.add(fresh[k], {loops_[k].point, loops_[k].outside});
}

// Cells and their candidates stay as long as the tree: the rest is told by the crossings.
std::uint64_t ContourSurface::key_of(const Segment& s) const {
  const CellFace& face = at(faces_, s.face);
  const std::int32_t cell = face_cell(face);
  PlaceHash hash(static_cast<std::uint64_t>(cell) * 8 +
                 static_cast<std::uint64_t>(2 * face.axis + (cell == face.low)));
  for (const std::int32_t k : {s.from, s.to}) add(hash, at(crossings_, k));
  return hash.value();
}

std::uint64_t ContourSurface::key_of(const Loop& loop) const {
  PlaceHash hash(static_cast<std::uint64_t>(loop.cell));
  for (const std::int32_t k : loop.crossings) add(hash, at(crossings_, k));
  for (const std::int32_t k : loop.segments) {
    const Segment& s = at(segments_, k);
    hash.add(static_cast<std::uint64_t>(s.is_crease) << 8 | static_cast<unsigned>(s.point.count));
    if (s.is_crease && s.point.count > 0) hash.add(s.point.position);
  }
  return hash.value();
}

void ContourSurface::place_loop(Loop& loop) const {
  static thread_local std::vector<Vec3> crossings, creases;
  static thread_local std::vector<FieldSample> faces;
  crossings.clear();
  creases.clear();
  faces.clear();
  for (const std::int32_t k : loop.crossings) {
    crossings.push_back(at(crossings_, k).position);
    faces.push_back(at(crossings_, k).at);
  }
  bool is_smooth = true;
  for (const std::int32_t k : loop.segments) {
    const Segment& s = at(segments_, k);
    is_smooth = is_smooth && !s.is_crease;
    if (s.is_crease && s.point.count == 2) creases.push_back(s.point.position);
  }
  const Box3 box = cells_.box(loop.cell);
  const Probe p = probe(loop.cell);
  loop.point = point_in_cell(p, box, {crossings, faces, creases, is_smooth});
  if (options_.sharpen && loop.point.count < 2 && creases.empty()) {
    Vec3 mean;
    for (const Vec3& x : crossings) mean += (1.0 / static_cast<double>(crossings.size())) * x;
    loop.outside = crease_near(p, box, -1, mean, faces);
  }
  if (loop.point.count == 0) {
    std::vector<Vec3> ends;
    for (const std::int32_t k : loop.crossings) add_ends(at(crossings_, k), ends);
    loop.point = point_towards_middle(p, box, ends);
  }
  if (loop.point.count == 0) throw Error("mesh-unresolved", "no vertex in a cell of the mesh");
  loop.point.position = snap_inside(loop.point.position, box);
}

void ContourSurface::add_ends(const Crossing& c, std::vector<Vec3>& out) const {
  out.push_back(low_end(cells_.lattice(), c.edge));
  out.push_back(high_end(cells_.lattice(), c.edge));
}

const Loop& ContourSurface::loop_of(std::int32_t crossing, std::int32_t cell) const {
  const Crossing& c = at(crossings_, crossing);
  for (int i = 0; i < 4; ++i)
    if (c.cell(i) == cell) return at(loops_, c.loops[i]);
  MRSIM_ASSERT(false);
  return loops_.front();
}

bool ContourSurface::vertex_on_crease(const Loop& loop, const Segment& s) const {
  return has_face(loop.point, s.point.faces[0]) && has_face(loop.point, s.point.faces[1]);
}

// A segment needs no vertex of its own where the line between the vertices on both sides passes
// through the face, and no crease is cut short.
bool ContourSurface::may_be_implicit(const Segment& s) const {
  const CellFace& face = at(faces_, s.face);
  if (face.crossings.size() != 2 || loops_in_cell_[static_cast<std::size_t>(face.low)] > 1 ||
      loops_in_cell_[static_cast<std::size_t>(face.high)] > 1)
    return false;
  const Loop &low = loop_of(s.from, face.low), &high = loop_of(s.from, face.high);
  if (s.is_crease && s.point.count == 2 && !(vertex_on_crease(low, s) && vertex_on_crease(high, s)))
    return false;
  const Box3 box = face_box(face);
  const Vec3 &p = low.point.position, &q = high.point.position;
  const double plane = mrsim::component(box.lo, face.axis);
  const double t = (plane - mrsim::component(p, face.axis)) /
                   (mrsim::component(q, face.axis) - mrsim::component(p, face.axis));
  const Vec3 x = lerp(p, q, t);
  for (const int a : {(face.axis + 1) % 3, (face.axis + 2) % 3}) {
    const double lo = mrsim::component(box.lo, a), hi = mrsim::component(box.hi, a);
    const double margin = coordinate_step(lo) + coordinate_step(hi);
    if (!(mrsim::component(x, a) > lo + margin && mrsim::component(x, a) < hi - margin))
      return false;
  }
  return true;
}

void ContourSurface::choose_explicit() {
  parallel_for(
      segments_.size(), options_.threads,
      [&](std::size_t k) {
        Segment& s = segments_[k];
        const CellFace& face = at(faces_, s.face);
        s.is_explicit =
            cells_.is_complete(face.low) && cells_.is_complete(face.high) && !may_be_implicit(s);
        if (!s.is_explicit) return;
        const Box3 box = face_box(face);
        const Crossing &a = at(crossings_, s.from), &b = at(crossings_, s.to);
        if (s.point.count == 0 && face.crossings.size() == 2) {
          const Probe p = probe(face_cell(face));
          s.point =
              point_in_face(p, box, face.axis, 0.5 * (a.position + b.position), a.at, nullptr);
          std::vector<Vec3> ends;
          add_ends(a, ends);
          if (s.point.count == 0) s.point = point_towards_middle(p, box, ends);
        }
        if (face.crossings.size() == 4) s.point = point_between(face, box, a, b);
        s.point.position = snap_inside(s.point.position, box, face.axis);
      },
      64);
  for (Segment& s : segments_)
    if (s.is_explicit) {
      if (s.point.count == 0) throw Error("mesh-unresolved", "no vertex in a face of the mesh");
      s.vertex = static_cast<std::int32_t>(mesh_.vertices.size());
      mesh_.vertices.push_back(s.point.position);
    }
}

// In a face with two segments: between the corner that the segment cuts off and the face's centre,
// so that the two stay apart.
SurfacePoint ContourSurface::point_between(const CellFace& face, const Box3& box, const Crossing& a,
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
  result.position =
      corner_inside ? find_crossing(p, corner, center) : find_crossing(p, center, corner);
  result.faces[0] = p.sample(result.position);
  result.count = 1;
  return result;
}

void ContourSurface::add_triangle(std::int32_t crossing, std::uint32_t a, std::uint32_t b,
                                  std::uint32_t c) {
  mesh_.triangles.push_back({a, b, c});
  mesh_.crossings.push_back(crossing);
}

// Two triangles (or one) without a vertex on the edge itself, if both separate the edge's ends.
bool ContourSurface::add_flat_polygon(const Crossing& c, const std::vector<std::uint32_t>& ring,
                                      std::int32_t id) {
  Vec3 from = low_end(cells_.lattice(), c.edge), to = high_end(cells_.lattice(), c.edge);
  if (!c.edge.low_inside) std::swap(from, to);
  const auto separates = [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
    const Vec3 &p = mesh_.vertices[i], &q = mesh_.vertices[j], &r = mesh_.vertices[k];
    return orientation(p, q, r, to) > 0 && orientation(p, q, r, from) < 0;
  };
  if (ring.size() == 3) {
    if (!separates(ring[0], ring[1], ring[2])) return false;
    add_triangle(id, ring[0], ring[1], ring[2]);
    return true;
  }
  bool valid[2];
  double error[2];
  for (std::uint32_t d = 0; d < 2; ++d) {
    valid[d] = separates(ring[d], ring[d + 1], ring[d + 2]) &&
               separates(ring[d], ring[d + 2], ring[(d + 3) & 3]);
    const Vec3 middle = 0.5 * (mesh_.vertices[ring[d]] + mesh_.vertices[ring[d + 2]]);
    error[d] = valid[d] ? std::abs(field_.patch_distance(middle, c.at)) : 0;
  }
  if (!valid[0] && !valid[1]) return false;
  const std::uint32_t d = !valid[0] || (valid[1] && error[1] < error[0]) ? 1 : 0;
  add_triangle(id, ring[d], ring[d + 1], ring[d + 2]);
  add_triangle(id, ring[d], ring[d + 2], ring[(d + 3) & 3]);
  return true;
}

void ContourSurface::add_polygon(std::int32_t id) {
  const Crossing& c = at(crossings_, id);
  const bool up = c.edge.low_inside;
  static thread_local std::vector<std::uint32_t> ring;
  ring.clear();
  bool plain = true;
  for (int k = 0; k < 4; ++k) {
    const int i = up ? k : 3 - k;
    const auto loop = static_cast<std::uint32_t>(c.loops[i]);
    if (ring.empty() || ring.back() != loop) ring.push_back(loop);
    const std::int32_t s = up ? c.segments[i] : c.segments[(i + 3) & 3];
    if (s >= 0 && at(segments_, s).is_explicit) {
      ring.push_back(static_cast<std::uint32_t>(at(segments_, s).vertex));
      plain = false;
    }
  }
  if (ring.back() == ring.front()) ring.pop_back();
  if (plain && add_flat_polygon(c, ring, id)) return;
  const auto apex = static_cast<std::uint32_t>(mesh_.vertices.size());
  mesh_.vertices.push_back(c.position);
  for (std::size_t k = 0; k < ring.size(); ++k)
    add_triangle(id, apex, ring[k], ring[(k + 1) % ring.size()]);
}

}  // namespace mrsim::detail
