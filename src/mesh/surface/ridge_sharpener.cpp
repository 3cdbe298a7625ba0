#include "mesh/surface/ridge_sharpener.h"

#include "core/process/parallel.h"
#include "mesh/points/vertex.h"

#include <algorithm>
#include <iterator>

namespace mrsim::detail {

// Where the vertex of each loop goes; count = 0: it stays.
std::vector<SurfacePoint> RidgeSharpener::find_tips() const {
  std::vector<SurfacePoint> tips = outside_;
  parallel_for(
      tips.size(), options_.threads,
      [&](std::size_t k) {
        const Loop& loop = loops_[k];
        if (tips[k].count > 0 || loop.point.count >= 3 || !is_complete(loop.cell)) return;
        static thread_local std::vector<FieldSample> faces;
        faces.clear();
        for (const std::int32_t c : crossings_of(loop))
          faces.push_back(crossings_[static_cast<std::size_t>(c)].at);
        tips[k] = corner_near(probe(loop.cell), cells_.box(loop.cell), loop.point.position, faces);
      },
      64);
  return tips;
}

std::size_t RidgeSharpener::segment_vertices() const {
  return static_cast<std::size_t>(std::count_if(segments_.begin(), segments_.end(),
                                                [](const Segment& s) { return s.vertex >= 0; }));
}

// The vertices that go to a ridge, and those that lie on one and share a triangle with them.
std::vector<RidgeVertex> RidgeSharpener::find_ridge(const CellOctree& tree) const {
  std::vector<RidgeVertex> ridge;
  std::vector<char> is_near(mesh_.vertices.size(), 0);
  const auto add_if_moved = [&](std::size_t v, SurfacePoint to) {
    if (to.count == 0) return;
    // Other sweeps may matter there than in the cell that it was found from.
    const std::int32_t cell = tree.locate(to.position);
    if (tree.node(cell).region != ExactField::Region::mixed ||
        !probe(cell).is_on_surface(to.position))
      return;
    keep_apart(probe(cell), mesh_.vertices[v], to);
    ridge.push_back({static_cast<std::uint32_t>(v), to, true});
    is_near[v] = 1;
  };
  const std::vector<SurfacePoint> tips = find_tips();
  for (std::size_t k = 0; k < tips.size(); ++k) add_if_moved(k, tips[k]);
  const auto vertex_of = [&](const Crease& c) { return at(segments_, c.segment).vertex; };
  for (const Crease& c : creases_)
    if (vertex_of(c) >= 0) add_if_moved(static_cast<std::size_t>(vertex_of(c)), c.outside);
  if (ridge.empty()) return ridge;
  const std::vector<char> moved = is_near;
  const std::size_t first_apex = loops_.size() + segment_vertices();
  for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
    const auto& x = mesh_.triangles[t];
    if (!(moved[x[0]] || moved[x[1]] || moved[x[2]])) continue;
    for (const std::uint32_t v : x) {
      if (v >= first_apex && !is_near[v]) {
        SurfacePoint apex{mesh_.vertices[v]};
        apex.faces[0] = at(crossings_, mesh_.crossings[t]).at, apex.count = 1;
        ridge.push_back({v, apex, false});
      }
      is_near[v] = 1;
    }
  }
  const auto add_if_near = [&](std::size_t v, const SurfacePoint& there) {
    if (there.count >= 1 && is_near[v] && !moved[v])
      ridge.push_back({static_cast<std::uint32_t>(v), there, false});
  };
  for (std::size_t k = 0; k < loops_.size(); ++k) add_if_near(k, loops_[k].point);
  for (const Segment& s : segments_)
    if (s.vertex >= 0) {
      SurfacePoint there = point_on(s);
      there.position = mesh_.vertices[static_cast<std::size_t>(s.vertex)];
      add_if_near(static_cast<std::size_t>(s.vertex), there);
    }
  return ridge;
}

// The point of a segment's vertex; count = 0 where that is not known.
SurfacePoint RidgeSharpener::point_on(const Segment& s) const {
  if (s.crease >= 0) return at(creases_, s.crease).point;
  const FieldSample &from = at(crossings_, s.from).at, &to = at(crossings_, s.to).at;
  SurfacePoint point;
  if (same_face(from, to)) point.faces[0] = from, point.count = 1;
  return point;
}

// Where vertices were joined, what was drawn about an edge on one side of a ridge may lie on the
// other one.
void RidgeSharpener::label_moved(std::span<const std::uint32_t> triangles,
                                 const RidgeStrip& strip) {
  std::vector<std::int32_t> segment_of;
  for (std::size_t k = 0; k < segments_.size(); ++k)
    if (segments_[k].vertex >= 0) segment_of.push_back(static_cast<std::int32_t>(k));
  for (const std::uint32_t t : triangles) {
    const FieldSample& label = at(crossings_, mesh_.crossings[t]).at;
    SurfacePoint points[3];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t v = mesh_.triangles[t][k], s = v - loops_.size();
      if (const SurfacePoint* there = strip.find(mesh_.triangles[t][k]))
        points[k] = *there;
      else if (v < loops_.size())
        points[k] = loops_[v].point;
      else if (s < segment_of.size())
        points[k] = point_on(at(segments_, segment_of[s]));
      else
        points[k].faces[0] = label, points[k].count = 1;
    }
    const auto holds = [&](const FieldSample& face) {
      return std::all_of(std::begin(points), std::end(points),
                         [&](const SurfacePoint& p) { return has_face(p, face); });
    };
    if (holds(label)) continue;
    const std::span<const FieldSample> faces(points[0].faces, points[0].count);
    if (const auto face = std::find_if(faces.begin(), faces.end(), holds); face != faces.end())
      mesh_.moved.emplace_back(t, *face);
  }
}

void RidgeSharpener::sharpen(const CellOctree& tree) {
  std::vector<RidgeVertex> ridge = find_ridge(tree);
  if (ridge.empty()) return;
  const auto normal_of = [this](std::uint32_t t) {
    return at(crossings_, mesh_.crossings[t]).normal;
  };
  RidgeStrip strip(mesh_.vertices, mesh_.triangles, std::move(ridge), normal_of, options_.threads);
  strip.join();
  strip.put_back_crossed();
  const RidgeStrip::Left left = strip.finish();
  for (std::size_t k = 0; k < left.triangles.size(); ++k)
    mesh_.crossings[k] = mesh_.crossings[left.triangles[k]];
  mesh_.crossings.resize(left.triangles.size());
  label_moved(left.near, strip);
}

}  // namespace mrsim::detail
