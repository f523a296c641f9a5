/// A geometry of quality REFIT in a scene of quality LOW, because no other scene is refitted (see
/// embree.cpp); ROBUST, because otherwise rays pass through edges. One thread.
#include "evaluation/peers/embree_mesh.hpp"

#include "geometry/triangle_distance.hpp"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace pelt::peers {
namespace {

constexpr std::size_t kEight = 8;

RTCRayHit make_ray(const Ray& ray) {
  RTCRayHit query{};
  query.ray.org_x = ray.origin.x;
  query.ray.org_y = ray.origin.y;
  query.ray.org_z = ray.origin.z;
  query.ray.dir_x = ray.direction.x;
  query.ray.dir_y = ray.direction.y;
  query.ray.dir_z = ray.direction.z;
  query.ray.tnear = ray.t_min;
  query.ray.tfar = ray.t_max;
  query.ray.mask = ~0u;
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  return query;
}

RayHit make_hit(unsigned int geometry, unsigned int triangle, float t) {
  RayHit hit;
  if (geometry == RTC_INVALID_GEOMETRY_ID) return hit;
  hit.triangle = triangle;
  hit.t = t;
  return hit;
}

RTCIntersectContext make_context() {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  return context;
}

void cast_one(RTCScene scene, std::span<const Ray> rays, std::span<RayHit> hits) {
  RTCIntersectContext context = make_context();
  for (std::size_t i = 0; i < rays.size(); ++i) {
    RTCRayHit query = make_ray(rays[i]);
    rtcIntersect1(scene, &context, &query);
    hits[i] = make_hit(query.hit.geomID, query.hit.primID, query.ray.tfar);
  }
}

void put_lane(const Ray& ray, RTCRayHit8& query, std::size_t lane) {
  query.ray.org_x[lane] = ray.origin.x;
  query.ray.org_y[lane] = ray.origin.y;
  query.ray.org_z[lane] = ray.origin.z;
  query.ray.dir_x[lane] = ray.direction.x;
  query.ray.dir_y[lane] = ray.direction.y;
  query.ray.dir_z[lane] = ray.direction.z;
  query.ray.tnear[lane] = ray.t_min;
  query.ray.tfar[lane] = ray.t_max;
  query.ray.mask[lane] = ~0u;
  query.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
}

void cast_eight(RTCScene scene, std::span<const Ray> rays, std::span<RayHit> hits) {
  RTCIntersectContext context = make_context();
  for (std::size_t first = 0; first < rays.size(); first += kEight) {
    const std::size_t count = std::min(kEight, rays.size() - first);
    alignas(32) int valid[kEight] = {};
    RTCRayHit8 query{};
    for (std::size_t lane = 0; lane < count; ++lane) {
      valid[lane] = -1;
      put_lane(rays[first + lane], query, lane);
    }
    rtcIntersect8(valid, scene, &context, &query);
    for (std::size_t lane = 0; lane < count; ++lane)
      hits[first + lane] =
          make_hit(query.hit.geomID[lane], query.hit.primID[lane], query.ray.tfar[lane]);
  }
}

void cast_stream(RTCScene scene, std::span<const Ray> rays, std::span<RayHit> hits,
                 std::vector<RTCRayHit>& queries) {
  RTCIntersectContext context = make_context();
  queries.resize(rays.size());
  std::transform(rays.begin(), rays.end(), queries.begin(), make_ray);
  rtcIntersect1M(scene, &context, queries.data(), static_cast<unsigned int>(rays.size()),
                 sizeof(RTCRayHit));
  std::transform(queries.begin(), queries.end(), hits.begin(), [](const RTCRayHit& query) {
    return make_hit(query.hit.geomID, query.hit.primID, query.ray.tfar);
  });
}

/// The state of a search for the closest triangle.
struct ClosestSoFar {
  std::span<const Triangle> triangles;
  std::span<const Vec3> positions;
  double squared_distance = std::numeric_limits<double>::infinity();
  std::uint32_t triangle = 0;
};

/// Embree's callback for each triangle of a leaf within the radius. Returns whether the radius
/// shrank.
bool look_at_triangle(RTCPointQueryFunctionArguments* arguments) {
  auto& best = *static_cast<ClosestSoFar*>(arguments->userPtr);
  const auto [a, b, c] = best.triangles[arguments->primID];
  const RTCPointQuery& query = *arguments->query;
  const double squared =
      detail::closest_on_triangle(detail::Vec3d(query.x, query.y, query.z),
                                  {best.positions[a], best.positions[b], best.positions[c]})
          .squared_distance;
  if (squared >= best.squared_distance) return false;
  best.squared_distance = squared;
  best.triangle = arguments->primID;
  arguments->query->radius = static_cast<float>(std::sqrt(squared));
  return true;
}

}  // namespace

struct EmbreeMesh::Scene {
  Scene(std::span<const Triangle> t, std::size_t vertex_count)
      : triangles(t),
        positions(vertex_count + 1),  // Embree reads four bytes beyond the last vertex
        device(rtcNewDevice("threads=1")),
        scene(rtcNewScene(device)),
        geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE)) {
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                               positions.data(), 0, sizeof(Vec3), vertex_count);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                               triangles.data(), 0, sizeof(Triangle), triangles.size());
    rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_REFIT);
    rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_LOW);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_DYNAMIC | RTC_SCENE_FLAG_ROBUST);
    rtcAttachGeometry(scene, geometry);
  }
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;
  ~Scene() {
    rtcReleaseGeometry(geometry);
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }

  std::span<const Triangle> triangles;
  std::vector<Vec3> positions;
  std::vector<RTCRayHit> queries;
  RTCDevice device;
  RTCScene scene;
  RTCGeometry geometry;
};

EmbreeMesh::EmbreeMesh(std::span<const Triangle> triangles, std::size_t vertex_count)
    : scene_(std::make_unique<Scene>(triangles, vertex_count)) {}
EmbreeMesh::~EmbreeMesh() = default;

std::span<Vec3> EmbreeMesh::positions() {
  return std::span(scene_->positions).first(scene_->positions.size() - 1);
}

void EmbreeMesh::refit() {
  rtcUpdateGeometryBuffer(scene_->geometry, RTC_BUFFER_TYPE_VERTEX, 0);
  rtcCommitGeometry(scene_->geometry);
  rtcCommitScene(scene_->scene);
}

void EmbreeMesh::cast(std::span<const Ray> rays, std::span<RayHit> hits, RayCalls calls) {
  switch (calls) {
    case RayCalls::one:
      return cast_one(scene_->scene, rays, hits);
    case RayCalls::eight:
      return cast_eight(scene_->scene, rays, hits);
    case RayCalls::stream:
      return cast_stream(scene_->scene, rays, hits, scene_->queries);
  }
}

void EmbreeMesh::find_closest(std::span<const Vec3> points, std::span<ClosestPoint> closest) {
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3& p = points[i];
    ClosestSoFar best = {scene_->triangles, scene_->positions};
    RTCPointQuery query = {p.x, p.y, p.z, 0, std::numeric_limits<float>::infinity()};
    rtcPointQuery(scene_->scene, &query, &context, look_at_triangle, &best);
    closest[i].distance = std::sqrt(best.squared_distance);
    closest[i].point.triangle = best.triangle;
  }
}

}  // namespace pelt::peers
