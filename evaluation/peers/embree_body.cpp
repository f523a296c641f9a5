#include "evaluation/peers/embree_body.hpp"

#include <algorithm>

namespace pelt::peers {
namespace {

void bound(const RTCBoundsFunctionArguments* arguments) {
  const auto& body = *static_cast<const PosedBody*>(arguments->geometryUserPtr);
  const auto [a, b, c] = body.corners(arguments->primID);
  RTCBounds& box = *arguments->bounds_o;
  box.lower_x = std::min(std::min(a.x, b.x), c.x);
  box.lower_y = std::min(std::min(a.y, b.y), c.y);
  box.lower_z = std::min(std::min(a.z, b.z), c.z);
  box.upper_x = std::max(std::max(a.x, b.x), c.x);
  box.upper_y = std::max(std::max(a.y, b.y), c.y);
  box.upper_z = std::max(std::max(a.z, b.z), c.z);
}

}  // namespace

EmbreeBody::EmbreeBody(RTCDevice device, std::span<const Triangle> triangles,
                       std::span<const Vec3> rest)
    : mesh_(triangles, rest),
      scene_(rtcNewScene(device)),
      geometry_(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER)) {
  rtcSetGeometryUserPrimitiveCount(geometry_, static_cast<unsigned int>(triangles.size()));
  rtcSetGeometryUserData(geometry_, &mesh_);
  rtcSetGeometryBoundsFunction(geometry_, bound, nullptr);
  rtcSetGeometryBuildQuality(geometry_, RTC_BUILD_QUALITY_REFIT);
  rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_LOW);
  rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_DYNAMIC);
  rtcAttachGeometry(scene_, geometry_);
  commit();
}

EmbreeBody::~EmbreeBody() {
  rtcReleaseGeometry(geometry_);
  rtcReleaseScene(scene_);
}

void EmbreeBody::update(std::span<const Vec3> positions) {
  mesh_.positions = positions;
  commit();
}

void EmbreeBody::commit() {
  rtcCommitGeometry(geometry_);
  rtcCommitScene(scene_);
}

}  // namespace pelt::peers
