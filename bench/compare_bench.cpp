// A million samples against a million triangles, ours and CGAL's plain AABB tree in one run. The
// surface is a wavy sphere, the samples lie within 0.05 mm of it.
#include "compare/distance/sampling.h"
#include "core/numbers/vec.h"
#include "mesh/solid/half_edges.h"

#include <cmath>
#include <cstdio>
#include <map>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <benchmark/benchmark.h>

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Primitive = CGAL::AABB_face_graph_triangle_primitive<SurfaceMesh>;
using CgalTree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

// 4 n^2 triangles on a torus-like grid that closes both ways.
mrsim::TriMesh wavy_torus(std::uint32_t n) {
  mrsim::TriMesh mesh;
  const double step = 6.283185307179586 / n;
  for (std::uint32_t j = 0; j < n; ++j)
    for (std::uint32_t i = 0; i < 2 * n; ++i) {
      const double a = step * i / 2, b = step * j;
      const double r = 10 + 0.3 * std::sin(9 * a) * std::cos(5 * b), ring = 40 + r * std::cos(b);
      mesh.vertices.push_back(
          {float(ring * std::cos(a)), float(ring * std::sin(a)), float(r * std::sin(b))});
    }
  const auto at = [&](std::uint32_t j, std::uint32_t i) { return (j % n) * 2 * n + i % (2 * n); };
  for (std::uint32_t j = 0; j < n; ++j)
    for (std::uint32_t i = 0; i < 2 * n; ++i) {
      mesh.triangles.push_back({at(j, i), at(j, i + 1), at(j + 1, i + 1)});
      mesh.triangles.push_back({at(j, i), at(j + 1, i + 1), at(j + 1, i)});
    }
  return mesh;
}

const mrsim::TriMesh& nominal() {
  static const mrsim::TriMesh mesh = wavy_torus(500);  // 1 000 000 triangles
  return mesh;
}

std::vector<mrsim::Vec3> samples() {
  mrsim::SurfaceSamples s = mrsim::sample_surface(nominal(), 1'000'000);
  s.points.resize(s.spread);
  for (std::size_t i = 0; i < s.spread; ++i) {
    const mrsim::Vec3 n = mrsim::normalized(mrsim::area_normal(nominal(), s.faces[i]));
    s.points[i] += 0.05 * std::sin(0.001 * double(i)) * n;
  }
  return s.points;
}

void BM_Build(benchmark::State& state) {
  for (auto _ : state) {
    const mrsim::NominalSurface surface(nominal(), 2);
    state.counters["MB"] = double(surface.memory()) / 1e6;
  }
}
BENCHMARK(BM_Build)->Unit(benchmark::kMillisecond)->UseRealTime();

void BM_Query(benchmark::State& state) {
  const mrsim::NominalSurface surface(nominal(), 2);
  const auto points = samples();
  std::vector<mrsim::SurfaceHit> hits(points.size());
  for (auto _ : state) surface.query(points, hits, int(state.range(0)));
}
BENCHMARK(BM_Query)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

// From the mesh to a million signed distances: CPU is the time of all threads together, which is
// what counts on a machine that has other work.
void BM_Whole(benchmark::State& state) {
  const auto points = samples();
  std::vector<mrsim::SurfaceHit> hits(points.size());
  for (auto _ : state) {
    const mrsim::NominalSurface surface(nominal(), 2);
    surface.query(points, hits, 2);
    state.counters["MB"] = double(surface.memory()) / 1e6;
  }
}
BENCHMARK(BM_Whole)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

SurfaceMesh cgal_mesh() {
  SurfaceMesh mesh;
  for (const auto& v : nominal().vertices) mesh.add_vertex({v[0], v[1], v[2]});
  using V = SurfaceMesh::Vertex_index;
  for (const auto& t : nominal().triangles) mesh.add_face(V(t[0]), V(t[1]), V(t[2]));
  return mesh;
}

void BM_CgalBuild(benchmark::State& state) {
  const SurfaceMesh mesh = cgal_mesh();
  for (auto _ : state) {
    CgalTree tree(faces(mesh).first, faces(mesh).second, mesh);
    tree.build();
    tree.accelerate_distance_queries();
    benchmark::DoNotOptimize(tree);
  }
}
BENCHMARK(BM_CgalBuild)->Unit(benchmark::kMillisecond)->UseRealTime();

// Plain: as a first user writes it, one thread, unsigned, in the order of the samples.
void BM_CgalQuery(benchmark::State& state) {
  const SurfaceMesh mesh = cgal_mesh();
  CgalTree tree(faces(mesh).first, faces(mesh).second, mesh);
  tree.accelerate_distance_queries();
  const auto points = samples();
  double sum = 0;
  for (auto _ : state)
    for (const auto& p : points) sum += tree.squared_distance({p.x, p.y, p.z});
  benchmark::DoNotOptimize(sum);
}
BENCHMARK(BM_CgalQuery)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace

BENCHMARK_MAIN();
