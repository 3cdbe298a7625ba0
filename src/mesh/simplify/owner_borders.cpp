#include "mesh/simplify/owner_borders.h"

#include "core/process/parallel.h"
#include "mesh/simplify/apart_queue.h"
#include "mesh/simplify/cut_mesh.h"
#include "mesh/simplify/mesh_certifier.h"
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
constexpr int kHalvings = 24;          ///< of a part, to its border
constexpr double kSameNormal = 0.999;  ///< cosine: two triangles of one plane, as far as labels go

class BorderCutter {
 public:
  BorderCutter(const ExactField& field, const CellOctree& tree, const LabelledMesh& mesh,
               double tolerance, int threads)
      : field_(field), tree_(tree), tolerance_(tolerance), threads_(threads), cut_(mesh, threads) {
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

  // The sample that names the face at p; nothing if the surface does not pass p.
  std::optional<FieldSample> face_at(const Vec3& p, std::int32_t& cell) const {
    cell = tree_.locate(p, cell);
    const FieldSample s = tree_.sample_at(p, cell);
    if (std::abs(s.distance) > surface_band(p)) return {};
    return s;
  }

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
    const std::optional<FieldSample> first = face_at(m, cell);
    if (!first) return;
    bool differs = false;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 &a = cut_.position(x[k]), &b = cut_.position(x[(k + 1) % 3]);
      for (const Vec3& p : {lerp(a, m, 2 * kEndShare), lerp(0.5 * (a + b), m, 2 * kEndShare)}) {
        if (!is_on_face(p, own)) return;
        const std::optional<FieldSample> s = face_at(p, cell);
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
    return face_at(cut_.middle(t), cell);
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

  // Where borders cross the edges of a triangle with these corners: up to the first one, of the
  // edges that had not been searched by then.
  struct Crossed {
    CutMesh::Corners corners{};
    std::array<bool, 3> is_known{};
    std::array<std::optional<Vec3>, 3> at;
  };

  // The edges of a triangle: a cut at the longest one leaves the least thin pieces.
  std::array<std::uint32_t, 3> longest_first(std::uint32_t t) const {
    std::array<std::uint32_t, 3> order{0, 1, 2};
    std::array<double, 3> size{};
    for (const std::uint32_t k : order)
      size[k] = distance(cut_.position(cut_.from(3 * t + k)), cut_.position(cut_.to(3 * t + k)));
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return size[a] > size[b]; });
    return order;
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
            if (asked_.find(edge_key(3 * t + k)) >= 0) continue;
            crossed.is_known[k] = true;
            crossed.at[k] = border_on(3 * t + k);
            if (crossed.at[k]) return;
          }
        },
        8);
    return found;
  }
  std::uint64_t edge_key(std::uint32_t h) const {
    return static_cast<std::uint64_t>(cut_.from(h)) << 32 | cut_.to(h);
  }

  void cut_crossed_edges(std::uint32_t t, const Crossed& crossed) {
    const bool is_same = cut_.mesh.triangles[t] == crossed.corners;
    for (const std::uint32_t k : longest_first(t)) {
      const std::uint32_t h = 3 * t + k;
      if (!asked_.insert(edge_key(h), 0).second) continue;
      const bool known = is_same && crossed.is_known[k];
      const std::optional<Vec3> at = known ? crossed.at[k] : border_on(h);
      if (!at) continue;
      const std::uint32_t o = cut_.opposite(h);
      if (!cut_.cut_edge(h, snap(*at))) continue;
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

  // Where the owner on the triangle's side of an edge changes for the first time, well off the
  // ends.
  std::optional<Vec3> border_on(std::uint32_t h) const {
    const Vec3 &a = cut_.position(cut_.from(h)), &b = cut_.position(cut_.to(h));
    const double end =
        std::max(kEndShare, tolerance_ / distance(a, b));  // nearer, the edge's end will do
    if (end > 0.25 || cut_.height(h / 3) < 4 * kInward) return {};
    const Vec3 aside = kInward * inward(h);
    std::int32_t cell = tree_.locate(a);
    const auto owner = [&](double s) { return face_at(lerp(a, b, s) + aside, cell); };
    double from = 0;
    std::optional<FieldSample> first;
    for (int k = 0; k <= kEdgeSamples; ++k) {
      const double to = std::clamp(static_cast<double>(k) / kEdgeSamples, end, 1 - end);
      const std::optional<FieldSample> last = owner(to);
      if (first && last && first->owner != last->owner &&
          !(reaches(first->owner, lerp(a, b, to) + aside) &&
            reaches(last->owner, lerp(a, b, from) + aside)))
        return change([&](double s) { return lerp(a, b, s) + aside; }, {from, first->owner},
                      {to, last->owner}, cell, -aside);
      if (last) {
        first = last;
        from = to;
      }
    }
    return {};
  }

  // Whether this owner's face passes here, too. If the faces of two owners pass both of two places,
  // two passes have cut one wall and rounding picks the owner: there is no border between the
  // places.
  bool reaches(std::int32_t owner, const Vec3& p) const {
    if (owner == kStockOwner) return false;
    const std::uint32_t only = field_.candidate(owner);
    return std::abs(field_.sample(p, {&only, 1}).distance) <= surface_band(p);
  }

  struct Owned {
    double at = 0;
    std::int32_t owner = 0;
  };

  // The point between two of a line at which the owner changes from the first one's, moved by
  // `shift`; nothing where that is off the surface.
  template <class PointAt>
  std::optional<Vec3> change(const PointAt& point_at, Owned from, Owned to, std::int32_t cell,
                             const Vec3& shift) const {
    const auto owner = [&](double s) { return face_at(point_at(s), cell); };
    Owned first = from, last = to;
    const bool is_seen = halve_between(point_at, first, last) &&
                         is_owner(owner(first.at), from.owner) &&
                         is_owner(owner(last.at), to.owner);
    if (is_seen) from = first, to = last;
    for (int i = 0; !is_seen && i < kHalvings; ++i) {  // a third owner lies between
      const double middle = 0.5 * (from.at + to.at);
      const std::optional<FieldSample> s = owner(middle);
      if (!s) return {};
      (s->owner == from.owner ? from : to).at = middle;
    }
    const Vec3 p = point_at(0.5 * (from.at + to.at)) + shift;
    return face_at(p, cell) ? std::optional<Vec3>(p) : std::nullopt;
  }
  static bool is_owner(const std::optional<FieldSample>& face, std::int32_t owner) {
    return face && face->owner == owner;
  }

  // Bisects between the two, by these two sweeps alone. False where neither is on the surface
  // at a point of it.
  template <class PointAt>
  bool halve_between(const PointAt& point_at, Owned& from, Owned& to) const {
    std::uint32_t both[2];
    std::size_t count = 0;
    for (const std::int32_t owner : {from.owner, to.owner})
      if (owner != kStockOwner) both[count++] = field_.candidate(owner);
    if (count == 2 && both[1] < both[0]) std::swap(both[0], both[1]);
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = 0.5 * (from.at + to.at);
      const Vec3 p = point_at(middle);
      const FieldSample s = field_.sample(p, {both, count});
      if (std::abs(s.distance) > surface_band(p)) return false;
      (s.owner == from.owner ? from : to).at = middle;
    }
    return true;
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
    const auto point_at = [&](double s) { return lerp(m, c, s); };
    const double begin = tolerance_ / depth;
    const std::optional<FieldSample> near = face_at(point_at(begin), cell);
    if (!near || near->owner == owner_of(t)) return {};
    if (reaches(owner_of(t), point_at(begin)) && reaches(near->owner, c)) return {};
    return change(point_at, {begin, near->owner}, {1, owner_of(t)}, cell, {});
  }

  bool crosses_itself() const {
    const LabelledMesh& mesh = cut_.mesh;
    if (std::none_of(cut_.moved.begin(), cut_.moved.end(), [](char c) { return c != 0; }))
      return false;
    return !self_intersections(mesh.vertices, mesh.triangles, threads_, cut_.moved).empty();
  }

  const ExactField& field_;
  const CellOctree& tree_;
  double tolerance_;
  int threads_;
  CutMesh cut_;
  FlatMap ids_;                       ///< of faces, in the mesh
  FlatMap asked_;                     ///< edges by their vertices, as a triangle has them
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
