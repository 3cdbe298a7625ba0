#include "mesh/draw/ray_scene.h"

#include "core/process/error.h"
#include "core/process/parallel.h"
#include "mesh/solid/check.h"
#include "mesh/solid/half_edges.h"

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

void fill_geometry(RTCGeometry geometry, const TriMesh& mesh, const Vec3& center) {
  auto* points = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                                             RTC_FORMAT_FLOAT3, 3 * sizeof(float),
                                                             mesh.vertices.size()));
  auto* indices = static_cast<std::uint32_t*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                              3 * sizeof(std::uint32_t), mesh.triangles.size()));
  if (!points || !indices) fail_memory();
  for (const auto& vertex : mesh.vertices) {
    const Vec3 p = to_vec(vertex) - center;
    *points++ = float(p.x), *points++ = float(p.y), *points++ = float(p.z);
  }
  for (const auto& t : mesh.triangles)
    for (const std::uint32_t v : t) *indices++ = v;
}

}  // namespace

RayScene::RayScene(const TriMesh& mesh, int threads) : embree_(std::make_unique<Embree>()) {
  const Box3 box = mesh_bounds(mesh);
  center_ = 0.5 * (box.lo + box.hi);
  embree_->device = rtcNewDevice("set_affinity=0");
  if (!embree_->device) fail_memory();
  embree_->scene = rtcNewScene(embree_->device);
  rtcSetSceneFlags(embree_->scene, RTC_SCENE_FLAG_ROBUST);
  RTCGeometry geometry = rtcNewGeometry(embree_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  fill_geometry(geometry, mesh, center_);
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
  return RayHit{query.hit.primID, query.hit.u, query.hit.v, query.ray.tfar};
}

bool RayScene::is_blocked(const Vec3& origin, const Vec3& direction, double length) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay ray = make_ray(origin - center_, direction, length);
  rtcOccluded1(embree_->scene, &context, &ray);
  return ray.tfar < 0;
}

}  // namespace mrsim
