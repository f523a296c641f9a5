#include "evaluation/peers/peer_figures.hpp"

#include <algorithm>
#include <array>

namespace pelt::tools {
namespace {

using bench::BenchMethod;
using bench::in_frame;
using bench::Question;
using bench::Runner;
using bench::Subject;
using bench::Times;
using bench::Variant;
using scene::Collider;
using scene::FrameContacts;
using scene::Palettes;

const std::array kVariants = {Variant{Question::all}, Variant{Question::first}};

/// Skinning alone, then the contestants.
std::vector<BenchMethod> all_methods(Contest contest) {
  std::vector<BenchMethod> methods = {skinning_method()};
  for (const Contestant& contestant : contestants(contest)) methods.push_back(contestant.method);
  return methods;
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
Result<void> compare_all(const Subject& subject, Contest contest,
                         const std::function<void()>& advance, ScenePeers& scene) {
  Runner exact(subject.colliders, exact_method(contest));
  std::vector<Runner> runners;
  for (const BenchMethod& method : all_methods(contest))
    runners.emplace_back(subject.colliders, method);
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
  figures.all_us = all.mean_query_us();
  figures.first_us = first.mean_query_us();
  figures.frame_us = all.mean_us;
  figures.first_frame_us = first.mean_us;
}

std::vector<PeerFigures> without_figures(std::span<const Contestant> contestants) {
  std::vector<PeerFigures> methods;
  for (const Contestant& of : contestants)
    methods.push_back({of.name, of.version, of.update, of.narrow_phase});
  return methods;
}

}  // namespace

double cost_over_pelt(const ScenePeers& scene, const PeerFigures& figures) {
  const double skinning_us = scene.contest == Contest::self ? figures.skinning_us : 0;
  return (figures.frame_us - skinning_us) / scene.methods[0].frame_us;
}

std::size_t peer_steps(std::size_t frames, Contest contest) {
  return frames * (all_methods(contest).size() + 1);
}

Result<ScenePeers> measure_peers(const Subject& subject, std::uint32_t repetitions,
                                 const std::function<void()>& advance, Contest contest) {
  const std::vector<Contestant> all = contestants(contest);
  ScenePeers scene;
  scene.contest = contest;
  scene.scene = subject.scene.name;
  for (const Collider& collider : subject.colliders)
    scene.triangles += collider.model.triangle_count();
  scene.frames = subject.frames.size();
  scene.repetitions = repetitions;
  scene.methods = without_figures(all);
  if (const auto compared = compare_all(subject, contest, advance, scene); !compared)
    return compared.error();
  const auto times = bench::measure(subject, all_methods(contest), kVariants, repetitions, advance);
  if (!times) return times.error();
  const double skinning_us = (*times)[0][0].mean_update_us;
  for (std::size_t m = 0; m < scene.methods.size(); ++m)
    set_times((*times)[m + 1], all[m].is_ours ? 0 : skinning_us, scene.methods[m]);
  return scene;
}

}  // namespace pelt::tools
