// From loops to triangles. A loop's vertex lies strictly inside its cell, a segment's strictly
// inside its face, a crossing strictly inside its edge: cones from the loops' vertices over their
// segments can not meet, and where face and edge vertices are left out, orientation tests see to it
// that each polygon stays in the envelope of its edge [Ju and Udeshi 2006].
#include "mesh/surface/surface.h"

#include "core/parallel.h"
#include "mesh/solid/exact_predicates.h"
#include "mesh/surface/piece_hash.h"
#include "mesh/surface/sample_groups.h"

#include <algorithm>
#include <numeric>

namespace mrsim::detail {
namespace {

constexpr double kDiagonal = 1.4142135623730951;  ///< of a square

template <class T>
const T& at(const std::vector<T>& v, std::int32_t i) {
  return v[static_cast<std::size_t>(i)];
}

bool has_face(const SurfacePoint& p, const FieldSample& face) {
  for (int k = 0; k < p.count; ++k)
    if (same_face(p.faces[k], face)) return true;
  return false;
}

bool is_on(const SurfacePoint& p, const SurfacePoint& crease) {
  return has_face(p, crease.faces[0]) && has_face(p, crease.faces[1]);
}

void add(PlaceHash& hash, const Crossing& c) {
  hash.add(c.position);
  hash.add(c.at);
}

}  // namespace

const BaseMesh& DualSurface::make_triangles() {
  mesh_.vertices.clear();
  mesh_.triangles.clear();
  mesh_.crossings.clear();
  find_creases();
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

// Segments between faces of the part that meet in a crease, and where it passes the faces of the
// cells.
void DualSurface::find_creases() {
  creases_.clear();
  for (std::size_t k = 0; k < segments_.size(); ++k) {
    Segment& s = segments_[k];
    s.crease = s.is_crease ? static_cast<std::int32_t>(creases_.size()) : -1;
    if (s.is_crease) creases_.push_back({static_cast<std::int32_t>(k), {}, {}});
  }
  std::vector<std::uint64_t> fresh(creases_.size(), 0);  // keys of what is not known yet
  const auto place = [&](std::size_t k) {
    Crease& crease = creases_[k];
    const std::uint64_t key = options_.remember ? key_of(at(segments_, crease.segment)) : 0;
    if (const PlacedPoints::Place* known = key ? placed_creases_.find(key) : nullptr) {
      crease.point = known->point;
      crease.outside = known->outside;
      return;
    }
    place_crease(crease);
    fresh[k] = key;
  };
  // Those of cells with the same candidates follow each other.
  std::vector<std::int32_t> all(creases_.size());
  std::iota(all.begin(), all.end(), 0);
  const Groups groups(all, cells_.lists(), [&](std::int32_t k) {
    return cells_.list_of(face_cell(at(faces_, at(segments_, at(creases_, k).segment).face)));
  });
  parallel_for(
      groups.size(), options_.threads,
      [&](std::size_t g) {
        for (const std::int32_t k : groups[g]) place(static_cast<std::size_t>(k));
      },
      16);
  for (std::size_t k = 0; k < fresh.size(); ++k)
    if (fresh[k]) placed_creases_.add(fresh[k], {creases_[k].point, creases_[k].outside});
}

bool DualSurface::is_crease(const CellFace& face, const Crossing& a, const Crossing& b) const {
  if (same_face(a.at, b.at)) return false;
  const std::int32_t cell = face_cell(face);
  const double size = kDiagonal * cells_.lattice().fine() * cells_.size_of(cell);
  const Probe p = probe(cell);
  return !is_nearly_flat(p, {a.position, a.normal}, {b.position, b.normal}, size) &&
         !join_smoothly(p, 0.5 * (a.position + b.position), a.at, b.at, size);
}

void DualSurface::place_crease(Crease& crease) const {
  const Segment& s = at(segments_, crease.segment);
  const Crossing &a = at(crossings_, s.from), &b = at(crossings_, s.to);
  const CellFace& face = at(faces_, s.face);
  const Box3 box = face_box(face);
  const Probe p = probe_within(face_cell(face));
  crease.point = crease_in_face(p, box, face.axis, a.position, a.at, b.position, b.at);
  const FieldSample ends[2] = {a.at, b.at};
  if (options_.sharpen && crease.point.count == 0)
    crease.outside = crease_near(p, box, face.axis, 0.5 * (a.position + b.position), ends);
}

void DualSurface::place_loops() {
  std::vector<std::uint64_t> keys(options_.remember ? loops_.size() : 0);
  std::vector<std::int32_t> fresh;
  fresh.reserve(loops_.size());
  outside_.assign(options_.sharpen ? loops_.size() : 0, {});
  for (std::size_t k = 0; k < loops_.size(); ++k) {
    Loop& loop = loops_[k];
    if (loop.point.count > 0 || !cells_.is_complete(loop.cell)) continue;
    if (options_.remember) {
      keys[k] = key_of(loop);
      if (const PlacedPoints::Place* known = placed_loops_.find(keys[k])) {
        loop.point = known->point;
        if (options_.sharpen) outside_[k] = known->outside;
        continue;
      }
    }
    fresh.push_back(static_cast<std::int32_t>(k));
  }
  const Groups groups(fresh, cells_.lists(),
                      [&](std::int32_t k) { return cells_.list_of(at(loops_, k).cell); });
  parallel_for(
      groups.size(), options_.threads, [&](std::size_t g) { place_loops_of(groups[g]); }, 16);
  if (!options_.remember) return;
  for (const std::int32_t k : fresh) {
    const auto i = static_cast<std::size_t>(k);
    placed_loops_.add(keys[i], {loops_[i].point, options_.sharpen ? outside_[i] : SurfacePoint{}});
  }
}

// Cells and their candidates stay as long as the tree: the rest is told by the crossings.
std::uint64_t DualSurface::key_of(const Segment& s) const {
  const CellFace& face = at(faces_, s.face);
  const std::int32_t cell = face_cell(face);
  PlaceHash hash(static_cast<std::uint64_t>(cell) * 8 +
                 static_cast<std::uint64_t>(2 * face.axis + (cell == face.low)));
  for (const std::int32_t k : {s.from, s.to}) add(hash, at(crossings_, k));
  return hash.value();
}

std::uint64_t DualSurface::key_of(const Loop& loop) const {
  PlaceHash hash(static_cast<std::uint64_t>(loop.cell));
  for (const std::int32_t k : crossings_of(loop)) add(hash, at(crossings_, k));
  for (const std::int32_t k : segments_of(loop)) {
    const std::int32_t c = at(segments_, k).crease;
    const SurfacePoint* point = c >= 0 ? &at(creases_, c).point : nullptr;
    hash.add(point ? 1u << 8 | static_cast<unsigned>(point->count) : 0u);
    if (point && point->count > 0) hash.add(point->position);
  }
  return hash.value();
}

// Neighbouring crossings lie on one face of the part or on faces that join smoothly.
bool DualSurface::is_smooth(const Loop& loop) const {
  for (const std::int32_t k : segments_of(loop))
    if (at(segments_, k).crease >= 0) return false;
  return true;
}

Vec3 DualSurface::mean_crossing(const Loop& loop) const {
  Vec3 sum;
  for (const std::int32_t k : crossings_of(loop)) sum += at(crossings_, k).position;
  return (1.0 / static_cast<double>(loop.crossings)) * sum;
}

// Loops of cells with the same candidates.
void DualSurface::place_loops_of(std::span<const std::int32_t> loops) {
  struct Memory {
    std::vector<SmoothSearch> searches;
    std::vector<std::int32_t> searched;
  };
  static thread_local Memory memory;
  auto& [searches, searched] = memory;
  searches.clear();
  searched.clear();
  for (const std::int32_t k : loops) {
    const Loop& loop = at(loops_, k);
    const std::span<const std::int32_t> crossings = crossings_of(loop);
    const FieldSample& first = at(crossings_, crossings[0]).at;
    const bool one_face = std::all_of(crossings.begin(), crossings.end(), [&](std::int32_t c) {
      return same_face(at(crossings_, c).at, first);
    });
    if (!one_face && !is_smooth(loop)) continue;
    searches.emplace_back(field_, cells_.box(loop.cell), mean_crossing(loop),
                          one_face ? &first : nullptr);
    searched.push_back(k);
  }
  run_together(probe(at(loops_, loops[0]).cell), std::span(searches));
  for (std::size_t i = 0; i < searched.size(); ++i)
    loops_[static_cast<std::size_t>(searched[i])].point = searches[i].result();
  for (const std::int32_t k : loops) finish_loop(k);
}

void DualSurface::finish_loop(std::int32_t id) {
  Loop& loop = loops_[static_cast<std::size_t>(id)];
  const Box3 box = cells_.box(loop.cell);
  if (loop.point.count == 0 || options_.sharpen) {
    static thread_local std::vector<Vec3> crossings, creases;
    static thread_local std::vector<FieldSample> faces;
    crossings.clear();
    creases.clear();
    faces.clear();
    for (const std::int32_t k : crossings_of(loop)) {
      crossings.push_back(at(crossings_, k).position);
      faces.push_back(at(crossings_, k).at);
    }
    for (const std::int32_t k : segments_of(loop)) {
      const std::int32_t c = at(segments_, k).crease;
      if (c >= 0 && at(creases_, c).point.count == 2)
        creases.push_back(at(creases_, c).point.position);
    }
    const Probe p = probe_within(loop.cell);
    if (loop.point.count == 0) loop.point = point_in_cell(p, box, {crossings, faces, creases});
    if (options_.sharpen && loop.point.count < 2 && creases.empty())
      outside_[static_cast<std::size_t>(id)] = crease_near(p, box, -1, mean_crossing(loop), faces);
    if (loop.point.count == 0) {
      std::vector<Vec3> ends;
      for (const std::int32_t k : crossings_of(loop)) add_ends(at(crossings_, k), ends);
      loop.point = point_towards_middle(p, box, ends);
    }
  }
  // Any point in the cell keeps pieces apart; how far it is from the part is measured later.
  if (loop.point.count == 0)
    loop.point = {mean_crossing(loop), {at(crossings_, crossings_of(loop)[0]).at}, 1};
  loop.point.position = snap_into(loop.point.position, cells_.inner_box(loop.cell));
}

void DualSurface::add_ends(const Crossing& c, std::vector<Vec3>& out) const {
  out.push_back(c.low_end());
  out.push_back(c.high_end());
}

// A segment needs no vertex of its own where the line between the vertices on both sides passes
// through the face, and no crease is cut short.
bool DualSurface::may_be_implicit(const Segment& s) const {
  const CellFace& face = at(faces_, s.face);
  if (face.count != 2 || loops_in_cell_[static_cast<std::size_t>(face.low)] > 1 ||
      loops_in_cell_[static_cast<std::size_t>(face.high)] > 1)
    return false;
  const Loop &low = at(loops_, s.low), &high = at(loops_, s.high);
  if (s.crease >= 0) {
    const SurfacePoint& crease = at(creases_, s.crease).point;
    if (crease.count == 2 && !(is_on(low.point, crease) && is_on(high.point, crease))) return false;
  }
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

void DualSurface::choose_explicit() {
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

Vec3 DualSurface::explicit_vertex(const Segment& s) const {
  const CellFace& face = at(faces_, s.face);
  const Box3 box = face_box(face);
  const Crossing &a = at(crossings_, s.from), &b = at(crossings_, s.to);
  SurfacePoint point;
  if (s.crease >= 0) point = at(creases_, s.crease).point;
  if (point.count == 0 && face.count == 2) {
    const Probe p = probe(face_cell(face));
    point = point_in_face(p, box, face.axis, 0.5 * (a.position + b.position), a.at, nullptr);
    std::vector<Vec3> ends;
    add_ends(a, ends);
    if (point.count == 0) point = point_towards_middle(p, box, ends);
  }
  if (face.count == 4) point = point_between(face, box, a, b);
  if (point.count == 0) point.position = 0.5 * (a.position + b.position);
  return snap_inside(point.position, box, face.axis);
}

// In a face with two segments: between the corner that the segment cuts off and the face's centre,
// so that the two stay apart.
SurfacePoint DualSurface::point_between(const CellFace& face, const Box3& box, const Crossing& a,
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

void DualSurface::add_triangle(std::int32_t crossing, std::uint32_t a, std::uint32_t b,
                               std::uint32_t c) {
  mesh_.triangles.push_back({a, b, c});
  mesh_.crossings.push_back(crossing);
}

// Two triangles (or one) without a vertex on the edge itself, if both separate the edge's ends.
bool DualSurface::add_flat_polygon(const Crossing& c, std::span<const std::uint32_t> ring,
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

void DualSurface::add_polygon(std::int32_t id) {
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
