#include "mesh/draw/ray_scene.h"

#include "core/numbers/hash.h"
#include "core/process/error.h"
#include "core/process/parallel.h"
#include "mesh/solid/check.h"
#include "mesh/solid/half_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <embree3/rtcore.h>

namespace mrsim {

struct RayScene::Embree {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  ~Embree() {
    if (scene) rtcReleaseScene(scene);
    if (device) rtcReleaseDevice(device);
  }
};

namespace {

[[noreturn]] void fail_memory() {
  throw Error("memory",
              "not enough memory to draw the mesh: free some, or raise its limit (ulimit -v)");
}

RTCRay make_ray(const Vec3& origin, const Vec3& direction, double length) {
  RTCRay ray{};
  ray.org_x = float(origin.x), ray.org_y = float(origin.y), ray.org_z = float(origin.z);
  ray.dir_x = float(direction.x), ray.dir_y = float(direction.y), ray.dir_z = float(direction.z);
  ray.tnear = 0;
  ray.tfar = float(length);
  ray.mask = ~0u;
  return ray;
}

using Corners = std::array<std::array<float, 3>, 3>;

Corners sorted_corners(const TriMesh& mesh, std::uint32_t face) {
  Corners out;
  for (int k = 0; k < 3; ++k) {
    out[k] = mesh.vertices[mesh.triangles[face][k]];
    for (float& x : out[k]) x += 0.0f;  // no -0
  }
  std::sort(out.begin(), out.end());
  return out;
}

// Keeps the first of all faces with the same corners. A ray that meets one of them meets all of
// them: without this, thousands of bodies in one place would take thousands of times as long.
std::vector<std::uint32_t> distinct_faces(const TriMesh& mesh) {
  struct FaceKey {
    std::uint64_t hash = 0;
    std::uint32_t face = 0;
    bool operator<(const FaceKey& other) const {
      return hash != other.hash ? hash < other.hash : face < other.face;
    }
  };
  std::vector<FaceKey> keys(mesh.triangles.size());
  for (std::uint32_t f = 0; f < keys.size(); ++f) {
    const Corners corners = sorted_corners(mesh, f);
    ContentHash hash;
    hash.update(corners.data(), sizeof(corners));
    keys[f] = {hash.digest(), f};
  }
  std::sort(keys.begin(), keys.end());
  std::vector<std::uint32_t> out;
  for (std::size_t k = 0; k < keys.size(); ++k)
    if (k == 0 || keys[k].hash != keys[k - 1].hash ||
        sorted_corners(mesh, keys[k].face) != sorted_corners(mesh, keys[k - 1].face))
      out.push_back(keys[k].face);
  std::sort(out.begin(), out.end());
  return out;
}

void fill_geometry(RTCGeometry geometry, const TriMesh& mesh,
                   const std::vector<std::uint32_t>& faces, const Vec3& center) {
  auto* points = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                                             RTC_FORMAT_FLOAT3, 3 * sizeof(float),
                                                             mesh.vertices.size()));
  auto* indices = static_cast<std::uint32_t*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                              3 * sizeof(std::uint32_t), faces.size()));
  if (!points || !indices) fail_memory();
  for (const auto& vertex : mesh.vertices) {
    const Vec3 p = to_vec(vertex) - center;
    *points++ = float(p.x), *points++ = float(p.y), *points++ = float(p.z);
  }
  for (const std::uint32_t face : faces)
    for (const std::uint32_t v : mesh.triangles[face]) *indices++ = v;
}

}  // namespace

RayScene::RayScene(const TriMesh& mesh, int threads)
    : embree_(std::make_unique<Embree>()), faces_(distinct_faces(mesh)) {
  const Box3 box = mesh_bounds(mesh);
  center_ = 0.5 * (box.lo + box.hi);
  embree_->device = rtcNewDevice("set_affinity=0");
  if (!embree_->device) fail_memory();
  embree_->scene = rtcNewScene(embree_->device);
  rtcSetSceneFlags(embree_->scene, RTC_SCENE_FLAG_ROBUST);
  RTCGeometry geometry = rtcNewGeometry(embree_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  fill_geometry(geometry, mesh, faces_, center_);
  with_threads(threads, [&] {
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(embree_->scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(embree_->scene);
  });
  if (rtcGetDeviceError(embree_->device) != RTC_ERROR_NONE) fail_memory();
}

RayScene::~RayScene() = default;

std::optional<RayHit> RayScene::first_hit(const Vec3& origin, const Vec3& direction) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  RTCRayHit query{};
  query.ray = make_ray(origin - center_, direction, std::numeric_limits<double>::infinity());
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(embree_->scene, &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
  return RayHit{faces_[query.hit.primID], query.hit.u, query.hit.v, query.ray.tfar};
}

bool RayScene::is_blocked(const Vec3& origin, const Vec3& direction, double length) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay ray = make_ray(origin - center_, direction, length);
  rtcOccluded1(embree_->scene, &context, &ray);
  return ray.tfar < 0;
}

}  // namespace mrsim
