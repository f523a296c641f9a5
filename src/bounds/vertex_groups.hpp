#pragma once

#include <pelt/bounds.hpp>

#include "model/node_bounds.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace pelt::detail {

struct VertexGroups {
  SkinnedModel model;
  std::vector<std::uint32_t> first_place;  // [G + 1], into places
  std::vector<std::uint32_t> places;       // of the groups' vertices in the tree's pools
  NodeBounds bounds;                       // a node for each group

  std::uint32_t count() const { return static_cast<std::uint32_t>(first_place.size() - 1); }
  std::span<const std::uint32_t> places_of(std::uint32_t group) const {
    return std::span(places).subspan(first_place[group],
                                     first_place[group + 1] - first_place[group]);
  }
};

}  // namespace pelt::detail
