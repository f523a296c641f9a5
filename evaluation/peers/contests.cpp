#include "evaluation/peers/contests.hpp"

#include "evaluation/methods/lab_methods.hpp"
#include "evaluation/methods/posed_mesh_adapter.hpp"
#include "evaluation/peers/peers.hpp"
#include "tools/pelt/methods/command_methods.hpp"

#include <functional>

namespace pelt::tools {
namespace {

using bench::Asked;
using bench::BenchMethod;
using bench::method_of;
using bench::self_method;
using peers::Peer;
using scene::Collider;
using scene::SceneQuery;

class SkinningOnly final : public rivals::PosedMeshMethod {
 public:
  void add(std::span<const Triangle>, std::span<const Vec3>) override {}
  void update(std::uint32_t, std::span<const Vec3>) override {}
  QueryStats collide(std::uint32_t, std::uint32_t, std::vector<Contact>&, std::uint32_t) override {
    return {};
  }
};

using MakeMethod = std::function<std::unique_ptr<rivals::PosedMeshMethod>()>;

BenchMethod method_from(std::string_view name, const MakeMethod& make) {
  return {std::string(name), [make](std::span<const Collider> colliders) {
            return SceneQuery(colliders, lab::adapt(make()));
          }};
}

BenchMethod self_method_from(std::string_view name, const MakeMethod& make) {
  return {std::string(name),
          [make](std::span<const Collider> colliders) {
            return SceneQuery::of_each(colliders, lab::adapt(make()));
          },
          Asked::self};
}

Contestant of_peer(const Peer& peer, BenchMethod method) {
  return {std::move(method), std::string(peer.name), peer.version, std::string(peer.update),
          peer.narrow_phase == peers::NarrowPhase::ours ? "ours" : "its own"};
}

std::vector<Contestant> contestants_in_pairs() {
  std::vector<Contestant> all = {
      {method_of(methods::kOnDemand), "pelt on_demand", "", "palettes", "ours", true},
      {method_of(methods::kEager), "pelt eager", "", "skin, refit", "ours", true}};
  for (const Peer& peer : peers::all_peers())
    all.push_back(of_peer(
        peer, method_from(peer.name, [name = peer.name] { return peers::make_peer(name); })));
  return all;
}

std::vector<Contestant> contestants_by_themselves() {
  std::vector<Contestant> all = {
      {self_method(methods::kSelf), "pelt self", "", "palettes", "ours", true},
      {self_method(lab::kSelfEager), "pelt eager", "", "skin, refit", "ours", true}};
  for (const Peer& peer : peers::all_self_peers())
    all.push_back(of_peer(peer, self_method_from(peer.name, [name = peer.name] {
                            return peers::make_self_peer(name);
                          })));
  return all;
}

}  // namespace

std::vector<Contestant> contestants(Contest contest) {
  return contest == Contest::self ? contestants_by_themselves() : contestants_in_pairs();
}

BenchMethod skinning_method() {
  return method_from("skinning", [] { return std::make_unique<SkinningOnly>(); });
}

BenchMethod exact_method(Contest contest) {
  return contest == Contest::self ? self_method(methods::kSelfBrute) : method_of(methods::kBrute);
}

}  // namespace pelt::tools
