#include "evaluation/peers/peer_figures.hpp"

#include "evaluation/methods/lab_methods.hpp"
#include "evaluation/methods/posed_mesh_adapter.hpp"
#include "evaluation/peers/peers.hpp"
#include "text/format.hpp"
#include "tools/pelt/methods/command_methods.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <iomanip>

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

namespace {

constexpr int kName = 18, kWord = 13, kColumn = 12;

void print_head(std::ostream& out) {
  out << std::left << std::setw(kName) << "method" << std::setw(kWord) << "update"
      << std::setw(kWord) << "narrow phase" << std::right;
  for (const char* head :
       {"skinning", "update", "all", "first", "frame", "to first", "of pelt's", "missing", "extra"})
    out << std::setw(kColumn) << head;
  out << '\n';
}

void print_row(const ScenePeers& scene, const PeerFigures& figures, std::ostream& out) {
  out << std::left << std::setw(kName) << figures.method << std::setw(kWord) << figures.update
      << std::setw(kWord) << figures.narrow_phase << std::right;
  for (const double time : {figures.skinning_us, figures.update_us, figures.all_us,
                            figures.first_us, figures.frame_us, figures.first_frame_us})
    out << std::setw(kColumn) << text::fixed(time, 1);
  out << std::setw(kColumn) << text::fixed(cost_over_pelt(scene, figures), 1);
  for (const std::size_t count : {figures.difference.missing, figures.difference.extra})
    out << std::setw(kColumn) << text::with_commas(count);
  out << '\n';
}

}  // namespace

void print_peers(const ScenePeers& scene, std::ostream& out) {
  out << scene.scene << ": " << text::with_commas(scene.triangles) << " triangles, "
      << text::counted(scene.frames, "frame") << " of which " << scene.frames_in_contact
      << " in contact, " << text::with_commas(scene.contacts) << " contacts in all\n"
      << "microseconds a frame on one thread, medians of " << scene.repetitions
      << ", means over the frames; less is better"
      << (scene.contest == Contest::self ? "; \"of pelt's\" without the skinning of others\n"
                                         : "\n");
  print_head(out);
  for (const PeerFigures& figures : scene.methods) print_row(scene, figures, out);
  out << '\n';
}

void write_peers_csv(std::span<const ScenePeers> scenes, std::ostream& out) {
  out << "scene,triangles,frames,frames_in_contact,contacts,repetitions,method,version,update,"
         "narrow_phase,skinning_us,update_us,query_all_us,query_first_us,frame_all_us,"
         "frame_first_us,missing,extra,repeated\n";
  for (const ScenePeers& scene : scenes)
    for (const PeerFigures& figures : scene.methods)
      out << scene.scene << ',' << scene.triangles << ',' << scene.frames << ','
          << scene.frames_in_contact << ',' << scene.contacts << ',' << scene.repetitions << ','
          << figures.method << ',' << figures.version << ",\"" << figures.update << "\","
          << figures.narrow_phase << ',' << figures.skinning_us << ',' << figures.update_us << ','
          << figures.all_us << ',' << figures.first_us << ',' << figures.frame_us << ','
          << figures.first_frame_us << ',' << figures.difference.missing << ','
          << figures.difference.extra << ',' << figures.difference.repeated << '\n';
}

}  // namespace pelt::tools
