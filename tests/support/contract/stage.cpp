#include "support/contract/stage.hpp"

#include "field/fields.hpp"
#include "ray/ray_cases.hpp"
#include "solid/random_regions.hpp"
#include "solid/solids.hpp"

#include <algorithm>

namespace pelt::contract {
namespace {

/// Half of the largest extent; 1 for a single point.
float half_size(const std::vector<Vec3>& positions, Vec3& centre) {
  Vec3 low = positions[0], high = low;
  for (const Vec3& p : positions) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const Vec3 half = {high.x / 2 - low.x / 2, high.y / 2 - low.y / 2, high.z / 2 - low.z / 2};
  centre = {low.x + half.x, low.y + half.y, low.z + half.z};
  const float size = std::max({half.x, half.y, half.z});
  return size > 0 ? size : 1;
}

HeightField field_around(Random& random, const Vec3& centre, float size) {
  const float spacing = std::max(size * random.uniformf(0.2, 0.6), 0x1p-149f);
  const float below = random.chance(0.3) ? 2 * size : 0;
  const Vec3 origin = {centre.x - 4 * spacing, centre.y - below, centre.z - 4 * spacing};
  const double height = double{size} * random.uniform(0, 0.5);
  if (random.chance(0.2)) return test::make_plain(9, 9, origin, spacing).build();
  return test::make_hills(random, 9, 8, origin, spacing, height, 0.05).build();
}

/// Small integers times a power of two, so that dot products are exact.
Vec3 grid_direction(Random& random) {
  const auto component = [&] { return (static_cast<float>(random.index(7)) - 3) * 0x1p-40f; };
  const Vec3 d = {component(), component(), component()};
  return d.x == 0 && d.y == 0 && d.z == 0 ? Vec3{1, 0, 0} : d;
}

/// The same kind in most cases.
const Kind& other_kind(Random& random, const Kind& kind) {
  const auto count = static_cast<std::uint32_t>(kinds().size());
  return random.chance(0.25) ? kinds()[random.index(count)] : kind;
}

/// A filter that leaves out nothing or, in a third of the cases, neighbours and some triangles.
SelfFilter filter_of(Random& random, const Body& body) {
  if (random.chance(0.7)) return *build_self_filter(body.to.model());
  std::vector<std::uint8_t> takes_part;
  for (std::size_t t = 0; t < body.shape.triangles.size(); ++t)
    takes_part.push_back(random.chance(0.8));
  constexpr std::uint32_t kRings[] = {0, 1, 3, 64};
  return *build_self_filter(body.to.model(),
                            {.rings = kRings[random.index(4)], .takes_part = takes_part});
}

}  // namespace

Stage::Stage(Random& random, const Kind& kind, double distance, std::uint32_t size_of_bodies)
    : a(kind.make(random, {}, size_of_bodies)),
      b(other_kind(random, kind).make(random, random.point(distance), size_of_bodies)),
      filter(filter_of(random, a)),
      filter_b(filter_of(random, b)),
      groups(group_by_joint(a.to.model())),
      field(test::make_plain(2, 2, {}, 1).build()) {
  const std::vector<Vec3> positions = positions_of(a.to);
  size = half_size(positions, centre);
  Vec3 centre_b;
  const float size_b = half_size(positions_of(b.to), centre_b);
  // Beside rounding errors of the larger body, less would be as good as zero.
  tolerance = double{std::max(size, size_b)} * random.uniform(0.01, 0.1);
  const test::RayCases cases(a.shape.triangles, positions);
  for (int i = 0; i < 12; ++i) {
    rays.push_back(cases.next(random));
    points.push_back(i % 4 == 0 ? cases.target(random) : cases.place(random));
    directions.push_back(grid_direction(random));
  }
  region = test::RandomRegions(random).next(centre, double{size});
  solid = test::random_solid(random, cases.place(random), double{size});
  field = field_around(random, centre, size);
}

Stage::Stage(Body first, Body second, const Stage& like)
    : a(std::move(first)),
      b(std::move(second)),
      filter(like.filter),
      filter_b(like.filter_b),
      groups(group_by_joint(a.to.model())),
      centre(like.centre),
      size(like.size),
      tolerance(like.tolerance),
      points(like.points),
      directions(like.directions),
      rays(like.rays),
      region(like.region),
      solid(like.solid),
      field(like.field) {}

Stage Stage::given() const { return {a.given(), b.given(), *this}; }

void Stage::close(bool reserved) {
  constexpr std::size_t kContacts = 60'000;
  a.renew(), b.renew();
  scratch = Scratch();
  if (!reserved) return;
  a.reserve(), b.reserve();
  scratch.reserve(kContacts, 1000, filter.scratch_size());
}

}  // namespace pelt::contract
