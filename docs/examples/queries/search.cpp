#include <pelt/search.hpp>

#include <functional>

// Called every frame by a game: searches while the frame has time, and otherwise answers with what
// is known.
pelt::Verdict touch_in_time(pelt::Pose& a, pelt::Pose& b, pelt::Scratch& scratch,
                            const std::function<bool()>& has_time) {
  pelt::CollisionSearch search(a, b, pelt::SearchOrder::first_contact);
  while (search.verdict() == pelt::Verdict::unknown && has_time()) search.advance(2000, scratch);
  return search.verdict();
}

// The region in which the largest number of pairs of triangles is still undecided.
pelt::OpenRegion least_known(const pelt::CollisionSearch& search) {
  std::vector<pelt::OpenRegion> regions;
  search.open_regions(regions);
  pelt::OpenRegion least;
  for (const pelt::OpenRegion& open : regions)
    if (open.pairs > least.pairs) least = open;
  return least;
}
