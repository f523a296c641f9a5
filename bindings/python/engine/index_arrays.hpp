#pragma once

/// Lists of indices in arguments.

#include <pelt/self_filter.hpp>

#include "bindings/python/engine/array_view.hpp"

#include <optional>
#include <string>
#include <vector>

namespace pelt::python {

/// Joints, groups and zones have numbers below this.
inline constexpr std::size_t kNumbers = 65'536;

/// Returns a list of numbers. Nothing stands for an empty list.
inline std::vector<std::uint16_t> read_numbers(const std::optional<Integers>& array,
                                               const std::string& name) {
  if (!array) return {};
  check_shape(*array, name, {-1}, "[N]");
  return indices_of<std::uint16_t>(*array, name, kNumbers);
}

/// Returns a list of pairs of indices that are less than `limit`.
template <class Pair, class Index>
std::vector<Pair> read_pairs(const std::optional<Integers>& array, const std::string& name,
                             std::size_t limit) {
  std::vector<Pair> pairs;
  if (!array) return pairs;
  check_shape(*array, name, {-1, 2}, "[N, 2]");
  const std::vector<Index> indices = indices_of<Index>(*array, name, limit);
  for (std::size_t i = 0; i < indices.size(); i += 2) pairs.push_back({indices[i], indices[i + 1]});
  return pairs;
}

/// Returns a list of joints in which -1, or `kNoJoint` in the answer, stands for none.
inline std::vector<std::uint16_t> read_parents(const std::optional<Integers>& array,
                                               const std::string& name) {
  if (!array) return {};
  check_shape(*array, name, {-1}, "[J]");
  std::vector<std::uint16_t> parents;
  for (py::ssize_t j = 0; j < array->size(); ++j) {
    const std::int64_t parent = array->at(j);
    if (parent < -1 || parent >= kNoJoint)
      throw ArgumentError(name + ": joint " + std::to_string(j) + " has the parent " +
                          std::to_string(parent) + " (expected a joint, or -1 for none)");
    parents.push_back(parent == -1 ? kNoJoint : static_cast<std::uint16_t>(parent));
  }
  return parents;
}

}  // namespace pelt::python
