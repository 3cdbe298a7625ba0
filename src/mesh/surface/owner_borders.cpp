#include "mesh/surface/owner_borders.h"

#include "core/parallel.h"
#include "mesh/solid/exact_predicates.h"
#include "mesh/solid/half_edges.h"
#include "mesh/solid/self_intersection.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>

namespace mrsim::detail {
namespace {

using Corners = std::array<std::uint32_t, 3>;

constexpr double kLeastHeight = 2e-5;  ///< mm: of a new triangle
constexpr double kGoodHeight = 2e-4;   ///< mm: asked of it where it takes the place of a higher one
constexpr double kEndShare = 1e-3;     ///< of an edge: where the owner at its end is asked
constexpr double kInward = 1e-4;       ///< mm: where the owner beside an edge is asked
constexpr int kEdgeSamples = 4;        ///< parts of an edge at whose ends it is asked
constexpr int kRounds = 4;             ///< of cutting edges, then at chords
constexpr int kHalvings = 24;          ///< of a part, to its border
constexpr double kSameNormal = 0.999;  ///< cosine: two triangles of one plane, as far as labels go

// The mesh while it is cut, with the neighbours of its triangles.
class CutMesh {
 public:
  CutMesh(const LabelledMesh& from, int threads)
      : mesh(from),
        opposites(find_opposites(from.triangles, from.vertices.size(), threads)),
        changed(from.triangles.size(), 0) {}

  std::uint32_t from(std::uint32_t h) const { return mesh.triangles[h / 3][h % 3]; }
  std::uint32_t to(std::uint32_t h) const { return from(next_half_edge(h)); }
  std::uint32_t apex(std::uint32_t h) const { return from(previous_half_edge(h)); }
  const Vec3& place(std::uint32_t v) const { return mesh.vertices[v]; }
  Vec3 normal(std::uint32_t t) const {
    const Corners& x = mesh.triangles[t];
    return cross(place(x[1]) - place(x[0]), place(x[2]) - place(x[0]));
  }
  Vec3 middle(std::uint32_t t) const {
    const Corners& x = mesh.triangles[t];
    return (1.0 / 3) * (place(x[0]) + place(x[1]) + place(x[2]));
  }
  /// Twice the area by the longest side.
  double height(std::uint32_t t) const {
    const Corners& x = mesh.triangles[t];
    return height_of(place(x[0]), place(x[1]), place(x[2]));
  }
  static double height_of(const Vec3& a, const Vec3& b, const Vec3& c) {
    const double longest = std::max({distance(a, b), distance(b, c), distance(c, a)});
    return length(cross(b - a, c - a)) / std::max(longest, 1e-30);
  }

  /// Cuts the edge and both of its triangles in two; false where a piece would be too thin. The new
  /// triangles are the last two.
  bool cut_edge(std::uint32_t h, const Vec3& at) {
    const std::uint32_t o = opposites[h];
    if (!is_half_edge(o)) return false;
    const std::uint32_t a = from(h), b = to(h), c = apex(h), d = apex(o);
    const std::uint32_t t = h / 3, u = o / 3;
    if (!may_be(a, at, c, t) || !may_be(at, b, c, t) || !may_be(b, at, d, u) ||
        !may_be(at, a, d, u))
      return false;
    const std::uint32_t bc = opposites[next_half_edge(h)], ca = opposites[previous_half_edge(h)],
                        ad = opposites[next_half_edge(o)], db = opposites[previous_half_edge(o)];
    const bool bends = !is_level({a, b, c, d}, at);
    const std::uint32_t v = add_vertex(at), t2 = add_copy(t, bends), u2 = add_copy(u, bends);
    mesh.triangles[t] = {a, v, c};
    mesh.triangles[t2] = {v, b, c};
    mesh.triangles[u] = {b, v, d};
    mesh.triangles[u2] = {v, a, d};
    join(3 * t, 3 * u2);
    join(3 * t + 1, 3 * t2 + 2);
    join(3 * t + 2, ca);
    join(3 * t2, 3 * u);
    join(3 * t2 + 1, bc);
    join(3 * u + 1, 3 * u2 + 2);
    join(3 * u + 2, db);
    join(3 * u2 + 1, ad);
    return true;
  }

  /// Cuts a triangle in three about a point in it; the new triangles are the last two.
  bool cut_triangle(std::uint32_t t, const Vec3& at) {
    const Corners x = mesh.triangles[t];
    for (int k = 0; k < 3; ++k)
      if (!may_be(x[static_cast<std::size_t>(k)], x[static_cast<std::size_t>((k + 1) % 3)], at, t))
        return false;
    const std::uint32_t bc = opposites[3 * t + 1], ca = opposites[3 * t + 2];
    const bool bends = !is_level({x[0], x[1], x[2]}, at);
    const std::uint32_t v = add_vertex(at), t2 = add_copy(t, bends), t3 = add_copy(t, bends);
    mesh.triangles[t] = {x[0], x[1], v};
    mesh.triangles[t2] = {x[1], x[2], v};
    mesh.triangles[t3] = {x[2], x[0], v};
    join(3 * t2, bc);
    join(3 * t3, ca);
    join(3 * t + 1, 3 * t2 + 2);
    join(3 * t2 + 1, 3 * t3 + 2);
    join(3 * t3 + 1, 3 * t + 2);
    return true;
  }

  LabelledMesh mesh;
  std::vector<std::uint32_t> opposites;
  std::vector<char> changed;  ///< by triangle: may meet others now

 private:
  // Corners of the mesh, or the new point in one of their places.
  bool may_be(const Vec3& a, const Vec3& b, const Vec3& c, std::uint32_t t) const {
    const double least = std::max(kLeastHeight, std::min(kGoodHeight, 0.25 * height(t)));
    return height_of(a, b, c) > least && dot(cross(b - a, c - a), normal(t)) > 0;
  }
  bool may_be(std::uint32_t a, const Vec3& b, std::uint32_t c, std::uint32_t t) const {
    return may_be(place(a), b, place(c), t);
  }
  bool may_be(const Vec3& a, std::uint32_t b, std::uint32_t c, std::uint32_t t) const {
    return may_be(a, place(b), place(c), t);
  }
  bool may_be(std::uint32_t a, std::uint32_t b, const Vec3& c, std::uint32_t t) const {
    return may_be(place(a), place(b), c, t);
  }
  std::uint32_t add_vertex(const Vec3& p) {
    mesh.vertices.push_back(p);
    return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
  }
  // In a plane on which a coordinate is the same, triangles that face one way stay apart; where a
  // rounded point leaves the edge or triangle that it cuts, others may be that near.
  bool is_level(std::initializer_list<std::uint32_t> corners, const Vec3& at) const {
    for (int axis = 0; axis < 3; ++axis)
      if (std::all_of(corners.begin(), corners.end(), [&](std::uint32_t v) {
            return component(place(v), axis) == component(at, axis);
          }))
        return true;
    return false;
  }
  std::uint32_t add_copy(std::uint32_t t, bool bends) {
    if (bends) changed[t] = 1;
    mesh.triangles.push_back(mesh.triangles[t]);
    mesh.labels.push_back(mesh.labels[t]);
    changed.push_back(changed[t]);
    opposites.insert(opposites.end(), 3, kOpenEdge);
    return static_cast<std::uint32_t>(mesh.triangles.size() - 1);
  }
  void join(std::uint32_t h, std::uint32_t o) {
    opposites[h] = o;
    if (is_half_edge(o)) opposites[o] = h;
  }
};

class BorderCutter {
 public:
  BorderCutter(const ExactField& field, const CellOctree& tree, const LabelledMesh& mesh,
               double tolerance, int threads)
      : field_(field), tree_(tree), tolerance_(tolerance), threads_(threads), cut_(mesh, threads) {
    for (std::size_t k = 0; k < mesh.faces.size(); ++k)
      ids_.insert(key_of(mesh.faces[k]), static_cast<std::int32_t>(k));
  }

  LabelledMesh run(const LabelledMesh& before) {
    find_plane_triangles();
    for (int round = 0; round < kRounds && !edges_.empty(); ++round) {
      std::vector<std::uint32_t> seen;
      while (!edges_.empty()) {
        seen.push_back(edges_.front());
        cut_crossed_edges(take(edges_));
      }
      std::sort(seen.begin(), seen.end());
      seen.erase(std::unique(seen.begin(), seen.end()), seen.end());
      for (const std::uint32_t t : seen) relabel(t);
      chords_.assign(seen.begin(), seen.end());
      while (!chords_.empty()) cut_deep_chords(take(chords_));
    }
    if (crosses_itself()) return before;
    return std::move(cut_.mesh);
  }

 private:
  enum class Plane : std::uint8_t { no, yes, cut };  ///< `cut`: more than one owner was seen in it

  static std::uint64_t key_of(const FieldSample& face) {
    return static_cast<std::uint64_t>(face.owner - kStockOwner) << 32 |
           static_cast<std::uint32_t>(face.patch);
  }
  static std::uint32_t take(std::deque<std::uint32_t>& queue) {
    const std::uint32_t first = queue.front();
    queue.pop_front();
    return first;
  }

  // Whose face it is at a point of the surface; nothing where that is elsewhere.
  std::optional<FieldSample> face_at(const Vec3& p, std::int32_t& cell) const {
    cell = tree_.locate(p, cell);
    const FieldSample s = field_.sample(p, tree_.candidates(cell));
    if (std::abs(s.distance) > surface_band(p)) return {};
    return s;
  }
  // mm: what rounding may take a point of a plane off it.
  static double surface_band(const Vec3& p) {
    return kSurfaceBand + coordinate_step(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}));
  }

  // Triangles that lie on a plane of the part, as far as seven points tell; those that more than
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
      if (plane_[t] == Plane::cut) edges_.push_back(t);
    }
  }

  void look_at(std::uint32_t t, std::optional<FieldSample>& other) {
    const FieldSample& own = cut_.mesh.faces[cut_.mesh.labels[t]];
    const Corners& x = cut_.mesh.triangles[t];
    const Vec3 m = cut_.middle(t);
    if (cut_.height(t) < 4 * kInward || !is_on_face(m, own) || !is_shared(x)) return;
    std::int32_t cell = tree_.locate(m);
    const std::optional<FieldSample> first = face_at(m, cell);
    if (!first) return;
    bool differs = false;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 &a = cut_.place(x[k]), &b = cut_.place(x[(k + 1) % 3]);
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
  bool is_shared(const Corners& x) const {
    std::int32_t cell = 0;
    return std::any_of(x.begin(), x.end(), [&](std::uint32_t v) {
      cell = tree_.locate(cut_.place(v), cell);
      return tree_.candidates(cell).size() > 1;
    });
  }

  std::uint32_t label_of(const FieldSample& face) {
    LabelledMesh& mesh = cut_.mesh;
    const auto [id, is_new] =
        ids_.insert(key_of(face), static_cast<std::int32_t>(mesh.faces.size()));
    if (is_new) mesh.faces.push_back(face);
    return static_cast<std::uint32_t>(id);
  }
  void relabel(std::uint32_t t) {
    std::int32_t cell = 0;
    if (const auto face = face_at(cut_.middle(t), cell)) cut_.mesh.labels[t] = label_of(*face);
  }

  bool in_one_plane(std::uint32_t h) const {
    const std::uint32_t o = cut_.opposites[h];
    if (!is_half_edge(o) || plane_[o / 3] == Plane::no) return false;
    const Vec3 a = cut_.normal(h / 3), b = cut_.normal(o / 3);
    return dot(a, b) > kSameNormal * length(a) * length(b);
  }
  // Unit vector in the triangle's plane, from the edge to its apex.
  Vec3 inward(std::uint32_t h) const {
    const Vec3 &a = cut_.place(cut_.from(h)), &b = cut_.place(cut_.to(h)),
               &c = cut_.place(cut_.apex(h));
    const Vec3 u = b - a;
    return normalized(c - a - (dot(c - a, u) / dot(u, u)) * u);
  }

  void cut_crossed_edges(std::uint32_t t) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t h = 3 * t + k, u = cut_.from(h), v = cut_.to(h);
      if (!asked_.insert(static_cast<std::uint64_t>(u) << 32 | v, 0).second) continue;
      const std::optional<Vec3> at = border_on(h);
      if (!at) continue;
      const std::uint32_t o = cut_.opposites[h];
      if (!cut_.cut_edge(h, snap(*at))) continue;
      grow(t, o / 3);
      return;
    }
  }
  // After a cut of two triangles in two each.
  void grow(std::uint32_t t, std::uint32_t u) {
    for (const std::uint32_t old : {t, u}) {
      plane_.push_back(plane_[old] == Plane::no ? Plane::no : Plane::cut);
      if (plane_[old] == Plane::no) continue;
      plane_[old] = Plane::cut;
      edges_.push_back(old);
      edges_.push_back(static_cast<std::uint32_t>(plane_.size() - 1));
    }
  }

  // Where the owner on the triangle's side of an edge changes for the first time, well off the
  // ends.
  std::optional<Vec3> border_on(std::uint32_t h) const {
    const Vec3 &a = cut_.place(cut_.from(h)), &b = cut_.place(cut_.to(h));
    const double end = std::max(kEndShare, tolerance_ / distance(a, b));  // that near, ends will do
    if (end > 0.25) return {};
    const double height = cut_.height(h / 3);
    if (height < 4 * kInward) return {};
    const Vec3 aside = kInward * inward(h);
    std::int32_t cell = tree_.locate(a);
    const auto owner = [&](double s) { return face_at(lerp(a, b, s) + aside, cell); };
    double from = 0;
    std::optional<FieldSample> first;
    for (int k = 0; k <= kEdgeSamples; ++k) {
      const double to = std::clamp(static_cast<double>(k) / kEdgeSamples, end, 1 - end);
      const std::optional<FieldSample> last = owner(to);
      if (first && last && first->owner != last->owner)
        return first_change(owner, first->owner, from, to, [&](double s) { return lerp(a, b, s); });
      if (last) {
        first = last;
        from = to;
      }
    }
    return {};
  }

  // The point between two parameters at which the owner changes from the first one's.
  template <class FaceAt, class PlaceAt>
  std::optional<Vec3> first_change(const FaceAt& face, std::int32_t first, double from, double to,
                                   const PlaceAt& place) const {
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = 0.5 * (from + to);
      const std::optional<FieldSample> s = face(middle);
      if (!s) return {};
      (s->owner == first ? from : to) = middle;
    }
    const Vec3 p = place(0.5 * (from + to));
    std::int32_t cell = tree_.locate(p);
    return face_at(p, cell) ? std::optional<Vec3>(p) : std::nullopt;
  }

  // Chords of a border that bends leave strips of the one owner in triangles of the other one.
  void cut_deep_chords(std::uint32_t t) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t h = 3 * t + k;
      if (!in_one_plane(h)) continue;
      const std::uint32_t other = cut_.opposites[h] / 3;
      if (owner_of(t) == owner_of(other)) continue;
      const std::optional<Vec3> at = border_beside(h);
      if (!at || !cut_.cut_triangle(t, snap(*at))) continue;
      plane_.insert(plane_.end(), 2, Plane::cut);
      const auto last = static_cast<std::uint32_t>(plane_.size() - 1);
      for (const std::uint32_t part : {t, last - 1, last}) {
        relabel(part);
        chords_.push_back(part);
        edges_.push_back(part);
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
    const Vec3 m = 0.5 * (cut_.place(cut_.from(h)) + cut_.place(cut_.to(h))), c = cut_.middle(t);
    const Vec3 aside = inward(h);
    const double depth = dot(c - m, aside);
    if (depth < 2 * tolerance_) return {};
    std::int32_t cell = tree_.locate(m);
    const auto place = [&](double s) { return lerp(m, c, s); };
    const auto face = [&](double s) { return face_at(place(s), cell); };
    const double begin = tolerance_ / depth;
    const std::optional<FieldSample> near = face(begin);
    if (!near || near->owner == owner_of(t)) return {};
    return first_change(face, near->owner, begin, 1, place);
  }

  bool crosses_itself() const {
    const LabelledMesh& mesh = cut_.mesh;
    if (std::none_of(cut_.changed.begin(), cut_.changed.end(), [](char c) { return c != 0; }))
      return false;
    return !self_intersections(mesh.vertices, mesh.triangles, threads_, cut_.changed).empty();
  }

  const ExactField& field_;
  const CellOctree& tree_;
  double tolerance_;
  int threads_;
  CutMesh cut_;
  FlatMap ids_;                               ///< of faces, in the mesh
  FlatMap asked_;                             ///< edges by their vertices, as a triangle has them
  std::vector<Plane> plane_;                  ///< by triangle
  std::deque<std::uint32_t> edges_, chords_;  ///< triangles to look at
};

}  // namespace

LabelledMesh cut_owner_borders(const ExactField& field, const CellOctree& tree,
                               const LabelledMesh& mesh, double tolerance, int threads) {
  return BorderCutter(field, tree, mesh, tolerance, threads).run(mesh);
}

}  // namespace mrsim::detail
