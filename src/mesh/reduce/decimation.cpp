#include "mesh/reduce/decimation.h"

#include "core/numbers/vec.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <queue>
#include <utility>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
// Must come behind the mesh: it uses names that the mesh includes.
#include <OpenMesh/Core/Geometry/QuadricT.hh>

namespace mrsim {
namespace {

constexpr double kLeastCosine = 0.2;   // between a face before and after a collapse
constexpr double kNoError = 1e-10;     // mm^4: rounding, where all lies in planes
constexpr double kLeastHeight = 1e-3;  // of a triangle, as a share of its longest side
// Edges at a vertex: a collapse beside it costs their square. Vertices of more stay.
constexpr unsigned kMostEdges = 48;

struct Traits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};

Vec3 vec(const OpenMesh::Vec3d& p) { return {p[0], p[1], p[2]}; }

// A closed mesh. Tests of an edge that the decimation makes again and again are written anew here:
// distributions compile OpenMesh's own with assertions that compare names of types at each access,
// with which the whole decimation takes 2.5 times as long.
class HalfEdgeMesh : public OpenMesh::TriMesh_ArrayKernelT<Traits> {
 public:
  // Whether the edge may collapse: both ends have no common neighbours but the two corners of
  // its triangles, and no two triangles are left back to back.
  bool may_collapse(HalfedgeHandle edge) {
    const VertexHandle from = from_vertex_handle(edge), to = to_vertex_handle(edge);
    const VertexHandle left = corner(edge), right = corner(opposite_halfedge_handle(edge));
    if (left == right) return false;
    for (const VertexHandle v : vv_range(from)) status(v).set_tagged(false);
    unsigned at_to = 0, at_from = 0;
    for (const VertexHandle v : vv_range(to)) status(v).set_tagged(true), ++at_to;
    for (const VertexHandle v : vv_range(from)) {
      ++at_from;
      if (status(v).tagged() && v != left && v != right) return false;
    }
    return at_from > 2 && at_from + at_to <= kMostEdges &&
           !(valence(left) == 3 && valence(right) == 3 && are_joined(left, right));
  }
  unsigned valence(VertexHandle vertex) const {
    unsigned count = 0;
    for (auto it = cvv_iter(vertex); it.is_valid(); ++it) ++count;
    return count;
  }

 private:
  VertexHandle corner(HalfedgeHandle edge) const {
    return to_vertex_handle(next_halfedge_handle(edge));
  }
  bool are_joined(VertexHandle a, VertexHandle b) const {
    for (auto it = cvv_iter(a); it.is_valid(); ++it)
      if (*it == b) return true;
    return false;
  }
};

using Vertex = HalfEdgeMesh::VertexHandle;
using Edge = HalfEdgeMesh::HalfedgeHandle;
using Quadric = OpenMesh::Geometry::Quadricd;

HalfEdgeMesh half_edges(const TriMesh& mesh) {
  HalfEdgeMesh out;
  out.request_vertex_status();
  out.request_edge_status();
  out.request_face_status();
  std::vector<Vertex> handles;
  handles.reserve(mesh.vertices.size());
  for (const auto& v : mesh.vertices) handles.push_back(out.add_vertex({v[0], v[1], v[2]}));
  for (const auto& t : mesh.triangles) out.add_face(handles[t[0]], handles[t[1]], handles[t[2]]);
  return out;
}

class Decimation {
 public:
  Decimation(const TriMesh& mesh, const std::vector<char>& stays)
      : mesh_(half_edges(mesh)), triangles_(mesh.triangles.size()) {
    quadrics_.resize(mesh.vertices.size());
    for (const auto& t : mesh.triangles) add_plane(mesh, t);
    states_.resize(mesh.vertices.size());
    for (std::size_t v = 0; v < states_.size(); ++v)
      states_[v] =
          stays[v] != 0 || mesh_.valence(handle(v)) > kMostEdges ? State::fixed : State::absent;
    for (std::size_t v = 0; v < states_.size(); ++v)
      if (states_[v] != State::fixed) enter(handle(v));
  }

  void run(std::size_t most, const std::function<void()>& collapsed) {
    while (triangles_ > most && !queue_.empty()) {
      const Entry next = queue_.top();
      queue_.pop();
      const Vertex vertex = mesh_.from_vertex_handle(next.edge);
      const bool stale = std::exchange(state(vertex), State::absent) == State::stale;
      if (stale || !mesh_.may_collapse(next.edge)) {
        enter(vertex);
      } else {
        collapse(next.edge);
        collapsed();
      }
    }
  }

  // The triangles and vertices that are left, in their order before.
  TriMesh collected() {
    TriMesh out;
    std::vector<std::uint32_t> number(mesh_.n_vertices(), 0);
    for (const Vertex v : mesh_.vertices()) {
      number[static_cast<std::size_t>(v.idx())] = static_cast<std::uint32_t>(out.vertices.size());
      const OpenMesh::Vec3d& p = mesh_.point(v);
      out.vertices.push_back({float(p[0]), float(p[1]), float(p[2])});
    }
    for (const HalfEdgeMesh::FaceHandle f : mesh_.faces()) {
      std::array<std::uint32_t, 3> corners{};
      std::size_t k = 0;
      for (const Vertex v : mesh_.fv_range(f))
        corners[k++] = number[static_cast<std::size_t>(v.idx())];
      out.triangles.push_back(corners);
    }
    return out;
  }

 private:
  enum class State : std::uint8_t { fixed, absent, fresh, stale };
  // Where errors are equal, as in flat faces, the shortest edge goes first: so triangles stay
  // round.
  struct Entry {
    double error, length;
    Edge edge;
    bool operator<(const Entry& other) const {
      if (error != other.error) return error < other.error;
      return length != other.length ? length < other.length : edge.idx() < other.edge.idx();
    }
    bool operator>(const Entry& other) const { return other < *this; }
  };

  static Vertex handle(std::size_t v) { return Vertex(static_cast<int>(v)); }
  State& state(Vertex v) { return states_[static_cast<std::size_t>(v.idx())]; }
  Quadric& quadric(Vertex v) { return quadrics_[static_cast<std::size_t>(v.idx())]; }

  // The square of the distance from the triangle's plane, times its area.
  void add_plane(const TriMesh& mesh, const std::array<std::uint32_t, 3>& t) {
    const Vec3 a{mesh.vertices[t[0]][0], mesh.vertices[t[0]][1], mesh.vertices[t[0]][2]};
    const Vec3 b{mesh.vertices[t[1]][0], mesh.vertices[t[1]][1], mesh.vertices[t[1]][2]};
    const Vec3 c{mesh.vertices[t[2]][0], mesh.vertices[t[2]][1], mesh.vertices[t[2]][2]};
    const Vec3 across = cross(b - a, c - a), n = normalized(across);
    Quadric plane(n.x, n.y, n.z, -dot(a, n));
    plane *= 0.5 * length(across);
    for (const std::uint32_t v : t) quadrics_[v] += plane;
  }

  // The cheapest edge of the vertex that may collapse goes into the queue.
  void enter(Vertex vertex) {
    candidates_.clear();
    for (const Edge edge : mesh_.voh_range(vertex)) {
      const Vertex to = mesh_.to_vertex_handle(edge);
      Quadric sum = quadric(vertex);
      sum += quadric(to);
      const double error = sum(mesh_.point(to));
      candidates_.push_back({error < kNoError ? 0 : error,
                             distance(vec(mesh_.point(vertex)), vec(mesh_.point(to))), edge});
    }
    std::sort(candidates_.begin(), candidates_.end());
    for (const Entry& candidate : candidates_) {
      if (!mesh_.may_collapse(candidate.edge) || !keeps_faces(candidate.edge)) continue;
      queue_.push(candidate);
      state(vertex) = State::fresh;
      return;
    }
  }

  // Whether the faces that lose the edge's first end keep their direction, and none is a needle.
  bool keeps_faces(Edge edge) {
    const Vertex from = mesh_.from_vertex_handle(edge), to = mesh_.to_vertex_handle(edge);
    const Vec3 old = vec(mesh_.point(from)), moved = vec(mesh_.point(to));
    for (const Edge side : mesh_.voh_range(from)) {
      const Vertex b = mesh_.to_vertex_handle(side);
      const Vertex c = mesh_.to_vertex_handle(mesh_.next_halfedge_handle(side));
      if (b == to || c == to) continue;
      if (!stays_sound(old, moved, vec(mesh_.point(b)), vec(mesh_.point(c)))) return false;
    }
    return true;
  }
  static bool stays_sound(const Vec3& old, const Vec3& moved, const Vec3& b, const Vec3& c) {
    const Vec3 before = cross(b - old, c - old), after = cross(b - moved, c - moved);
    const double size = length(after);
    const double longest = std::max({distance(moved, b), distance(b, c), distance(c, moved)});
    return size > kLeastHeight * longest * longest &&
           dot(before, after) > kLeastCosine * size * length(before);
  }

  // All vertices about the end that is left are evaluated again, at once where none could collapse.
  void collapse(Edge edge) {
    const Vertex from = mesh_.from_vertex_handle(edge), to = mesh_.to_vertex_handle(edge);
    mesh_.collapse(edge);
    triangles_ -= 2;
    state(from) = State::fixed;
    quadric(to) += quadric(from);
    around_.assign(1, to);
    for (const Vertex v : mesh_.vv_range(to)) around_.push_back(v);
    for (const Vertex v : around_) {
      if (state(v) == State::fresh) state(v) = State::stale;
      if (state(v) == State::absent) enter(v);
    }
  }

  HalfEdgeMesh mesh_;
  std::size_t triangles_;
  std::vector<Quadric> quadrics_;
  std::vector<State> states_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
  std::vector<Entry> candidates_;
  std::vector<Vertex> around_;
};

}  // namespace

TriMesh decimated(const TriMesh& mesh, std::size_t most, const std::vector<char>& stays,
                  const std::function<void()>& collapsed) {
  Decimation decimation(mesh, stays);
  decimation.run(most, collapsed);
  return decimation.collected();
}

}  // namespace mrsim
