/// The promises of a search after any amount of work, against brute force.

#include <pelt/distance.hpp>
#include <pelt/search.hpp>

#include "collide/search.hpp"
#include "collide/search_bodies.hpp"
#include "model/triangle_places.hpp"
#include "support/brute_force.hpp"
#include "support/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace pelt {
namespace {

using test::kAllOrders;
using test::Random;
using test::SearchBodies;

/// For each node, the slot of its parent that holds it.
class Ancestors {
 public:
  explicit Ancestors(const detail::Tree& tree) : tree_(tree), parent_(tree.nodes.size(), 0) {
    for (std::uint32_t n = 0; n < tree.nodes.size(); ++n)
      for (std::uint32_t c = 0; c < tree.nodes[n].child_count; ++c)
        parent_[tree.nodes[n].first_child + c] = n;
  }

  /// Whether a triangle is below one of these slots.
  bool is_below(std::uint32_t triangle, std::uint32_t node, unsigned slots) const {
    const std::uint32_t place = tree_.triangle_places[triangle];
    std::uint32_t at = node_of_triangle(tree_, place);
    std::uint32_t slot = slot_of_triangle(tree_, tree_.nodes[at], place);
    while (at != node && at != 0) {
      const std::uint32_t parent = parent_[at];
      slot = tree_.nodes[parent].cluster_count + at - tree_.nodes[parent].first_child;
      at = parent;
    }
    return at == node && (slots >> slot & 1) != 0;
  }

 private:
  const detail::Tree& tree_;
  std::vector<std::uint32_t> parent_;
};

struct Corners {
  Vec3 low, high;
};

Corners unbounded() {
  constexpr float kMost = std::numeric_limits<float>::infinity();
  return {{-kMost, -kMost, -kMost}, {kMost, kMost, kMost}};
}

void cut(Corners& box, const Vec3& low, const Vec3& high) {
  box.low = {std::max(box.low.x, low.x), std::max(box.low.y, low.y), std::max(box.low.z, low.z)};
  box.high = {std::min(box.high.x, high.x), std::min(box.high.y, high.y),
              std::min(box.high.z, high.z)};
}

bool is_empty(const Corners& box) {
  return !(box.low.x <= box.high.x && box.low.y <= box.high.y && box.low.z <= box.high.z);
}

bool contains(const Box& outer, const Box& inner) {
  return outer.low.x <= inner.low.x && outer.low.y <= inner.low.y && outer.low.z <= inner.low.z &&
         inner.high.x <= outer.high.x && inner.high.y <= outer.high.y &&
         inner.high.z <= outer.high.z;
}

/// The true answer for two posed bodies.
class Truth {
 public:
  explicit Truth(SearchBodies& bodies)
      : bodies_(bodies),
        contacts(test::brute_force(bodies.shape_a, bodies.a, bodies.shape_b, bodies.b)),
        ancestors_a_(bodies.a.model().detail().tree),
        ancestors_b_(bodies.b.model().detail().tree),
        positions_a_(bodies.shape_a.rest_positions.size()),
        positions_b_(bodies.shape_b.rest_positions.size()) {
    posed_vertices(bodies.a, positions_a_);
    posed_vertices(bodies.b, positions_b_);
    Distance closest;
    distance(bodies.a, bodies.b, bodies.scratch, closest);
    gap = closest.distance;
  }

  /// Whether an open item has the pair in its product, and its region meets the boxes of both
  /// triangles.
  bool is_open(const detail::SearchState& state, const Contact& contact) const {
    bool is_open = false;
    each_open(state.items, [&](const detail::OpenItem& item) {
      if (!ancestors_a_.is_below(contact.triangle_a, item.node_a, item.slots_a) ||
          !ancestors_b_.is_below(contact.triangle_b, item.node_b, item.slots_b))
        return;
      Corners box = unbounded();
      cut_with(box, bodies_.shape_a.triangles[contact.triangle_a], positions_a_);
      cut_with(box, bodies_.shape_b.triangles[contact.triangle_b], positions_b_);
      cut(box, {item.low[0], item.low[1], item.low[2]}, {item.high[0], item.high[1], item.high[2]});
      is_open = is_open || !is_empty(box);
    });
    return is_open;
  }

 private:
  static void cut_with(Corners& box, const Triangle& triangle, const std::vector<Vec3>& positions) {
    Vec3 low = positions[triangle[0]], high = low;
    for (const std::uint32_t v : {triangle[1], triangle[2]}) {
      const Vec3& p = positions[v];
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    cut(box, low, high);
  }

  SearchBodies& bodies_;

 public:
  std::vector<Contact> contacts;
  double gap = 0;

 private:
  Ancestors ancestors_a_, ancestors_b_;
  std::vector<Vec3> positions_a_, positions_b_;
};

/// Compares a search with the truth and with its own earlier state.
class Ladder {
 public:
  Ladder(SearchBodies& bodies, const Truth& truth, const CollisionSearch& search)
      : bodies_(bodies), truth_(truth), search_(search) {
    search_.open_regions(regions_);
  }

  void check_rung() {
    check_contacts();
    check_regions();
    check_numbers();
  }

  void check_end() const {
    const std::vector<Contact> contacts(search_.contacts().begin(), search_.contacts().end());
    ASSERT_EQ(contacts, truth_.contacts);
    ASSERT_EQ(contacts, test::contacts_of(bodies_.a, bodies_.b, bodies_.scratch));
    EXPECT_EQ(search_.verdict(), contacts.empty() ? Verdict::apart : Verdict::touching);
    EXPECT_EQ(search_.undecided_pairs(), 0u);
    EXPECT_EQ(search_.resolution(), 0);
  }

  std::size_t missing = 0;  ///< contacts that were not found yet, at all rungs

 private:
  void check_contacts() {
    const std::set<Contact> found(search_.contacts().begin(), search_.contacts().end());
    ASSERT_EQ(found.size(), search_.contacts().size());
    ASSERT_TRUE(
        std::includes(truth_.contacts.begin(), truth_.contacts.end(), found.begin(), found.end()));
    ASSERT_TRUE(std::includes(found.begin(), found.end(), found_.begin(), found_.end()));
    for (const Contact& contact : truth_.contacts)
      if (!found.contains(contact)) {
        ASSERT_TRUE(truth_.is_open(search_.detail().state, contact));
        ++missing;
      }
    if (!found.empty()) {
      ASSERT_EQ(search_.verdict(), Verdict::touching);
    } else if (!search_.is_complete()) {
      ASSERT_EQ(search_.verdict(), Verdict::unknown);
    }
    found_ = found;
  }

  /// Each region is inside a former one, and the counts are those of the regions.
  void check_regions() {
    std::vector<OpenRegion> regions;
    search_.open_regions(regions);
    std::uint64_t pairs = 0;
    double longest = 0;
    for (const OpenRegion& open : regions) {
      ASSERT_TRUE(std::any_of(regions_.begin(), regions_.end(), [&](const OpenRegion& former) {
        return contains(former.region, open.region) && open.pairs <= former.pairs;
      }));
      const Box& box = open.region;
      for (const double side : {double{box.high.x} - box.low.x, double{box.high.y} - box.low.y,
                                double{box.high.z} - box.low.z}) {
        ASSERT_GE(side, 0);
        longest = std::max(longest, side);
      }
      ASSERT_GE(open.depth, 0);
      ASSERT_GT(open.pairs, 0u);
      pairs += open.pairs;
    }
    ASSERT_EQ(pairs, search_.undecided_pairs());
    ASSERT_EQ(longest, search_.resolution());
    regions_ = regions;
  }

  void check_numbers() {
    ASSERT_LE(search_.undecided_pairs(), undecided_);
    ASSERT_LE(search_.resolution(), resolution_);
    ASSERT_LE(search_.distance_bound(), bound_);
    ASSERT_GE(search_.distance_bound(), search_.contacts().empty() ? truth_.gap : 0);
    ASSERT_EQ(search_.distance_bound() == 0, !search_.contacts().empty());
    undecided_ = search_.undecided_pairs();
    resolution_ = search_.resolution();
    bound_ = search_.distance_bound();
  }

  SearchBodies& bodies_;
  const Truth& truth_;
  const CollisionSearch& search_;
  std::set<Contact> found_;
  std::vector<OpenRegion> regions_;
  std::uint64_t undecided_ = UINT64_MAX;
  double resolution_ = HUGE_VAL, bound_ = HUGE_VAL;
};

TEST(SearchPromises, HoldAfterAnyAmountOfWork) {
  Random random(600);
  std::size_t missing = 0, rungs = 0, touching = 0, apart = 0;
  test::for_search_bodies(random, 12, 130, [&](SearchBodies& bodies) {
    const Truth truth(bodies);
    ++(truth.contacts.empty() ? apart : touching);
    for (const SearchOrder order : kAllOrders)
      for (const std::uint32_t max_open : {CollisionSearch::kMaxOpen, 3u}) {
        CollisionSearch search(bodies.a, bodies.b, order, max_open);
        Ladder ladder(bodies, truth, search);
        for (std::uint64_t work = 1; !search.is_complete(); work *= 2, ++rungs) {
          search.advance(work, bodies.scratch);
          ASSERT_NO_FATAL_FAILURE(ladder.check_rung());
        }
        ASSERT_NO_FATAL_FAILURE(ladder.check_end());
        missing += ladder.missing;
      }
  });
  EXPECT_GT(touching, 10u);
  EXPECT_GT(apart, 3u);
  EXPECT_GT(rungs, 500u);
  EXPECT_GT(missing, 10'000u);
}

/// Two parallel sheets, tilted so that their boxes overlap. One vertex pokes through, so that its
/// triangles are the only contacts, and each vertex is the one that pokes in turn.
TEST(SearchPromises, TheOnlyContactMayBeFoundLast) {
  constexpr std::uint32_t kCells = 12;
  SearchBodies sheets(test::make_sheet(kCells), test::make_sheet(kCells));
  const auto tilted = [](std::uint32_t x, std::uint32_t y) {
    return static_cast<float>(x + 2 * y);
  };
  const auto raised = [&](std::uint32_t x, std::uint32_t y) { return tilted(x, y) + 0.125f; };
  const std::vector<Vec3> below = test::sheet_positions(kCells, tilted);
  const std::vector<Vec3> above = test::sheet_positions(kCells, raised);
  double latest = 0;
  for (std::size_t poked = 1; poked < above.size(); poked += 2) {
    std::vector<Vec3> positions = above;
    positions[poked].z -= 0.25f;
    sheets.set(test::pin(below), test::pin(positions));
    const Truth truth(sheets);
    ASSERT_FALSE(truth.contacts.empty());
    for (const SearchOrder order : kAllOrders) {
      CollisionSearch search(sheets.a, sheets.b, order);
      Ladder ladder(sheets, truth, search);
      std::uint64_t last_unknown = 0;
      while (!search.is_complete()) {
        search.advance(150, sheets.scratch);
        if (search.verdict() == Verdict::unknown) last_unknown = search.work_done();
        ASSERT_NO_FATAL_FAILURE(ladder.check_rung());
      }
      ASSERT_NO_FATAL_FAILURE(ladder.check_end());
      latest = std::max(
          latest, static_cast<double>(last_unknown) / static_cast<double>(search.work_done()));
    }
  }
  EXPECT_GT(latest, 0.9);
}

}  // namespace
}  // namespace pelt
