/// Embree's user geometry: a tree with four or eight boxes per node, refitted.
///
/// `rtcCollide` accepts only user geometries, reports pairs of primitives from overlapping leaves,
/// and cannot be stopped: once there are enough contacts, other pairs are ignored. The narrow phase
/// is ours. One thread, like all methods in the comparison.

#include "evaluation/peers/adapters.hpp"
#include "evaluation/peers/candidates.hpp"

#include <embree3/rtcore.h>

#include <algorithm>
#include <memory>

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

/// The triangles of a body as Embree's user geometry, in a scene of its own.
///
/// A geometry of quality REFIT is refitted only in a scene of quality LOW; in any other scene it is
/// silently built again, which takes 30 times as long.
class EmbreeBody {
 public:
  EmbreeBody(RTCDevice device, std::span<const Triangle> triangles, std::span<const Vec3> rest)
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
  EmbreeBody(const EmbreeBody&) = delete;
  EmbreeBody& operator=(const EmbreeBody&) = delete;
  ~EmbreeBody() {
    rtcReleaseGeometry(geometry_);
    rtcReleaseScene(scene_);
  }

  void update(std::span<const Vec3> positions) {
    mesh_.positions = positions;
    commit();
  }

  const PosedBody& mesh() const { return mesh_; }
  RTCScene scene() const { return scene_; }

 private:
  void commit() {
    rtcCommitGeometry(geometry_);
    rtcCommitScene(scene_);
  }

  PosedBody mesh_;
  RTCScene scene_;
  RTCGeometry geometry_;
};

void take(void* candidates, RTCCollision* pairs, unsigned int count) {
  for (unsigned int i = 0; i < count; ++i)
    static_cast<Candidates*>(candidates)->add(pairs[i].primID0, pairs[i].primID1);
}

/// A method with a device of its own. One thread, like all methods in the comparison.
template <typename Body>
class EmbreeBodies : public rivals::PosedMeshMethod {
 public:
  EmbreeBodies() : device_(rtcNewDevice("threads=1")) {}
  EmbreeBodies(const EmbreeBodies&) = delete;
  EmbreeBodies& operator=(const EmbreeBodies&) = delete;
  ~EmbreeBodies() override {
    bodies_.clear();
    rtcReleaseDevice(device_);
  }

  void add(std::span<const Triangle> triangles, std::span<const Vec3> rest) final {
    bodies_.push_back(std::make_unique<Body>(device_, triangles, rest));
  }

  void update(std::uint32_t body, std::span<const Vec3> positions) final {
    bodies_[body]->update(positions);
  }

 protected:
  std::vector<std::unique_ptr<Body>> bodies_;

 private:
  RTCDevice device_;
};

class EmbreeMethod final : public EmbreeBodies<EmbreeBody> {
 public:
  QueryStats collide(std::uint32_t a, std::uint32_t b, std::vector<Contact>& contacts,
                     std::uint32_t max_contacts) override {
    Candidates candidates(bodies_[a]->mesh(), bodies_[b]->mesh(), contacts, max_contacts);
    rtcCollide(bodies_[a]->scene(), bodies_[b]->scene(), take, &candidates);
    return candidates.work();
  }
};

}  // namespace

std::unique_ptr<rivals::PosedMeshMethod> make_embree() { return std::make_unique<EmbreeMethod>(); }

std::string embree_version() {
  const RTCDevice device = rtcNewDevice("threads=1");
  const auto part = [&](RTCDeviceProperty property) {
    return std::to_string(rtcGetDeviceProperty(device, property));
  };
  std::string version = part(RTC_DEVICE_PROPERTY_VERSION_MAJOR) + '.' +
                        part(RTC_DEVICE_PROPERTY_VERSION_MINOR) + '.' +
                        part(RTC_DEVICE_PROPERTY_VERSION_PATCH);
  rtcReleaseDevice(device);
  return version;
}

namespace {

// Embree's rtcCollide of a scene with itself, on a tree of boxes that is refitted. The narrow
// phase is ours. A query cannot be stopped: once there are enough contacts, other pairs are
// ignored.

using EmbreeCandidates = SelfCandidates<ApartByPelt>;

/// Embree reports each pair in both orders.
void take_ordered(void* candidates, RTCCollision* pairs, unsigned int count) {
  for (unsigned int i = 0; i < count; ++i)
    if (pairs[i].primID0 < pairs[i].primID1)
      static_cast<EmbreeCandidates*>(candidates)->add(pairs[i].primID0, pairs[i].primID1);
}

struct SelfEmbreeBody : EmbreeBody {
  SelfEmbreeBody(RTCDevice device, std::span<const Triangle> triangles, std::span<const Vec3> rest)
      : EmbreeBody(device, triangles, rest), neighbours(triangles, rest) {}

  Neighbours neighbours;
};

class SelfEmbreeMethod final : public EmbreeBodies<SelfEmbreeBody> {
 public:
  QueryStats collide(std::uint32_t a, std::uint32_t, std::vector<Contact>& contacts,
                     std::uint32_t max_contacts) override {
    const SelfEmbreeBody& body = *bodies_[a];
    EmbreeCandidates candidates(body.mesh(), body.neighbours, OfNeighbours::decided, {body.mesh()},
                                contacts, max_contacts);
    rtcCollide(body.scene(), body.scene(), take_ordered, &candidates);
    return candidates.work();
  }
};

}  // namespace

std::unique_ptr<rivals::PosedMeshMethod> make_self_embree() {
  return std::make_unique<SelfEmbreeMethod>();
}

}  // namespace pelt::peers
