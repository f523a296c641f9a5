/// Contacts of two poses: on demand, eagerly, within a tolerance, and by a search that can be
/// stopped, read and resumed.

#include <pelt/distance.hpp>
#include <pelt/search.hpp>

#include "bindings/wasm/engine/export.hpp"
#include "bindings/wasm/engine/handles.hpp"
#include "collide/eager.hpp"
#include "model/model.hpp"
#include "pose/pose.hpp"

#include <limits>

namespace pelt::wasm {
namespace {

std::vector<Contact>& found_pairs() {
  static std::vector<Contact> found;
  return found;
}

void answer_found(const PoseHandle& a, const PoseHandle& b) {
  answer_pairs(found_pairs(), a.body.first_triangle, b.body.first_triangle);
}

/// JavaScript owns the poses. After it has deleted one, it calls nothing but delete_search.
struct SearchHandle {
  CollisionSearch search;
  std::uint32_t first_a, first_b;  ///< the first triangles' numbers in the characters
};

/// Calls a member function of the search that has no parameters.
template <auto kMember>
auto of_search(const SearchHandle& handle) {
  return (handle.search.*kMember)();
}

std::uint64_t whole_number_of(double work) {
  constexpr double kMost = 9007199254740992;  // 2^53
  return work < kMost ? static_cast<std::uint64_t>(work)
                      : std::numeric_limits<std::uint64_t>::max();
}

}  // namespace

void answer_pairs(std::vector<Contact>& pairs, std::uint32_t first_a, std::uint32_t first_b) {
  for (Contact& contact : pairs) {
    contact.triangle_a += first_a;
    contact.triangle_b += first_b;
  }
  answer_arrays(pairs);
}

QueryStats collide(PoseHandle& a, PoseHandle& b, std::uint32_t most) {
  found_pairs().clear();
  const QueryStats stats = collide(a.pose, b.pose, scratch(), found_pairs(), {most});
  answer_found(a, b);
  return stats;
}
PELT_EXPORT(collide)

/// Copies the pose to the eager pose, and skins all of it.
QueryStats open_all(PoseHandle& handle) {
  if (!handle.eager) handle.eager.emplace(handle.pose.model().detail().tree);
  handle.eager->copy(handle.pose.detail());
  handle.is_refitted = true;
  return handle.eager->open_all();
}
PELT_EXPORT(open_all)

QueryStats collide_eagerly(PoseHandle& a, PoseHandle& b, std::uint32_t most) {
  found_pairs().clear();
  QueryStats stats;
  for (PoseHandle* handle : {&a, &b})
    if (!handle->is_refitted) stats += open_all(*handle);
  stats += detail::collide(*a.eager, *b.eager, scratch().detail(), found_pairs(), {most});
  answer_found(a, b);
  return stats;
}
PELT_EXPORT(collide_eagerly)

YesNo intersects(PoseHandle& a, PoseHandle& b) { return intersects(a.pose, b.pose, scratch()); }
PELT_EXPORT(intersects)

QueryStats clearance(PoseHandle& a, PoseHandle& b, double tolerance, std::uint32_t most) {
  found_pairs().clear();
  const QueryStats stats = clearance(a.pose, b.pose, tolerance, scratch(), found_pairs(), {most});
  answer_found(a, b);
  return stats;
}
PELT_EXPORT(clearance)

YesNo is_within(PoseHandle& a, PoseHandle& b, double tolerance) {
  return is_within(a.pose, b.pose, tolerance, scratch());
}
PELT_EXPORT(is_within)

/// Precondition: the poses are different.
SearchHandle* make_search(PoseHandle& a, PoseHandle& b, SearchOrder order, std::uint32_t max_open) {
  return new SearchHandle{CollisionSearch(a.pose, b.pose, order, max_open), a.body.first_triangle,
                          b.body.first_triangle};
}
PELT_EXPORT(make_search)

void delete_search(SearchHandle* handle) { delete handle; }
PELT_EXPORT(delete_search)

void restart_search(SearchHandle& handle) { handle.search.restart(); }
PELT_EXPORT(restart_search)

/// Precondition: the search is not stale. From 2^53 on, `work` is unlimited.
QueryStats run_search(SearchHandle& handle, double work) {
  return handle.search.advance(whole_number_of(work), scratch());
}
PELT_EXPORT(run_search)

void search_contacts(const SearchHandle& handle) {
  const auto contacts = handle.search.contacts();
  found_pairs().assign(contacts.begin(), contacts.end());
  answer_pairs(found_pairs(), handle.first_a, handle.first_b);
}
PELT_EXPORT(search_contacts)

/// Answers with the boxes, depths and numbers of pairs.
void search_regions(const SearchHandle& handle) {
  static std::vector<OpenRegion> regions;
  static std::vector<float> boxes, depths;
  static std::vector<double> counts;
  regions.clear(), boxes.clear(), depths.clear(), counts.clear();
  handle.search.open_regions(regions);
  for (const auto& [box, depth, pairs] : regions) {
    const auto& [low, high] = box;
    boxes.insert(boxes.end(), {low.x, low.y, low.z, high.x, high.y, high.z});
    depths.push_back(static_cast<float>(depth));
    counts.push_back(static_cast<double>(pairs));
  }
  answer_arrays(boxes, depths, counts);
}
PELT_EXPORT(search_regions)

PELT_EXPORT_AS(search_is_stale, of_search<&CollisionSearch::is_stale>)
PELT_EXPORT_AS(search_is_complete, of_search<&CollisionSearch::is_complete>)
PELT_EXPORT_AS(search_verdict, of_search<&CollisionSearch::verdict>)
PELT_EXPORT_AS(search_undecided_pairs, of_search<&CollisionSearch::undecided_pairs>)
PELT_EXPORT_AS(search_resolution, of_search<&CollisionSearch::resolution>)
PELT_EXPORT_AS(search_distance_bound, of_search<&CollisionSearch::distance_bound>)
PELT_EXPORT_AS(search_work_done, of_search<&CollisionSearch::work_done>)
PELT_EXPORT_AS(search_longest_step, of_search<&CollisionSearch::longest_step>)

}  // namespace pelt::wasm
