/// The fuzz target of steps and searches: bytes -> an instruction set, and two bodies at both ends
/// of a step. Moving contacts are compared with all pairs of triangles, one by one. A search for
/// the contacts at the end of the step is read after any amounts of work, and compared with
/// `collide`.

#include "fuzz/fuzzed_bodies.hpp"
#include "fuzz/goal.hpp"
#include "motion/meeting_order.hpp"
#include "motion/moving_filter.hpp"
#include "support/require.hpp"

#include <pelt/config.hpp>
#include <pelt/motion.hpp>
#include <pelt/search.hpp>

#include <algorithm>
#include <limits>

namespace pelt::test {
namespace {

Goal moving_later("collide of motions: a contact after the start"),
    moving_at_start("collide of motions: a contact at the start"),
    moving_never("collide of motions: no contact"),
    first_of_several("first_contact: one of several contacts"),
    search_unknown("search: neither touching nor apart yet"),
    search_some("search: some of the contacts"), search_apart("search: no contact at the end"),
    search_all("search: all contacts at the end");

/// A body at the end of a step, with its pose at the start.
struct SteppingBody {
  FuzzedBody body;
  Pose from;
  std::vector<detail::MovingTriangle> triangles;

  pelt::Motion motion() { return {from, body.pose}; }
};

std::optional<SteppingBody> make_step(FuzzBytes& bytes) {
  std::optional<FuzzedBody> body = make_body(bytes);
  if (!body) return std::nullopt;
  Pose from(body->pose.model());
  require(static_cast<bool>(from.set_palette(body->palette)), "a valid palette is refused");
  require(static_cast<bool>(from.set_morph_weights(body->morph_weights)),
          "valid morph weights are refused");
  const auto first = body->all_corners();
  if (bytes.index(4) != 0) move_body(bytes, *body);
  const auto last = body->all_corners();
  SteppingBody step = {*std::move(body), std::move(from), {}};
  for (std::size_t t = 0; t < first.size(); ++t) step.triangles.push_back({first[t], last[t]});
  return step;
}

/// The expected answers.
struct Expected {
  std::vector<MovingContact> contacts;
  std::optional<MovingContact> first;

  Expected(const SteppingBody& a, const SteppingBody& b) {
    MovingStats work;
    std::optional<detail::MeetingPair> earliest;
    for (std::uint32_t i = 0; i < a.triangles.size(); ++i)
      for (std::uint32_t k = 0; k < b.triangles.size(); ++k) {
        const auto meeting = detail::find_first_meeting(a.triangles[i], b.triangles[k], work);
        if (!meeting) continue;
        contacts.push_back(detail::moving_contact({i, k}, *meeting));
        const detail::MeetingPair pair = {a.triangles[i], b.triangles[k], *meeting};
        if (earliest && !is_earlier(pair, *earliest)) continue;
        earliest = pair;
        first = contacts.back();
      }
  }

 private:
  static bool is_earlier(const detail::MeetingPair& p, const detail::MeetingPair& q) {
    if (p.first.at_start || q.first.at_start) return p.first.at_start && !q.first.at_start;
    return detail::compare_first_times(p, q) < 0;
  }
};

void check_moving(SteppingBody& a, SteppingBody& b, Scratch& scratch) {
  const Expected expected(a, b);
  std::vector<MovingContact> found;
  collide(a.motion(), b.motion(), scratch, found);
  require(found == expected.contacts, "collide of motions differs from the test of all pairs");
  require(intersects(a.motion(), b.motion(), scratch).answer == !found.empty(),
          "intersects of motions differs from the test of all pairs");
  std::optional<MovingContact> first;
  first_contact(a.motion(), b.motion(), scratch, first);
  require(first == expected.first, "first_contact differs from the test of all pairs");
  moving_never.reach(found.empty());
  first_of_several.reach(first && !first->at_start && found.size() > 1);
  for (const MovingContact& contact : found)
    (contact.at_start ? moving_at_start : moving_later).reach();
}

/// Checks what is known after some work. Returns the number of contacts.
std::size_t check_search(const CollisionSearch& search, const std::vector<Contact>& all) {
  std::vector<Contact> found(search.contacts().begin(), search.contacts().end());
  std::sort(found.begin(), found.end());
  require(std::includes(all.begin(), all.end(), found.begin(), found.end()),
          "a search has a contact that collide does not find");
  require(search.undecided_pairs() >= all.size() - found.size(), "a search loses contacts");
  const Verdict verdict = search.verdict();
  require(verdict != Verdict::touching || !all.empty(), "a search says wrongly touching");
  require(verdict != Verdict::apart || all.empty(), "a search says wrongly apart");
  search_unknown.reach(verdict == Verdict::unknown);
  search_some.reach(!found.empty() && found.size() < all.size());
  return found.size();
}

void search_in_slices(FuzzBytes& bytes, Pose& a, Pose& b, Scratch& scratch) {
  std::vector<Contact> all;
  collide(a, b, scratch, all);
  CollisionSearch search(a, b, static_cast<SearchOrder>(bytes.index(3)));
  std::uint64_t undecided = std::numeric_limits<std::uint64_t>::max();
  double bound = std::numeric_limits<double>::infinity();
  while (!search.is_complete()) {
    const std::uint64_t slice = bytes.is_empty() ? 1'000'000 : 1 + bytes.next();
    search.advance(slice, scratch);
    check_search(search, all);
    require(search.undecided_pairs() <= undecided, "a search has more undecided pairs than before");
    require(search.distance_bound() <= bound, "the distance bound of a search rises");
    undecided = search.undecided_pairs();
    bound = search.distance_bound();
  }
  require(check_search(search, all) == all.size(), "a complete search lacks contacts");
  (all.empty() ? search_apart : search_all).reach();
}

void check(FuzzBytes& bytes) {
  const auto sets = available_instruction_sets();
  set_active_instruction_set(sets[bytes.index(static_cast<std::uint32_t>(sets.size()))]);
  std::optional<SteppingBody> a = make_step(bytes), b = make_step(bytes);
  if (!a || !b) return;
  Scratch scratch;
  constexpr std::size_t kMostPairs = 16;  // each may take milliseconds, four times
  if (a->triangles.size() * b->triangles.size() <= kMostPairs) check_moving(*a, *b, scratch);
  search_in_slices(bytes, a->body.pose, b->body.pose, scratch);
}

}  // namespace
}  // namespace pelt::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  pelt::test::FuzzBytes bytes(std::span(data, size));
  pelt::test::check(bytes);
  return 0;
}
