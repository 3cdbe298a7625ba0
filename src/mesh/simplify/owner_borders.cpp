#include "mesh/simplify/owner_borders.h"

#include "core/process/parallel.h"
#include "mesh/simplify/apart_queue.h"
#include "mesh/simplify/cut_mesh.h"
#include "mesh/simplify/mesh_certifier.h"
#include "mesh/simplify/surface_owners.h"
#include "mesh/solid/self_intersection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <optional>
#include <utility>

namespace mrsim::detail {
namespace {

constexpr double kEndShare = 1e-3;     ///< of an edge: where the owner at its end is sampled
constexpr double kInward = 1e-4;       ///< mm: where the owner beside an edge is sampled
constexpr int kEdgeSamples = 4;        ///< parts of an edge at whose ends it is sampled
constexpr int kChordRounds = 4;        ///< of cutting edges, then at chords
constexpr double kSameNormal = 0.999;  ///< cosine: two triangles of one plane, as far as labels go
constexpr std::int32_t kManyOwners = kStockOwner - 1;  ///< of an edge, or not known
constexpr std::int32_t kNotAsked = kManyOwners - 1;    ///< less it, owners are marks of half edges

class BorderCutter {
 public:
  BorderCutter(const ExactField& field, const CellOctree& tree, const LabelledMesh& mesh,
               double tolerance, int threads)
      : field_(field),
        tree_(tree),
        owners_(field, tree),
        tolerance_(tolerance),
        threads_(threads),
        cut_(mesh, threads) {
    for (std::size_t k = 0; k < mesh.faces.size(); ++k)
      ids_.insert(face_key(mesh.faces[k]), static_cast<std::int32_t>(k));
  }

  LabelledMesh run(const LabelledMesh& before) {
    find_plane_triangles();
    for (int round = 0; round < kChordRounds && !edges_.empty(); ++round) {
      std::vector<std::uint32_t> seen;
      while (!edges_.empty()) {
        const auto some = edges_.take(cut_.mesh.triangles, cut_.mesh.vertices.size());
        seen.insert(seen.end(), some.begin(), some.end());
        const std::vector<Crossed> crossed = ask(some);
        for (std::size_t k = 0; k < some.size(); ++k) cut_crossed_edges(some[k], crossed[k]);
      }
      std::sort(seen.begin(), seen.end());
      seen.erase(std::unique(seen.begin(), seen.end()), seen.end());
      relabel(seen);
      chords_.assign(seen.begin(), seen.end());
      while (!chords_.empty()) {
        const std::uint32_t first = chords_.front();
        chords_.pop_front();
        cut_deep_chords(first);
      }
    }
    if (crosses_itself()) return before;
    return std::move(cut_.mesh);
  }

 private:
  enum class Plane : std::uint8_t { no, yes, cut };  ///< `cut`: more than one owner was seen in it

  // Triangles that lie on a plane of the part, as far as seven points show; those that more than
  // one owner shares are queued, those of one other owner get its label.
  void find_plane_triangles() {
    const std::size_t count = cut_.mesh.triangles.size();
    plane_.assign(count, Plane::no);
    std::vector<std::optional<FieldSample>> others(count);
    parallel_for(
        count, threads_, [&](std::size_t t) { look_at(static_cast<std::uint32_t>(t), others[t]); },
        64);
    for (std::uint32_t t = 0; t < count; ++t) {
      if (others[t]) cut_.mesh.labels[t] = label_of(*others[t]);
      if (plane_[t] == Plane::cut) edges_.push(t);
    }
  }

  void look_at(std::uint32_t t, std::optional<FieldSample>& other) {
    const FieldSample& own = cut_.mesh.faces[cut_.mesh.labels[t]];
    const CutMesh::Corners& x = cut_.mesh.triangles[t];
    const Vec3 m = cut_.middle(t);
    if (cut_.height(t) < 4 * kInward || !is_on_face(m, own) || !is_shared(x)) return;
    std::int32_t cell = tree_.locate(m);
    const std::optional<FieldSample> first = owners_.face_at(m, cell);
    if (!first) return;
    bool differs = false;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 &a = cut_.position(x[k]), &b = cut_.position(x[(k + 1) % 3]);
      for (const Vec3& p : {lerp(a, m, 2 * kEndShare), lerp(0.5 * (a + b), m, 2 * kEndShare)}) {
        if (!is_on_face(p, own)) return;
        const std::optional<FieldSample> s = owners_.face_at(p, cell);
        differs = differs || (s && s->owner != first->owner);
      }
    }
    plane_[t] = differs ? Plane::cut : Plane::yes;
    if (!differs && first->owner != own.owner) other = first;
  }
  bool is_on_face(const Vec3& p, const FieldSample& face) const {
    return std::abs(field_.patch_distance(p, face)) <= surface_band(p);
  }

  // More than one sweep can decide d in the cell of a corner.
  bool is_shared(const CutMesh::Corners& x) const {
    std::int32_t cell = 0;
    return std::any_of(x.begin(), x.end(), [&](std::uint32_t v) {
      cell = tree_.locate(cut_.position(v), cell);
      return tree_.candidates(cell).size() > 1;
    });
  }

  std::uint32_t label_of(const FieldSample& face) {
    LabelledMesh& mesh = cut_.mesh;
    const auto [id, is_new] =
        ids_.insert(face_key(face), static_cast<std::int32_t>(mesh.faces.size()));
    if (is_new) mesh.faces.push_back(face);
    return static_cast<std::uint32_t>(id);
  }
  std::optional<FieldSample> face_of(std::uint32_t t) const {
    std::int32_t cell = 0;
    return owners_.face_at(cut_.middle(t), cell);
  }
  // A chord over faces that join nearly smoothly may leave a piece over another one of them.
  void relabel_chord(std::uint32_t t) {
    if (const auto face = nearer_face(field_, tree_, cut_.mesh, t))
      cut_.mesh.labels[t] = label_of(*face);
  }
  void relabel(const std::vector<std::uint32_t>& triangles) {
    std::vector<std::optional<FieldSample>> faces(triangles.size());
    parallel_for(
        triangles.size(), threads_, [&](std::size_t k) { faces[k] = face_of(triangles[k]); }, 64);
    for (std::size_t k = 0; k < triangles.size(); ++k)
      if (faces[k]) cut_.mesh.labels[triangles[k]] = label_of(*faces[k]);
  }

  bool in_one_plane(std::uint32_t h) const {
    const std::uint32_t o = cut_.opposite(h);
    if (!is_half_edge(o) || plane_[o / 3] == Plane::no) return false;
    const Vec3 a = cut_.normal(h / 3), b = cut_.normal(o / 3);
    return dot(a, b) > kSameNormal * length(a) * length(b);
  }
  // Unit vector in the triangle's plane, from the edge to its apex.
  Vec3 inward(std::uint32_t h) const {
    const Vec3 &a = cut_.position(cut_.from(h)), &b = cut_.position(cut_.to(h)),
               &c = cut_.position(cut_.apex(h));
    const Vec3 u = b - a;
    return normalized(c - a - (dot(c - a, u) / dot(u, u)) * u);
  }

  // What one side of an edge shows: where a border crosses it, or which owner has all of it.
  struct EdgeSide {
    std::optional<Vec3> border;
    std::int32_t owner = kManyOwners;
  };

  // The edges of a triangle with these corners up to the first one that a border crosses, without
  // those that had been searched by then.
  struct Crossed {
    CutMesh::Corners corners{};
    std::array<std::optional<EdgeSide>, 3> edges;
  };

  // The edges of a triangle at which it may be cut: a cut at the longest one leaves the least thin
  // pieces, and the ends of those below four times the tolerance are near enough to any border.
  struct LongEdges {
    std::array<std::uint32_t, 3> edges{};
    std::uint32_t count = 0;
    const std::uint32_t* begin() const { return edges.data(); }
    const std::uint32_t* end() const { return edges.data() + count; }
  };
  LongEdges longest_first(std::uint32_t t) const {
    LongEdges found;
    if (cut_.height(t) < 4 * kInward) return found;
    std::array<double, 3> size{};
    for (std::uint32_t k = 0; k < 3; ++k) {
      size[k] = distance(cut_.position(cut_.from(3 * t + k)), cut_.position(cut_.to(3 * t + k)));
      if (tolerance_ / size[k] <= 0.25) found.edges[found.count++] = k;
    }
    std::stable_sort(found.edges.begin(), found.edges.begin() + found.count,
                     [&](std::uint32_t a, std::uint32_t b) { return size[a] > size[b]; });
    return found;
  }

  // Most of the time goes into this, so it is found for many triangles at once. One that is changed
  // before its turn comes is searched again.
  std::vector<Crossed> ask(const std::vector<std::uint32_t>& triangles) const {
    std::vector<Crossed> found(triangles.size());
    parallel_for(
        found.size(), threads_,
        [&](std::size_t i) {
          const std::uint32_t t = triangles[i];
          Crossed& crossed = found[i];
          crossed.corners = cut_.mesh.triangles[t];
          for (const std::uint32_t k : longest_first(t)) {
            if (was_asked(3 * t + k)) continue;
            crossed.edges[k] = look_along(3 * t + k);
            if (crossed.edges[k]->border) return;
          }
        },
        8);
    return found;
  }
  bool was_asked(std::uint32_t h) const { return cut_.marks[h] != 0; }

  void cut_crossed_edges(std::uint32_t t, const Crossed& crossed) {
    const bool is_same = cut_.mesh.triangles[t] == crossed.corners;
    for (const std::uint32_t k : longest_first(t)) {
      const std::uint32_t h = 3 * t + k;
      if (was_asked(h)) continue;
      const bool is_known = is_same && crossed.edges[k];
      const EdgeSide side = is_known ? *crossed.edges[k] : look_along(h);
      cut_.marks[h] = side.owner - kNotAsked;
      if (!side.border) continue;
      const std::uint32_t o = cut_.opposite(h);
      if (!cut_.cut_edge(h, snap(*side.border))) continue;
      for (const std::uint32_t old : {t, o / 3}) plane_.push_back(plane_[old]);
      const auto last = static_cast<std::uint32_t>(plane_.size() - 1);
      for (const std::uint32_t part : {o / 3, last})
        if (plane_[part] == Plane::no) relabel_chord(part);
      for (const std::uint32_t part : with_flips({t, o / 3, last - 1, last})) {
        plane_[part] = Plane::cut;
        edges_.push(part);
      }
      return;
    }
  }

  // Flips edges of the triangles that a cut has left, then those of the triangles that this has
  // changed: a long triangle would cross many borders, and be cut at each. Returns all of these
  // triangles that lie on a plane, once each.
  std::vector<std::uint32_t> with_flips(std::vector<std::uint32_t> parts) {
    std::erase_if(parts, [&](std::uint32_t t) { return plane_[t] == Plane::no; });
    std::vector<std::uint32_t> open = parts;
    while (!open.empty()) {
      const std::uint32_t t = open.back();
      open.pop_back();
      for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
        if (!in_one_plane(h)) continue;
        const std::uint32_t other = cut_.opposite(h) / 3;
        if (!cut_.flip_edge(h)) continue;
        for (std::vector<std::uint32_t>* list : {&open, &parts}) {
          list->push_back(t);
          list->push_back(other);
        }
        break;
      }
    }
    std::sort(parts.begin(), parts.end());
    parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
    return parts;
  }

  // The owner of all of the edge as the triangle on its other side shows it, where both lie in one
  // plane.
  std::int32_t owner_across(std::uint32_t h) const {
    const std::uint32_t o = cut_.opposite(h);
    const std::int32_t owner = is_half_edge(o) ? cut_.marks[o] + kNotAsked : kNotAsked;
    return owner > kManyOwners && in_one_plane(h) ? owner : kManyOwners;
  }

  // Finds where the owner on the triangle's side of an edge changes for the first time, well off
  // the ends. Where the other side has one owner, this side has it, too, or a border runs along the
  // edge: the middle tells.
  EdgeSide look_along(std::uint32_t h) const {
    const Vec3 &a = cut_.position(cut_.from(h)), &b = cut_.position(cut_.to(h));
    const double end =
        std::max(kEndShare, tolerance_ / distance(a, b));  // nearer, the edge's end will do
    const Vec3 aside = kInward * inward(h);
    std::int32_t cell = tree_.locate(a);
    const auto point = [&](double s) { return lerp(a, b, s) + aside; };
    if (const std::int32_t across = owner_across(h); across != kManyOwners) {
      const std::optional<FieldSample> s = owners_.face_at(point(0.5), cell);
      if (s && s->owner == across) return {{}, across};
    }
    bool is_one = true;
    std::optional<SurfaceOwners::Place> from;
    for (int k = 0; k <= kEdgeSamples; ++k) {
      const Vec3 p = point(std::clamp(static_cast<double>(k) / kEdgeSamples, end, 1 - end));
      const std::optional<FieldSample> s = owners_.face_at(p, cell);
      is_one = is_one && s && (!from || s->owner == from->owner);
      if (!s) continue;
      if (from && s->owner != from->owner &&
          !(owners_.reaches(from->owner, p) && owners_.reaches(s->owner, from->p)))
        return {owners_.change(*from, {p, s->owner}, cell, -aside)};
      from = {p, s->owner};
    }
    return {{}, is_one ? from->owner : kManyOwners};
  }

  // Chords of a border that bends leave strips of the one owner in triangles of the other one.
  void cut_deep_chords(std::uint32_t t) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t h = 3 * t + k;
      if (!in_one_plane(h)) continue;
      const std::uint32_t other = cut_.opposite(h) / 3;
      if (owner_of(t) == owner_of(other)) continue;
      const std::optional<Vec3> at = border_beside(h);
      if (!at || !cut_.cut_triangle(t, snap(*at))) continue;
      plane_.insert(plane_.end(), 2, Plane::cut);
      const auto last = static_cast<std::uint32_t>(plane_.size() - 1);
      for (const std::uint32_t part : with_flips({t, last - 1, last})) {
        plane_[part] = Plane::cut;
        relabel({part});
        chords_.push_back(part);
        edges_.push(part);
      }
      return;
    }
  }
  std::int32_t owner_of(std::uint32_t t) const {
    return cut_.mesh.faces[cut_.mesh.labels[t]].owner;
  }

  // Between the edge's middle and the triangle's, where the border is farther off than the
  // tolerance.
  std::optional<Vec3> border_beside(std::uint32_t h) const {
    const std::uint32_t t = h / 3;
    const Vec3 m = 0.5 * (cut_.position(cut_.from(h)) + cut_.position(cut_.to(h))),
               c = cut_.middle(t);
    const Vec3 aside = inward(h);
    const double depth = dot(c - m, aside);
    if (depth < 2 * tolerance_) return {};
    std::int32_t cell = tree_.locate(m);
    const Vec3 begin = lerp(m, c, tolerance_ / depth);
    const std::optional<FieldSample> near = owners_.face_at(begin, cell);
    if (!near || near->owner == owner_of(t)) return {};
    if (owners_.reaches(owner_of(t), begin) && owners_.reaches(near->owner, c)) return {};
    return owners_.change({begin, near->owner}, {c, owner_of(t)}, cell, {});
  }

  bool crosses_itself() const {
    const LabelledMesh& mesh = cut_.mesh;
    if (std::none_of(cut_.moved.begin(), cut_.moved.end(), [](char c) { return c != 0; }))
      return false;
    return !self_intersections(mesh.vertices, mesh.triangles, threads_, cut_.moved).empty();
  }

  const ExactField& field_;
  const CellOctree& tree_;
  SurfaceOwners owners_;
  double tolerance_;
  int threads_;
  CutMesh cut_;
  FlatMap ids_;                       ///< of faces, in the mesh
  std::vector<Plane> plane_;          ///< by triangle
  ApartQueue edges_;                  ///< triangles whose edges to look at
  std::deque<std::uint32_t> chords_;  ///< and whose chords
};

}  // namespace

LabelledMesh cut_owner_borders(const ExactField& field, const CellOctree& tree,
                               const LabelledMesh& mesh, double tolerance, int threads) {
  return BorderCutter(field, tree, mesh, tolerance, threads).run(mesh);
}

}  // namespace mrsim::detail
