#include "bindings/python/engine/array_view.hpp"

#include <algorithm>

namespace pelt::python {

FloatView::FloatView(const py::array& array, const std::string& name)
    : array_(array), data_(static_cast<const std::byte*>(array.data())) {
  is_double_ = py::isinstance<py::array_t<double>>(array);
  if (!is_double_ && !py::isinstance<py::array_t<float>>(array))
    throw ArgumentError(name + ": expected float32 or float64");
  axes_ = static_cast<std::size_t>(array.ndim());
  if (axes_ > sizes_.size()) throw ArgumentError(name + ": more than four axes");
  for (std::size_t axis = 0; axis < axes_; ++axis) {
    sizes_[axis] = static_cast<std::size_t>(array.shape(static_cast<py::ssize_t>(axis)));
    strides_[axis] = array.strides(static_cast<py::ssize_t>(axis));
  }
  is_packed_ = is_packed_below_first_axis();
}

bool FloatView::is_packed_below_first_axis() const {
  auto stride = static_cast<std::ptrdiff_t>(is_double_ ? sizeof(double) : sizeof(float));
  for (std::size_t axis = axes_; axis-- > 1;) {
    if (strides_[axis] != stride) return false;
    stride *= static_cast<std::ptrdiff_t>(sizes_[axis]);
  }
  return true;
}

void FloatView::copy(std::size_t i, float* out) const {
  if (!is_packed_) return copy_one_by_one(i, out);
  const std::size_t count = sizes_[1] * sizes_[2] * sizes_[3];
  const std::byte* const first = data_ + offset(0, i);
  if (is_double_)
    for (std::size_t e = 0; e < count; ++e)
      out[e] = static_cast<float>(read<double>(first + e * sizeof(double)));
  else
    std::memcpy(out, first, count * sizeof(float));
}

void FloatView::copy_one_by_one(std::size_t i, float* out) const {
  for (std::size_t j = 0; j < sizes_[1]; ++j)
    for (std::size_t k = 0; k < sizes_[2]; ++k)
      for (std::size_t l = 0; l < sizes_[3]; ++l) *out++ = at(i, j, k, l);
}

void check_shape(const py::array& array, const std::string& name,
                 std::initializer_list<py::ssize_t> sizes, const std::string& shape) {
  const std::span<const py::ssize_t> found(array.shape(), static_cast<std::size_t>(array.ndim()));
  const auto fits = [](py::ssize_t size, py::ssize_t wanted) {
    return wanted < 0 || size == wanted;
  };
  if (std::equal(found.begin(), found.end(), sizes.begin(), sizes.end(), fits)) return;
  std::string text;
  for (const py::ssize_t size : found) text += (text.empty() ? "" : ", ") + std::to_string(size);
  throw ArgumentError(name + ": expected the shape " + shape + ", found [" + text + "]");
}

}  // namespace pelt::python
