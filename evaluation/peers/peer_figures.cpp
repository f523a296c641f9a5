#include "evaluation/peers/peer_figures.hpp"

#include "evaluation/bench/bench.hpp"
#include "evaluation/bench/csv.hpp"
#include "evaluation/methods/lab_methods.hpp"
#include "evaluation/peers/peers.hpp"
#include "text/format.hpp"
#include "tools/pelt/methods/command_methods.hpp"

#include <algorithm>
#include <array>
#include <functional>

namespace pelt::peers {
namespace {

std::vector<Contact> as_set(std::span<const Contact> contacts) {
  std::vector<Contact> set(contacts.begin(), contacts.end());
  std::sort(set.begin(), set.end());
  set.erase(std::unique(set.begin(), set.end()), set.end());
  return set;
}

/// Number of contacts of `a` that `b` does not contain. Precondition: both are sets.
std::size_t count_only_in(const std::vector<Contact>& a, const std::vector<Contact>& b) {
  return static_cast<std::size_t>(std::count_if(a.begin(), a.end(), [&](const Contact& contact) {
    return !std::binary_search(b.begin(), b.end(), contact);
  }));
}

}  // namespace

Difference& Difference::operator+=(const Difference& other) {
  missing += other.missing;
  extra += other.extra;
  repeated += other.repeated;
  return *this;
}

Difference compare(std::span<const Contact> answer, std::span<const Contact> exact) {
  const std::vector<Contact> ours = as_set(answer), theirs = as_set(exact);
  return {count_only_in(theirs, ours), count_only_in(ours, theirs), answer.size() - ours.size()};
}

namespace {

/// The contact of these triangles, or null.
const MovingContact* find(std::span<const MovingContact> contacts, const Contact& contact) {
  const auto place = std::lower_bound(
      contacts.begin(), contacts.end(), contact,
      [](const MovingContact& moving, const Contact& key) { return moving.contact < key; });
  return place != contacts.end() && place->contact == contact ? &*place : nullptr;
}

}  // namespace

MovingDifference& MovingDifference::operator+=(const MovingDifference& other) {
  missing_at_start += other.missing_at_start;
  missing_later += other.missing_later;
  extra += other.extra;
  early += other.early;
  late += other.late;
  return *this;
}

MovingDifference compare_moving(std::span<const MovingContact> answer,
                                std::span<const MovingContact> exact) {
  MovingDifference difference;
  for (const MovingContact& contact : answer)
    difference.extra += find(exact, contact.contact) == nullptr;
  for (const MovingContact& contact : exact) {
    const MovingContact* const found = find(answer, contact.contact);
    if (found == nullptr) {
      ++(contact.at_start ? difference.missing_at_start : difference.missing_later);
    } else if (!contact.at_start) {
      difference.early += found->time < contact.time - kTimeTolerance;
      difference.late += found->time > contact.time + kTimeTolerance;
    }
  }
  return difference;
}

}  // namespace pelt::peers

namespace pelt::tools {
namespace {

using bench::BenchMethod;
using bench::in_frame;
using bench::method_of;
using bench::Question;
using bench::Row;
using bench::Runner;
using bench::self_method;
using bench::Subject;
using bench::Times;
using bench::Variant;
using peers::Peer;
using scene::Collider;
using scene::FrameContacts;
using scene::Palettes;

class SkinningOnly final : public rivals::PosedMeshMethod {
 public:
  void add(std::span<const Triangle>, std::span<const Vec3>) override {}
  void update(std::uint32_t, std::span<const Vec3>) override {}
  QueryStats collide(std::uint32_t, std::uint32_t, std::vector<Contact>&, std::uint32_t) override {
    return {};
  }
};

Contestant of_peer(const Peer& peer, BenchMethod method) {
  return {std::move(method), std::string(peer.name), peer.version, std::string(peer.update),
          peer.narrow_phase == peers::NarrowPhase::ours ? "ours" : "its own"};
}

std::vector<Contestant> contestants_in_pairs() {
  std::vector<Contestant> all = {
      {method_of(methods::kOnDemand), "pelt on_demand", "", "palettes", "ours", true},
      {method_of(methods::kEager), "pelt eager", "", "skin, refit", "ours", true}};
  for (const Peer& peer : peers::all_peers())
    all.push_back(of_peer(peer, lab::rival_method(std::string(peer.name), [name = peer.name] {
                            return peers::make_peer(name);
                          })));
  return all;
}

std::vector<Contestant> contestants_by_themselves() {
  std::vector<Contestant> all = {
      {self_method(methods::kSelf), "pelt self", "", "palettes", "ours", true},
      {self_method(lab::kSelfEager), "pelt eager", "", "skin, refit", "ours", true}};
  for (const Peer& peer : peers::all_self_peers())
    all.push_back(of_peer(peer, lab::self_rival_method(std::string(peer.name), [name = peer.name] {
                            return peers::make_self_peer(name);
                          })));
  return all;
}

}  // namespace

std::vector<Contestant> contestants(Contest contest) {
  return contest == Contest::self ? contestants_by_themselves() : contestants_in_pairs();
}

BenchMethod skinning_method() {
  return lab::rival_method("skinning", [] { return std::make_unique<SkinningOnly>(); });
}

BenchMethod exact_method(Contest contest) {
  return contest == Contest::self ? self_method(methods::kSelfBrute) : method_of(methods::kBrute);
}

namespace {

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

Row row_of(const ScenePeers& scene, const PeerFigures& of) {
  return {{"scene", scene.scene},
          {"triangles", scene.triangles},
          {"frames", scene.frames},
          {"frames_in_contact", scene.frames_in_contact},
          {"contacts", scene.contacts},
          {"repetitions", scene.repetitions},
          {"method", of.method},
          {"version", of.version},
          {"update", of.update},
          {"narrow_phase", of.narrow_phase},
          {"skinning_us", of.skinning_us},
          {"update_us", of.update_us},
          {"query_all_us", of.all_us},
          {"query_first_us", of.first_us},
          {"frame_all_us", of.frame_us},
          {"frame_first_us", of.first_frame_us},
          {"of_pelt", cost_over_pelt(scene, of)},
          {"missing", of.difference.missing},
          {"extra", of.difference.extra},
          {"repeated", of.difference.repeated}};
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
  constexpr bench::Column kColumns[] = {
      {"method", "method"},        {"update", "for each pose"}, {"narrow_phase", "narrow phase"},
      {"skinning_us", "skinning"}, {"update_us", "update"},     {"query_all_us", "all"},
      {"query_first_us", "first"}, {"frame_all_us", "frame"},   {"frame_first_us", "to first"},
      {"of_pelt", "of pelt's"},    {"missing", "missing"},      {"extra", "extra"}};
  std::vector<Row> rows;
  for (const PeerFigures& figures : scene.methods) rows.push_back(row_of(scene, figures));
  bench::print_table(kColumns, rows, out, {18, 14});
  out << '\n';
}

void write_peers_csv(std::span<const ScenePeers> scenes, std::ostream& out) {
  lab::CsvWriter csv(out);
  for (const ScenePeers& scene : scenes)
    for (const PeerFigures& figures : scene.methods) csv.write(row_of(scene, figures));
}

}  // namespace pelt::tools
