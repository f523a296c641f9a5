/// Embree's rtcCollide of a scene with itself, on a tree of boxes that is refitted. The narrow
/// phase is ours. A query cannot be stopped: once there are enough contacts, other pairs are
/// ignored.
#include "evaluation/peers/adapters.hpp"
#include "evaluation/peers/candidates.hpp"
#include "evaluation/peers/embree_body.hpp"

#include <memory>

namespace pelt::peers {
namespace {

using EmbreeCandidates = SelfCandidates<ApartByPelt>;

/// Embree reports each pair in both orders.
void take_ordered(void* candidates, RTCCollision* pairs, unsigned int count) {
  for (unsigned int i = 0; i < count; ++i)
    if (pairs[i].primID0 < pairs[i].primID1)
      static_cast<EmbreeCandidates*>(candidates)->add(pairs[i].primID0, pairs[i].primID1);
}

struct SelfEmbreeBody {
  SelfEmbreeBody(RTCDevice device, std::span<const Triangle> triangles, std::span<const Vec3> rest)
      : embree(device, triangles, rest), neighbours(triangles, rest) {}

  EmbreeBody embree;
  Neighbours neighbours;
};

class SelfEmbreeMethod final : public rivals::PosedMeshMethod {
 public:
  SelfEmbreeMethod() : device_(rtcNewDevice("threads=1")) {}
  SelfEmbreeMethod(const SelfEmbreeMethod&) = delete;
  SelfEmbreeMethod& operator=(const SelfEmbreeMethod&) = delete;
  ~SelfEmbreeMethod() override {
    bodies_.clear();
    rtcReleaseDevice(device_);
  }

  void add(std::span<const Triangle> triangles, std::span<const Vec3> rest) override {
    bodies_.push_back(std::make_unique<SelfEmbreeBody>(device_, triangles, rest));
  }

  void update(std::uint32_t body, std::span<const Vec3> positions) override {
    bodies_[body]->embree.update(positions);
  }

  QueryStats collide(std::uint32_t a, std::uint32_t, std::vector<Contact>& contacts,
                     std::uint32_t max_contacts) override {
    const SelfEmbreeBody& body = *bodies_[a];
    EmbreeCandidates candidates(body.embree.mesh(), body.neighbours, OfNeighbours::decided,
                                {body.embree.mesh()}, contacts, max_contacts);
    rtcCollide(body.embree.scene(), body.embree.scene(), take_ordered, &candidates);
    return candidates.work();
  }

 private:
  RTCDevice device_;
  std::vector<std::unique_ptr<SelfEmbreeBody>> bodies_;
};

}  // namespace

std::unique_ptr<rivals::PosedMeshMethod> make_self_embree() {
  return std::make_unique<SelfEmbreeMethod>();
}

}  // namespace pelt::peers
