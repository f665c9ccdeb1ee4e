#include "ray_tracer.hpp"

#include <hybridfusion/core/error.hpp>

#include <limits>

#include <embree3/rtcore.h>

namespace hybridfusion {

struct RayTracer::State {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;

  State() = default;
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() {
    if (scene != nullptr) rtcReleaseScene(scene);
    if (device != nullptr) rtcReleaseDevice(device);
  }
};

RayTracer::RayTracer(const Scene& scene) : state_(std::make_unique<State>()) {
  // One thread and no early splits: the tree, and with it every tie, is the same in each run.
  state_->device = rtcNewDevice("threads=1,set_affinity=0");
  HF_CHECK(state_->device != nullptr);
  state_->scene = rtcNewScene(state_->device);
  rtcSetSceneFlags(state_->scene, RTC_SCENE_FLAG_ROBUST);
  RTCGeometry geometry = rtcNewGeometry(state_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(geometry,
                                                               RTC_BUFFER_TYPE_VERTEX,
                                                               0,
                                                               RTC_FORMAT_FLOAT3,
                                                               3 * sizeof(float),
                                                               scene.vertices.size()));
  HF_CHECK(vertices != nullptr);
  for (const Eigen::Vector3f& vertex : scene.vertices) {
    for (int i = 0; i < 3; ++i) *vertices++ = vertex[i];
  }
  auto* indices = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(geometry,
                                                                      RTC_BUFFER_TYPE_INDEX,
                                                                      0,
                                                                      RTC_FORMAT_UINT3,
                                                                      3 * sizeof(std::uint32_t),
                                                                      scene.faces.size()));
  HF_CHECK(indices != nullptr);
  for (const auto& face : scene.faces) {
    for (const std::uint32_t index : face) *indices++ = index;
  }
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(state_->scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(state_->scene);
}

RayTracer::RayTracer(RayTracer&&) noexcept = default;
RayTracer& RayTracer::operator=(RayTracer&&) noexcept = default;
RayTracer::~RayTracer() = default;

RayHit RayTracer::cast(const Eigen::Vector3f& origin,
                       const Eigen::Vector3f& direction,
                       float near_m,
                       float far_m) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit query{};
  query.ray.org_x = origin.x();
  query.ray.org_y = origin.y();
  query.ray.org_z = origin.z();
  query.ray.dir_x = direction.x();
  query.ray.dir_y = direction.y();
  query.ray.dir_z = direction.z();
  query.ray.tnear = near_m;
  query.ray.tfar = far_m;
  query.ray.mask = 0xffffffffU;
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(state_->scene, &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
  return {
      .face = query.hit.primID, .distance_m = query.ray.tfar, .u = query.hit.u, .v = query.hit.v};
}

bool RayTracer::blocked(const Eigen::Vector3f& origin,
                        const Eigen::Vector3f& direction,
                        float near_m,
                        float far_m) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay ray{};
  ray.org_x = origin.x();
  ray.org_y = origin.y();
  ray.org_z = origin.z();
  ray.dir_x = direction.x();
  ray.dir_y = direction.y();
  ray.dir_z = direction.z();
  ray.tnear = near_m;
  ray.tfar = far_m;
  ray.mask = 0xffffffffU;
  rtcOccluded1(state_->scene, &context, &ray);
  return ray.tfar < 0.0F;
}

std::array<RayHit, 4> RayTracer::cast4(const Eigen::Vector3f& origin,
                                       const std::array<Eigen::Vector3f, 4>& directions,
                                       int count) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  alignas(16) RTCRayHit4 query{};
  alignas(16) std::array<int, 4> valid{};
  for (int i = 0; i < 4; ++i) {
    valid[i] = i < count ? -1 : 0;
    query.ray.org_x[i] = origin.x();
    query.ray.org_y[i] = origin.y();
    query.ray.org_z[i] = origin.z();
    query.ray.dir_x[i] = directions[i].x();
    query.ray.dir_y[i] = directions[i].y();
    query.ray.dir_z[i] = directions[i].z();
    query.ray.tnear[i] = 0.0F;
    query.ray.tfar[i] = std::numeric_limits<float>::infinity();
    query.ray.mask[i] = 0xffffffffU;
    query.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
  }
  rtcIntersect4(valid.data(), state_->scene, &context, &query);
  std::array<RayHit, 4> hits;
  for (int i = 0; i < count; ++i) {
    if (query.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID) continue;
    hits[i] = {.face = query.hit.primID[i],
               .distance_m = query.ray.tfar[i],
               .u = query.hit.u[i],
               .v = query.hit.v[i]};
  }
  return hits;
}

unsigned RayTracer::blocked4(const std::array<Eigen::Vector3f, 4>& origins,
                             const std::array<Eigen::Vector3f, 4>& directions,
                             unsigned wanted) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  alignas(16) RTCRay4 rays{};
  alignas(16) std::array<int, 4> valid{};
  for (int i = 0; i < 4; ++i) {
    valid[i] = (wanted >> static_cast<unsigned>(i) & 1U) != 0 ? -1 : 0;
    rays.org_x[i] = origins[i].x();
    rays.org_y[i] = origins[i].y();
    rays.org_z[i] = origins[i].z();
    rays.dir_x[i] = directions[i].x();
    rays.dir_y[i] = directions[i].y();
    rays.dir_z[i] = directions[i].z();
    rays.tnear[i] = 0.0F;
    rays.tfar[i] = std::numeric_limits<float>::infinity();
    rays.mask[i] = 0xffffffffU;
  }
  rtcOccluded4(valid.data(), state_->scene, &context, &rays);
  unsigned blocked = 0;
  for (unsigned i = 0; i < 4; ++i) {
    if (valid[i] != 0 && rays.tfar[i] < 0.0F) blocked |= 1U << i;
  }
  return blocked;
}

}  // namespace hybridfusion
