/// Searches for contacts that can be stopped, read and resumed.

#include <pelt/search.hpp>

#include "bindings/wasm/engine/answer.hpp"
#include "bindings/wasm/engine/handles.hpp"

#include <limits>

namespace pelt::wasm {
namespace {

/// JavaScript keeps the poses, and calls nothing but pelt_delete_search after one has been deleted.
struct SearchHandle {
  SearchHandle(PoseHandle& first, PoseHandle& second, SearchOrder order, std::uint32_t max_open)
      : search(first.pose, second.pose, order, max_open),
        first_a(first.body.first_triangle),
        first_b(second.body.first_triangle) {}

  CollisionSearch search;
  std::uint32_t first_a, first_b;  ///< the first triangles' numbers in the characters
  std::vector<Contact> contacts;   ///< read by JavaScript, like the next member
  std::vector<double> regions;     ///< [R][8] low, high, depth, pairs
};

std::uint64_t whole_number_of(double work) {
  constexpr double kMost = 9007199254740992;  // 2^53
  return work < kMost ? static_cast<std::uint64_t>(work)
                      : std::numeric_limits<std::uint64_t>::max();
}

}  // namespace

/// Precondition: the poses are different. `order` is a SearchOrder.
PELT_EXPORT std::uint32_t pelt_make_search(PoseHandle* a, PoseHandle* b, SearchOrder order,
                                           std::uint32_t max_open) {
  return address_of(new SearchHandle(*a, *b, order, max_open));
}

PELT_EXPORT void pelt_delete_search(SearchHandle* handle) { delete handle; }

PELT_EXPORT void pelt_restart_search(SearchHandle* handle) { handle->search.restart(); }

/// Precondition: the search is not stale. All work is granted from 2^53 on.
PELT_EXPORT void pelt_run_search(SearchHandle* handle, double work) {
  answer_stats(handle->search.advance(whole_number_of(work), scratch()));
}

PELT_EXPORT std::uint32_t pelt_search_is_stale(const SearchHandle* handle) {
  return handle->search.is_stale() ? 1 : 0;
}

PELT_EXPORT std::uint32_t pelt_search_is_complete(const SearchHandle* handle) {
  return handle->search.is_complete() ? 1 : 0;
}

PELT_EXPORT std::uint32_t pelt_search_verdict(const SearchHandle* handle) {
  return static_cast<std::uint32_t>(handle->search.verdict());
}

PELT_EXPORT void pelt_search_contacts(SearchHandle* handle) {
  handle->contacts.clear();
  for (const Contact& contact : handle->search.contacts())
    handle->contacts.push_back(
        {contact.triangle_a + handle->first_a, contact.triangle_b + handle->first_b});
  answer_data<Contact>(handle->contacts);
}

PELT_EXPORT void pelt_search_regions(SearchHandle* handle) {
  static std::vector<OpenRegion> regions;
  regions.clear();
  handle->search.open_regions(regions);
  handle->regions.clear();
  for (const auto& [box, depth, pairs] : regions)
    handle->regions.insert(handle->regions.end(),
                           {box.low.x, box.low.y, box.low.z, box.high.x, box.high.y, box.high.z,
                            depth, static_cast<double>(pairs)});
  answer_data<double>(handle->regions);
}

PELT_EXPORT double pelt_search_undecided_pairs(const SearchHandle* handle) {
  return static_cast<double>(handle->search.undecided_pairs());
}

PELT_EXPORT double pelt_search_resolution(const SearchHandle* handle) {
  return handle->search.resolution();
}

PELT_EXPORT double pelt_search_distance_bound(const SearchHandle* handle) {
  return handle->search.distance_bound();
}

PELT_EXPORT double pelt_search_work_done(const SearchHandle* handle) {
  return static_cast<double>(handle->search.work_done());
}

PELT_EXPORT double pelt_search_longest_step(const SearchHandle* handle) {
  return static_cast<double>(handle->search.longest_step());
}

}  // namespace pelt::wasm
