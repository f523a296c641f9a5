#pragma once

/// Lists of pairs of triangles, one for each frame, as NumPy arrays.

#include "bindings/python/engine/array_view.hpp"
#include "bindings/python/engine/frame_lists.hpp"

#include <cstdint>
#include <tuple>
#include <vector>

namespace pelt::python {

using Column = py::array_t<std::int32_t>;

/// The columns frame, triangle_a and triangle_b [N], and for each frame whether a limit has ended
/// its query early [F].
using PairColumns = std::tuple<Column, Column, Column, py::array_t<bool>>;

/// The lists of a query, and whether it has been cut short.
template <class Pair>
struct PairLists {
  explicit PairLists(std::size_t frames) : lists(frames), cut_short(frames) {}

  FrameLists<Pair> lists;
  std::vector<std::uint8_t> cut_short;  // [F], a byte each, because threads write them

  PairColumns columns() const {
    const std::size_t count = lists.size();
    auto result =
        std::make_tuple(new_array<std::int32_t>({count}), new_array<std::int32_t>({count}),
                        new_array<std::int32_t>({count}), new_array<bool>({cut_short.size()}));
    std::int32_t* const frames = std::get<0>(result).mutable_data();
    std::int32_t* const a = std::get<1>(result).mutable_data();
    std::int32_t* const b = std::get<2>(result).mutable_data();
    lists.for_each([&](std::size_t place, std::size_t frame, const Pair& pair) {
      frames[place] = static_cast<std::int32_t>(frame);
      a[place] = static_cast<std::int32_t>(pair.triangle_a);
      b[place] = static_cast<std::int32_t>(pair.triangle_b);
    });
    bool* const cut = std::get<3>(result).mutable_data();
    for (std::size_t f = 0; f < cut_short.size(); ++f) cut[f] = cut_short[f] != 0;
    return result;
  }
};

}  // namespace pelt::python
