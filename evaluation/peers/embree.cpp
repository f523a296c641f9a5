/// Embree's user geometry: a tree with four or eight boxes per node, refitted.
///
/// `rtcCollide` accepts only user geometries,
/// reports pairs of primitives from overlapping leaves, and cannot be stopped: once there are
/// enough contacts, other pairs are ignored. The narrow phase is ours. One thread, like all
/// methods in the comparison.
#include "evaluation/peers/adapters.hpp"
#include "evaluation/peers/candidates.hpp"
#include "evaluation/peers/embree_body.hpp"

namespace pelt::peers {
namespace {

void take(void* candidates, RTCCollision* pairs, unsigned int count) {
  for (unsigned int i = 0; i < count; ++i)
    static_cast<Candidates*>(candidates)->add(pairs[i].primID0, pairs[i].primID1);
}

class EmbreeMethod final : public rivals::PosedMeshMethod {
 public:
  EmbreeMethod() : device_(rtcNewDevice("threads=1")) {}
  EmbreeMethod(const EmbreeMethod&) = delete;
  EmbreeMethod& operator=(const EmbreeMethod&) = delete;
  ~EmbreeMethod() override {
    bodies_.clear();
    rtcReleaseDevice(device_);
  }

  void add(std::span<const Triangle> triangles, std::span<const Vec3> rest) override {
    bodies_.push_back(std::make_unique<EmbreeBody>(device_, triangles, rest));
  }

  void update(std::uint32_t body, std::span<const Vec3> positions) override {
    bodies_[body]->update(positions);
  }

  QueryStats collide(std::uint32_t a, std::uint32_t b, std::vector<Contact>& contacts,
                     std::uint32_t max_contacts) override {
    Candidates candidates(bodies_[a]->mesh(), bodies_[b]->mesh(), contacts, max_contacts);
    rtcCollide(bodies_[a]->scene(), bodies_[b]->scene(), take, &candidates);
    return candidates.work();
  }

 private:
  RTCDevice device_;
  std::vector<std::unique_ptr<EmbreeBody>> bodies_;
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

}  // namespace pelt::peers
