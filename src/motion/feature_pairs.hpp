#pragma once

/// Pairs of features of two triangles, in the order in which `FirstMeeting` names them.

#include "motion/moving_pair.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace pelt::detail {

/// The corners of a feature, of which some are repeated. `first` is 0 for triangle a, 3 for b.
inline std::array<std::size_t, 3> corners_of(const ClosedFeature& feature, std::size_t first) {
  const std::size_t i = feature.number, next = (i + 1) % 3;
  switch (feature.kind) {
    case ClosedFeature::Kind::corner:
      return {first + i, first + i, first + i};
    case ClosedFeature::Kind::edge:
      return {first + i, first + next, first + next};
    case ClosedFeature::Kind::face:
      break;
  }
  return {first, first + 1, first + 2};
}

/// Sets `a` and `b` to the first pair of features for which `meet(corners_a, corners_b)`. Returns
/// false if there is none.
template <typename Meet>
bool find_feature_pair(ClosedFeature& a, ClosedFeature& b, const Meet& meet) {
  using Kind = ClosedFeature::Kind;
  constexpr std::array<std::array<Kind, 2>, 6> kOrder = {{{Kind::corner, Kind::corner},
                                                          {Kind::corner, Kind::edge},
                                                          {Kind::edge, Kind::corner},
                                                          {Kind::corner, Kind::face},
                                                          {Kind::face, Kind::corner},
                                                          {Kind::edge, Kind::edge}}};
  const auto count = [](Kind kind) { return kind == Kind::face ? 1 : 3; };
  for (const auto& [kind_a, kind_b] : kOrder)
    for (int i = 0; i < count(kind_a); ++i)
      for (int k = 0; k < count(kind_b); ++k) {
        a = {kind_a, static_cast<std::uint8_t>(i)};
        b = {kind_b, static_cast<std::uint8_t>(k)};
        if (meet(corners_of(a, 0), corners_of(b, 3))) return true;
      }
  return false;
}

}  // namespace pelt::detail
