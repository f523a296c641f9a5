#include "solid/moving_region.hpp"

#include "solid/region_triangle.hpp"

#include <span>

namespace pelt::detail {
namespace {

// `AnyRegion`: faces or a capsule. The triangle is apart from the region at time 0.

template <typename AnyRegion>
std::optional<FirstTouch> decide_whether(const AnyRegion& region, const MovingTriangle& triangle,
                                         MovingStats& work) {
  CertainAnswer answer = certainly_touches(triangle, region);
  if (answer == CertainAnswer::unknown) {
    ++work.exact_pairs;
    answer = first_touch(triangle, region) ? CertainAnswer::yes : CertainAnswer::no;
  }
  if (answer == CertainAnswer::no) return std::nullopt;
  return FirstTouch{};
}

template <typename AnyRegion>
std::optional<FirstTouch> decide_when(const AnyRegion& region, const MovingTriangle& triangle,
                                      MovingStats& work) {
  std::optional<FirstTouch> touch;
  if (find_certain_first_touch(triangle, region, touch)) return touch;
  ++work.exact_pairs;
  return first_touch(triangle, region);
}

template <typename AnyRegion>
std::optional<FirstTouch> decide(const AnyRegion& region, const MovingTriangle& triangle,
                                 const MovingOptions& options, MovingStats& work) {
  const auto touches = [&](const TriangleCorners& corners) {
    return place_triangle(corners, region) != TrianglePlace::apart;
  };
  ++work.triangle_pairs;
  if (touches(triangle.from)) {
    if (options.leave_out_start) return std::nullopt;
    return FirstTouch{0, true};
  }
  if (!options.times && touches(triangle.to)) return FirstTouch{};
  ++work.double_pairs;
  return options.times ? decide_when(region, triangle, work)
                       : decide_whether(region, triangle, work);
}

}  // namespace

std::optional<FirstTouch> decide_touch(const FacesRegion& region, const MovingTriangle& triangle,
                                       const MovingOptions& options, MovingStats& work) {
  return decide(std::span<const Face>(region.exact, region.count), triangle, options, work);
}

std::optional<FirstTouch> decide_touch(const CapsuleRegion& region, const MovingTriangle& triangle,
                                       const MovingOptions& options, MovingStats& work) {
  return decide(region.capsule, triangle, options, work);
}

}  // namespace pelt::detail
