#include "contact/end_key.hpp"

#include <algorithm>
#include <utility>

namespace pelt::detail {
namespace {

FeatureName name_of(Feature feature, std::uint32_t triangle, const Surface& surface) {
  if (feature == Feature::face) return {triangle, 0, 2};
  const Triangle& corners = surface.corners[triangle];
  const auto number = static_cast<std::size_t>(feature);
  if (feature <= Feature::corner2) return {corners[number], 0, 0};
  const auto [less, more] = std::minmax(corners[number - 3], corners[(number - 2) % 3]);
  return {less, more, 1};
}

}  // namespace

EndKey key_of(const CrossingEnd& end, const Contact& contact, const ContactSurfaces& surfaces) {
  EndKey key = {name_of(end.a, contact.triangle_a, surfaces.a),
                name_of(end.b, contact.triangle_b, surfaces.b)};
  key.is_swapped = surfaces.is_self && key.second < key.first;
  if (key.is_swapped) std::swap(key.first, key.second);
  return key;
}

}  // namespace pelt::detail
