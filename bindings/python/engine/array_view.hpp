#pragma once

/// NumPy arrays: views of arguments, and new arrays for answers.

#include <pelt/math.hpp>

#include "bindings/python/engine/argument_error.hpp"

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <span>
#include <string>
#include <vector>

namespace pelt::python {

namespace py = pybind11;

/// An array argument with elements of float or double, of any alignment and strides, with at most
/// four axes. Keeps the array alive. The constructor needs the interpreter lock, reading does not.
class FloatView {
 public:
  /// Throws an error that starts with `name` if the elements are neither float nor double.
  FloatView(const py::array& array, const std::string& name);

  std::size_t axes() const { return axes_; }
  std::size_t size(std::size_t axis) const { return sizes_[axis]; }

  /// Element with these indices, rounded to the nearest float. Indices of absent axes are 0.
  /// Precondition: each index is less than the size of its axis.
  float at(std::size_t i, std::size_t j = 0, std::size_t k = 0, std::size_t l = 0) const {
    const std::byte* place = data_ + offset(0, i) + offset(1, j) + offset(2, k) + offset(3, l);
    return is_double_ ? static_cast<float>(read<double>(place)) : read<float>(place);
  }

  /// Writes all elements whose first index is `i`, as a packed array.
  void copy(std::size_t i, float* out) const;

  Vec3 vector_at(std::size_t i, std::size_t j) const {
    return {at(i, j, 0), at(i, j, 1), at(i, j, 2)};
  }

 private:
  std::ptrdiff_t offset(std::size_t axis, std::size_t index) const {
    return strides_[axis] * static_cast<std::ptrdiff_t>(index);
  }

  template <class T>
  static T read(const std::byte* place) {
    T value;
    std::memcpy(&value, place, sizeof(T));
    return value;
  }

  bool is_packed_below_first_axis() const;
  void copy_one_by_one(std::size_t i, float* out) const;

  py::array array_;
  const std::byte* data_ = nullptr;
  bool is_double_ = false;
  bool is_packed_ = false;  // whether elements with equal first indices are packed
  std::size_t axes_ = 0;
  std::array<std::size_t, 4> sizes_ = {1, 1, 1, 1};
  std::array<std::ptrdiff_t, 4> strides_ = {};
};

/// An array of integers without gaps, which NumPy converts from other integers.
using Integers = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>;

/// Throws an error unless `array` has these sizes. -1 stands for any size. `shape` describes them,
/// for example "[T, 3]".
void check_shape(const py::array& array, const std::string& name,
                 std::initializer_list<py::ssize_t> sizes, const std::string& shape);

/// Returns a list of indices, which are less than `limit`. Otherwise throws an error with the name
/// of the array, the position and the value.
template <class Index>
std::vector<Index> indices_of(const Integers& array, const std::string& name, std::size_t limit) {
  const std::span<const std::int64_t> given(array.data(), static_cast<std::size_t>(array.size()));
  std::vector<Index> indices;
  indices.reserve(given.size());
  for (const std::int64_t value : given) {
    if (value < 0 || static_cast<std::uint64_t>(value) >= limit)
      throw ArgumentError(name + ": element " + std::to_string(indices.size()) + " is the index " +
                          std::to_string(value) + ", expected 0 to " + std::to_string(limit - 1) +
                          (limit == 0 ? " (there is nothing)" : ""));
    indices.push_back(static_cast<Index>(value));
  }
  return indices;
}

/// Returns a new array with these sizes, with elements that are not initialised.
template <class T>
py::array_t<T> new_array(std::initializer_list<std::size_t> sizes) {
  return py::array_t<T>(std::vector<py::ssize_t>(sizes.begin(), sizes.end()));
}

/// Returns a new array with these sizes and a copy of the elements.
template <class T>
py::array_t<T> array_of(std::span<const T> elements, std::initializer_list<std::size_t> sizes) {
  py::array_t<T> array = new_array<T>(sizes);
  if (!elements.empty()) std::memcpy(array.mutable_data(), elements.data(), elements.size_bytes());
  return array;
}

}  // namespace pelt::python
