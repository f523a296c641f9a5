#include "evaluation/peers/peer_figures.hpp"

#include "evaluation/methods/posed_mesh_adapter.hpp"
#include "tools/pelt/methods/command_methods.hpp"

#include <algorithm>
#include <array>

namespace pelt::tools {
namespace {

using bench::Cache;
using bench::Engine;
using bench::engine_of;
using bench::in_frame;
using bench::Question;
using bench::Runner;
using bench::Subject;
using bench::Times;
using bench::Variant;
using methods::MethodKind;
using peers::Peer;
using scene::Collider;
using scene::FrameContacts;
using scene::Palettes;
using scene::SceneQuery;

constexpr std::array kOwn = {methods::kOnDemand, methods::kEager};
constexpr std::array kVariants = {Variant{Question::all, Cache::hot},
                                  Variant{Question::first, Cache::hot}};

/// A method that only skins all vertices, which every peer needs.
class SkinningOnly final : public rivals::PosedMeshMethod {
 public:
  void add(std::span<const Triangle>, std::span<const Vec3>) override {}
  void update(std::uint32_t, std::span<const Vec3>) override {}
  QueryStats collide(std::uint32_t, std::uint32_t, std::vector<Contact>&, std::uint32_t) override {
    return {};
  }
};

using MakeMethod = std::function<std::unique_ptr<rivals::PosedMeshMethod>()>;

Engine engine_from(std::string_view name, const MakeMethod& make) {
  return {std::string(name), [make](std::span<const Collider> colliders) {
            return SceneQuery(colliders, methods::adapt(make()));
          }};
}

/// Skinning alone, Pelt's methods, then the peers.
std::vector<Engine> all_engines() {
  std::vector<Engine> engines = {
      engine_from("skinning", [] { return std::make_unique<SkinningOnly>(); })};
  for (const MethodKind kind : kOwn) engines.push_back(engine_of(kind));
  for (const Peer& peer : peers::all_peers())
    engines.push_back(
        engine_from(peer.name, [name = peer.name] { return peers::make_peer(name); }));
  return engines;
}

/// The contacts of a pair of colliders in `found`; empty if they do not touch.
std::span<const Contact> contacts_of(const FrameContacts& found, const FrameContacts::Pair& pair) {
  const auto place = std::find_if(found.pairs.begin(), found.pairs.end(), [&](const auto& other) {
    return other.a == pair.a && other.b == pair.b;
  });
  return place == found.pairs.end() ? std::span<const Contact>() : found.of(*place);
}

peers::Difference compare_frames(const FrameContacts& answer, const FrameContacts& exact) {
  peers::Difference sum;
  for (const FrameContacts::Pair& pair : exact.pairs)
    sum += peers::compare(contacts_of(answer, pair), exact.of(pair));
  for (const FrameContacts::Pair& pair : answer.pairs)
    if (contacts_of(exact, pair).empty()) sum += peers::compare(answer.of(pair), {});
  return sum;
}

/// Finds all contacts of a frame.
Result<void> ask_all(Runner& runner, const Palettes& palettes) {
  if (const auto posed = runner.pose(palettes); !posed) return posed.error();
  runner.ask(Question::all);
  return {};
}

/// Counts the contacts of brute force, and how the others differ from them.
Result<void> compare_all(const Subject& subject, const std::function<void()>& advance,
                         ScenePeers& scene) {
  Runner exact(subject.colliders, engine_of(methods::kBrute));
  std::vector<Runner> runners;
  for (const Engine& engine : all_engines()) runners.emplace_back(subject.colliders, engine);
  asset::SampleScratch scratch;
  Palettes palettes;
  for (const std::uint32_t frame : subject.frames) {
    scene::sample_palettes(subject.scene, frame, scratch, palettes);
    if (const auto asked = ask_all(exact, palettes); !asked) return in_frame(frame, asked.error());
    scene.contacts += exact.found().contacts.size();
    scene.frames_in_contact += !exact.found().contacts.empty();
    for (std::size_t m = 0; m < scene.methods.size(); ++m) {
      Runner& runner = runners[m + 1];
      if (const auto asked = ask_all(runner, palettes); !asked)
        return in_frame(frame, asked.error());
      scene.methods[m].difference += compare_frames(runner.found(), exact.found());
    }
    advance();
  }
  return {};
}

void set_times(const std::vector<Times>& times, double skinning_us, PeerFigures& figures) {
  const Times &all = times[0], &first = times[1];
  figures.skinning_us = skinning_us;
  figures.update_us = std::max(0.0, all.mean_update_us - skinning_us);
  figures.all_us = all.mean_us - all.mean_update_us;
  figures.first_us = first.mean_us - first.mean_update_us;
  figures.frame_us = all.mean_us;
  figures.first_frame_us = first.mean_us;
}

std::vector<PeerFigures> all_methods() {
  std::vector<PeerFigures> methods = {{"pelt on_demand", "", "palettes", "ours"},
                                      {"pelt eager", "", "skin, refit", "ours"}};
  for (const Peer& peer : peers::all_peers())
    methods.push_back({std::string(peer.name), peer.version, std::string(peer.update),
                       peer.narrow_phase == peers::NarrowPhase::ours ? "ours" : "its own"});
  return methods;
}

}  // namespace

std::size_t peer_steps(std::size_t frames) { return frames * (all_engines().size() + 1); }

Result<ScenePeers> measure_peers(const Subject& subject, std::uint32_t repetitions,
                                 const std::function<void()>& advance) {
  ScenePeers scene;
  scene.scene = subject.scene.name;
  for (const Collider& collider : subject.colliders)
    scene.triangles += collider.model.triangle_count();
  scene.frames = subject.frames.size();
  scene.repetitions = repetitions;
  scene.methods = all_methods();
  if (const auto compared = compare_all(subject, advance, scene); !compared)
    return compared.error();
  const auto times = bench::measure(subject, all_engines(), kVariants, repetitions, advance);
  if (!times) return times.error();
  const double skinning_us = (*times)[0][0].mean_update_us;
  for (std::size_t m = 0; m < scene.methods.size(); ++m)
    set_times((*times)[m + 1], m < kOwn.size() ? 0 : skinning_us, scene.methods[m]);
  return scene;
}

}  // namespace pelt::tools
