#pragma once

/// The answers of a check for one frame and for one step. Answers do not depend on each other, so
/// frames can be queried in any order, on any thread and in any process.

#include <pelt/inside.hpp>
#include <pelt/motion.hpp>
#include <pelt/query.hpp>
#include <pelt/search.hpp>
#include <pelt/self_filter.hpp>

#include "tools/pelt/scene/frame_contacts.hpp"

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

namespace pelt::tools::check {

/// Two colliders whose contacts are not all known.
struct Undecided {
  std::uint32_t a = 0, b = 0;
  pelt::Verdict verdict = pelt::Verdict::unknown;  ///< or touching
  std::uint64_t pairs = 0;                         ///< undecided pairs of triangles
  double resolution = 0;      ///< longest side of the regions of missing contacts
  double distance_bound = 0;  ///< upper bound of the distance
};

/// Two colliders that penetrate each other, or one of which contains the other.
struct InsidePair {
  std::uint32_t a = 0, b = 0;
  Containment containment = Containment::none;
  Penetration a_in_b = {}, b_in_a = {};  ///< for closed surfaces; triangle numbers of the model
};

/// A patch of described contacts, without its contacts.
struct DescribedPatch {
  std::uint32_t a = 0, b = 0;              ///< colliders
  std::uint32_t joint_a = 0, joint_b = 0;  ///< as in the assets
  float length = 0;                        ///< see `ContactPatch::length`
};

/// When two triangles first touch in a step, and which of their parts meet.
struct FirstTouch {
  double seconds = 0;  ///< time of the scene, as of its frames
  double share = 0;    ///< of the step that has passed, 0 to 1
  Feature a, b;
};

/// A pair of triangles that touches within a step and not at the start of a piece of it.
struct FoundInStep {
  std::uint32_t a = 0, b = 0;  ///< colliders
  Contact contact;             ///< triangle numbers of the assets
  FirstTouch first;
};

/// The largest distance of a posed vertex, at the middle of a piece of a step, from the middle of
/// its posed positions at both ends of the piece. Both kinds of positions are those of float32
/// skinning.
struct Deviation {
  double distance = 0;
  std::uint32_t collider = 0, vertex = 0;  ///< vertex of the collider's own model
  std::uint32_t from = 0, to = 0;          ///< frames of the step
};

/// The answer for a step from one checked frame to the next.
struct StepAnswer {
  std::uint32_t from = 0, to = 0;  ///< frames
  std::vector<FoundInStep> found;  ///< ascending by colliders and triangles, without duplicates
  Deviation deviation;             ///< of the clips from straight lines
  QueryStats work;
  double seconds = 0;  ///< setting palettes and querying, without sampling
};

struct FrameAnswer {
  std::uint32_t frame = 0;
  scene::FrameContacts found;           ///< the contacts that count
  std::uint64_t ignored = 0;            ///< contacts that do not count
  LeftOut left_out;                     ///< contacts of bodies with themselves that do not count
  std::vector<Undecided> undecided;     ///< with --budget
  std::vector<InsidePair> inside;       ///< with --inside
  std::vector<DescribedPatch> patches;  ///< with --contacts
  std::optional<StepAnswer> step;       ///< with --between: the step that ends with the frame
  std::string line;                     ///< of --jsonl, without the end of the line
  QueryStats work;                      ///< without that of the step
  double seconds = 0;  ///< setting palettes and querying contacts, without sampling
};

/// A type, or the constant type.
template <typename T, typename Type>
concept Like = std::same_as<std::remove_const_t<T>, Type>;

/// The descriptions of the parts of an answer, which all readers and writers share. Each calls a
/// function of `visit` for each member, in order, with its name and with what its value must be:
///
///     count       any whole number              collider  a collider
///     choice      one of an enumeration         joint     a joint of a collider
///     length      a finite number, at least 0   vertex    a vertex of a collider
///     below       a number below another one    triangle  a triangle of a collider
///     same        what a reader expects         require   a condition of other members
///     member      a part, a list or an optional part
template <typename Visit, Like<QueryStats> Work>
void describe(Visit& visit, Work& work) {
  visit.count("node_pairs", work.node_pairs);
  visit.count("refits", work.refits);
  visit.count("posed_vertices", work.posed_vertices);
  visit.count("triangle_pairs", work.triangle_pairs);
  visit.count("displacements", work.displacements);
}

template <typename Visit, Like<LeftOut> Counts>
void describe(Visit& visit, Counts& left_out) {
  visit.count("takes_part", left_out.takes_part);
  visit.count("rings", left_out.rings);
  visit.count("at_rest", left_out.at_rest);
  visit.count("always", left_out.always);
  visit.count("near_joints", left_out.joints);
  visit.count("groups", left_out.groups);
}

inline constexpr const char* kVerdictNames[] = {"apart", "touching", "unknown"};

template <typename Visit, Like<Undecided> Pair>
void describe(Visit& visit, Pair& pair) {
  visit.collider("a", pair.a);
  visit.collider("b", pair.b);
  visit.choice("verdict", pair.verdict, kVerdictNames);
  visit.count("pairs", pair.pairs);
  visit.length("resolution", pair.resolution);
  visit.length("distance_bound", pair.distance_bound);
}

inline constexpr const char* kContainmentNames[] = {"none", "a", "b"};

template <typename Visit, Like<InsidePair> Pair>
void describe(Visit& visit, Pair& pair) {
  visit.collider("a", pair.a);
  visit.collider("b", pair.b);
  visit.choice("held", pair.containment, kContainmentNames);
  visit.length("a_in_b", pair.a_in_b.depth);
  visit.length("b_in_a", pair.b_in_a.depth);
  visit.require(pair.a < pair.b);
}

template <typename Visit, Like<DescribedPatch> Patch>
void describe(Visit& visit, Patch& patch) {
  visit.collider("a", patch.a);
  visit.collider("b", patch.b);
  visit.joint("joint_a", patch.joint_a, patch.a);
  visit.joint("joint_b", patch.joint_b, patch.b);
  visit.length("length", patch.length);
}

inline constexpr const char* kFeatureNames[] = {"corner", "edge", "face"};

template <typename Visit, Like<FoundInStep> Found>
void describe(Visit& visit, Found& found) {
  visit.collider("a", found.a);
  visit.collider("b", found.b);
  visit.triangle("triangle_a", found.contact.triangle_a, found.a);
  visit.triangle("triangle_b", found.contact.triangle_b, found.b);
  visit.length("seconds", found.first.seconds);
  visit.length("share", found.first.share);
  visit.choice("kind_a", found.first.a.kind, kFeatureNames);
  visit.below("number_a", found.first.a.number, 3);
  visit.choice("kind_b", found.first.b.kind, kFeatureNames);
  visit.below("number_b", found.first.b.number, 3);
  visit.require(found.a <= found.b);
}

template <typename Visit, Like<Deviation> Most>
void describe(Visit& visit, Most& deviation) {
  visit.length("distance", deviation.distance);
  visit.collider("collider", deviation.collider);
  visit.vertex("vertex", deviation.vertex, deviation.collider);
}

/// Whether the contacts of a step ascend by colliders and triangles, without duplicates.
inline bool are_ascending(const std::vector<FoundInStep>& found) {
  const auto key = [](const FoundInStep& f) { return std::tie(f.a, f.b, f.contact); };
  return std::adjacent_find(found.begin(), found.end(), [&](const auto& x, const auto& y) {
           return !(key(x) < key(y));
         }) == found.end();
}

template <typename Visit, Like<StepAnswer> Step>
void describe(Visit& visit, Step& step) {
  visit.same("from", step.from);
  visit.member("found", step.found);
  visit.require(are_ascending(step.found));
  visit.member("deviation", step.deviation);
  visit.member("work", step.work);
  visit.length("seconds", step.seconds);
}

/// All of an answer but its contacts and its line.
template <typename Visit, Like<FrameAnswer> Answer>
void describe(Visit& visit, Answer& answer) {
  visit.same("frame", answer.frame);
  visit.count("ignored", answer.ignored);
  visit.member("left_out", answer.left_out);
  visit.member("undecided", answer.undecided);
  visit.member("inside", answer.inside);
  visit.member("patches", answer.patches);
  visit.member("step", answer.step);
  visit.member("work", answer.work);
  visit.length("seconds", answer.seconds);
}

/// Passes all members to `add(name, value)` of `Writer`, which derives from this. Parts and choices
/// are for the writer.
template <typename Writer>
class MemberWriter {
 public:
  template <typename T>
  void count(const char* name, T value) {
    self().add(name, value);
  }
  template <typename T>
  void length(const char* name, T value) {
    self().add(name, value);
  }
  template <typename T>
  void below(const char* name, T value, std::uint64_t) {
    self().add(name, value);
  }
  void same(const char* name, std::uint32_t value) { self().add(name, value); }
  void collider(const char* name, std::uint32_t value) { self().add(name, value); }
  void joint(const char* name, std::uint32_t value, std::uint32_t) { self().add(name, value); }
  void vertex(const char* name, std::uint32_t value, std::uint32_t) { self().add(name, value); }
  void triangle(const char* name, std::uint32_t value, std::uint32_t) { self().add(name, value); }
  void require(bool) {}

 private:
  Writer& self() { return static_cast<Writer&>(*this); }
};

}  // namespace pelt::tools::check
