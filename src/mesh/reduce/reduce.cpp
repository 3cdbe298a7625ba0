#include "mesh/reduce/reduce.h"

#include "core/error.h"
#include "core/memory_limit.h"
#include "core/parallel.h"
#include "core/triangle_tree.h"
#include "core/vec.h"
#include "mesh/solid/half_edges.h"
#include "mesh/solid/self_intersection.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModBaseT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>

namespace mrsim {
namespace {

constexpr int kRounds = 4;                 // of one step, each with more vertices that stay
constexpr double kLeastShare = 0.5;        // of the triangles of a step's mesh that it keeps
constexpr double kBytesPerTriangle = 450;  // of its half edges, quadrics and heap
constexpr double kLeastCosine = 0.2;       // between a face before and after a collapse
constexpr double kLeastHeight = 1e-3;      // of a triangle, as a share of its longest side
constexpr std::size_t kTellEach = 4096;    // collapses
// Edges at a vertex: a collapse beside it costs their square. Vertices of more stay.
constexpr unsigned kMostEdges = 48;

struct Traits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};

// Closed meshes. The two tests that the decimation asks of each edge again and again stand here
// once more: distributions compile those of the library with its assertions, which compare names
// of types at each access (2.5 times the time of the whole decimation).
class HalfEdgeMesh : public OpenMesh::TriMesh_ArrayKernelT<Traits> {
 public:
  // Whether the edge may collapse: both ends have no common neighbours but the two corners of
  // its triangles.
  bool is_collapse_ok(HalfedgeHandle edge) {
    const VertexHandle from = from_vertex_handle(edge), to = to_vertex_handle(edge);
    if (status(edge_handle(edge)).deleted() || status(from).deleted() || status(to).deleted())
      return false;
    const VertexHandle left = corner(edge), right = corner(opposite_halfedge_handle(edge));
    if (left == right) return false;
    for (const VertexHandle v : vv_range(from)) status(v).set_tagged(false);
    for (const VertexHandle v : vv_range(to)) status(v).set_tagged(true);
    for (const VertexHandle v : vv_range(from))
      if (status(v).tagged() && v != left && v != right) return false;
    return true;
  }
  HalfedgeHandle find_halfedge(VertexHandle from, VertexHandle to) const {
    for (const HalfedgeHandle h : voh_range(from))
      if (to_vertex_handle(h) == to) return h;
    return HalfedgeHandle();
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
};

Vec3 vec(const OpenMesh::Vec3d& p) { return {p[0], p[1], p[2]}; }

// Counts the collapses of a reduction, and tells the caller how far it is.
class Counter {
 public:
  Counter(const Progress& tell, std::size_t wanted)
      : tell_(tell), wanted_(static_cast<double>(wanted)) {}
  // Throws Error "cancelled".
  void collapsed() {
    if (++done_ % kTellEach != 0 || !tell_) return;
    if (!tell_("reduce", std::min(static_cast<double>(done_) / wanted_, 1.0)))
      throw Error("cancelled", "the run was stopped");
  }

 private:
  const Progress& tell_;
  double wanted_;
  std::size_t done_ = 0;
};

// Which collapses may be done, whatever they cost.
class Legal : public OpenMesh::Decimater::ModBaseT<HalfEdgeMesh> {
 public:
  using Base = OpenMesh::Decimater::ModBaseT<HalfEdgeMesh>;
  using Self = Legal;
  using Handle = OpenMesh::Decimater::ModHandleT<Legal>;
  using Info = OpenMesh::Decimater::CollapseInfoT<HalfEdgeMesh>;

  explicit Legal(HalfEdgeMesh& mesh) : Base(mesh, true) {}
  const std::string& name() const override {
    static const std::string kName = "Legal";
    return kName;
  }
  void count(Counter& counter) { counter_ = &counter; }

  float collapse_priority(const Info& info) override {
    if (mesh().valence(info.v0) + mesh().valence(info.v1) > kMostEdges)
      return float(Base::ILLEGAL_COLLAPSE);
    for (const HalfEdgeMesh::FaceHandle face : mesh().vf_range(info.v0))
      if (face != info.fl && face != info.fr && !stays_sound(face, info))
        return float(Base::ILLEGAL_COLLAPSE);
    return float(Base::LEGAL_COLLAPSE);
  }
  void postprocess_collapse(const Info&) override { counter_->collapsed(); }

 private:
  // Whether the face keeps its direction and is no needle with the vertex moved.
  bool stays_sound(HalfEdgeMesh::FaceHandle face, const Info& info) {
    std::array<Vec3, 3> before, after;
    std::size_t k = 0;
    for (const HalfEdgeMesh::VertexHandle v : mesh().fv_range(face)) {
      before[k] = vec(mesh().point(v));
      after[k] = v == info.v0 ? vec(info.p1) : before[k];
      ++k;
    }
    const Vec3 old_normal = cross(before[1] - before[0], before[2] - before[0]);
    const Vec3 normal = cross(after[1] - after[0], after[2] - after[0]);
    const double size = length(normal);
    double longest = 0;
    for (std::size_t i = 0; i < 3; ++i)
      longest = std::max(longest, distance(after[i], after[(i + 1) % 3]));
    if (!(size > kLeastHeight * longest * longest)) return false;
    return dot(old_normal, normal) > kLeastCosine * size * length(old_normal);
  }

  Counter* counter_ = nullptr;
};

HalfEdgeMesh decimatable(const TriMesh& mesh, const std::vector<char>& stays) {
  HalfEdgeMesh out;
  out.request_vertex_status();
  out.request_edge_status();
  out.request_face_status();
  out.request_face_normals();
  std::vector<HalfEdgeMesh::VertexHandle> handles;
  handles.reserve(mesh.vertices.size());
  for (const auto& v : mesh.vertices) handles.push_back(out.add_vertex({v[0], v[1], v[2]}));
  for (const auto& t : mesh.triangles) out.add_face(handles[t[0]], handles[t[1]], handles[t[2]]);
  for (std::size_t v = 0; v < stays.size(); ++v)
    out.status(handles[v]).set_locked(stays[v] != 0 || out.valence(handles[v]) > kMostEdges);
  out.update_face_normals();
  return out;
}

// What is left of a mesh, in the order it had.
TriMesh collected(HalfEdgeMesh& from) {
  TriMesh out;
  std::vector<std::uint32_t> number(from.n_vertices(), 0);
  for (const HalfEdgeMesh::VertexHandle v : from.vertices()) {
    const OpenMesh::Vec3d& p = from.point(v);
    number[static_cast<std::size_t>(v.idx())] = static_cast<std::uint32_t>(out.vertices.size());
    out.vertices.push_back({float(p[0]), float(p[1]), float(p[2])});
  }
  for (const HalfEdgeMesh::FaceHandle f : from.faces()) {
    std::array<std::uint32_t, 3> corners{};
    std::size_t k = 0;
    for (const HalfEdgeMesh::VertexHandle v : from.fv_range(f))
      corners[k++] = number[static_cast<std::size_t>(v.idx())];
    out.triangles.push_back(corners);
  }
  return out;
}

TriMesh decimated(const TriMesh& mesh, std::size_t most, const std::vector<char>& stays,
                  Counter& counter) {
  HalfEdgeMesh work = decimatable(mesh, stays);
  OpenMesh::Decimater::DecimaterT<HalfEdgeMesh> decimater(work);
  OpenMesh::Decimater::ModQuadricT<HalfEdgeMesh>::Handle quadrics;
  Legal::Handle legal;
  decimater.add(quadrics);
  decimater.add(legal);
  decimater.module(quadrics).unset_max_err();
  decimater.module(legal).count(counter);
  decimater.initialize();
  decimater.decimate_to_faces(0, most);
  return collected(work);
}

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

Pairs crossings(const TriMesh& mesh, int threads) {
  std::vector<Vec3> points;
  points.reserve(mesh.vertices.size());
  for (const auto& v : mesh.vertices) points.push_back(to_vec(v));
  return detail::self_intersections(points, mesh.triangles, threads);
}

Box3 box_of(const TriMesh& mesh, std::uint32_t triangle) {
  Box3 box;
  for (const std::uint32_t v : mesh.triangles[triangle]) extend(box, to_vec(mesh.vertices[v]));
  return box;
}

// Vertices of the mesh that was given stay where triangles of the small one cross: those near the
// common part of their boxes, in later rounds of both boxes.
void keep_about(const Pairs& pairs, const TriMesh& small, const TriMesh& mesh,
                const TriangleTree& tree, int round, std::vector<char>& stays) {
  for (const auto& [i, j] : pairs) {
    Box3 a = box_of(small, i);
    const Box3 b = box_of(small, j);
    if (round < kRounds / 2) {
      a.lo = {std::max(a.lo.x, b.lo.x), std::max(a.lo.y, b.lo.y), std::max(a.lo.z, b.lo.z)};
      a.hi = {std::min(a.hi.x, b.hi.x), std::min(a.hi.y, b.hi.y), std::min(a.hi.z, b.hi.z)};
    } else {
      extend(a, b.lo);
      extend(a, b.hi);
    }
    tree.visit(a, [&](std::uint32_t t) {
      for (const std::uint32_t v : mesh.triangles[t]) stays[v] = 1;
      return true;
    });
  }
}

void set_owners(const TriMesh& mesh, int threads, TriMesh& small) {
  small.origin = mesh.origin;
  if (mesh.owners.empty()) return;
  const TriangleTree tree(mesh);
  small.owners.resize(small.triangles.size());
  parallel_for(small.triangles.size(), threads, [&](std::size_t i) {
    const auto& t = small.triangles[i];
    const Vec3 sum =
        to_vec(small.vertices[t[0]]) + to_vec(small.vertices[t[1]]) + to_vec(small.vertices[t[2]]);
    small.owners[i] = mesh.owners[tree.nearest((1.0 / 3) * sum).triangle];
  });
}

// One step of the reduction: `mesh` with `most` triangles, or with more where no edge is left that
// may collapse; without triangles where all that were tried cross themselves.
TriMesh step(const TriMesh& mesh, std::size_t most, int threads, Counter& counter) {
  const TriangleTree tree(mesh);
  std::vector<char> stays(mesh.vertices.size(), 0);
  for (int round = 0; round < kRounds; ++round) {
    TriMesh small = decimated(mesh, most, stays, counter);
    const Pairs pairs = crossings(small, threads);
    if (pairs.empty()) return small;
    keep_about(pairs, small, mesh, tree, round, stays);
  }
  return {};
}

}  // namespace

double reduction_memory(std::size_t triangles) {
  return kBytesPerTriangle * static_cast<double>(triangles);
}

TriMesh reduce_mesh(const TriMesh& mesh, std::size_t most, const MeshOptions& options) {
  if (mesh.triangles.size() <= most) return mesh;
  require_memory(reduction_memory(mesh.triangles.size()), "--max-triangles");
  TriMesh reduced = mesh;
  Counter counter(options.progress, (mesh.triangles.size() - most) / 2 + 1);
  while (reduced.triangles.size() > most) {
    const std::size_t size = reduced.triangles.size();
    const auto least = static_cast<std::size_t>(kLeastShare * static_cast<double>(size));
    TriMesh next = step(reduced, std::max(most, least), options.threads, counter);
    if (next.triangles.empty() || next.triangles.size() == size) break;
    reduced = std::move(next);
  }
  set_owners(mesh, options.threads, reduced);
  return reduced;
}

}  // namespace mrsim
