#include <pelt/search.hpp>

// Called by a solver: a time, 0 to 1, before which a step is certainly free of contact. More work
// gives a later time, up to the first contact.
float free_part(pelt::Motion a, pelt::Motion b, std::uint64_t work) {
  pelt::FirstContactSearch search(a, b);
  search.advance(work);
  return search.apart_until();
}

// Whether the motions touch before a time. Searches only as far as this question needs.
bool touch_before(pelt::Motion a, pelt::Motion b, float time) {
  pelt::FirstContactSearch search(a, b);
  const auto is_found = [&] { return search.earliest() && search.earliest()->time < time; };
  while (!search.is_complete() && search.apart_until() < time && !is_found())
    search.advance(20'000);
  return is_found();
}
