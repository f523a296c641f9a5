#include "solid/decide_touch.hpp"

#include "geometry/capsule_triangle.hpp"

#include <span>

namespace pelt::detail {
namespace {

/// `AnyRegion`: faces or a capsule.
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
  const CertainAnswer answer = certainly_touches(triangle, region);
  if (answer == CertainAnswer::no) return std::nullopt;
  if (answer == CertainAnswer::yes && !options.times) return FirstTouch{};
  ++work.exact_pairs;
  const std::optional<FirstTouch> touch = first_touch(triangle, region);
  return touch && !options.times ? FirstTouch{} : touch;
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
