#include "asset/accessor.hpp"
#include "asset/little_endian.hpp"
#include "text/message.hpp"

#include <algorithm>
#include <cmath>

namespace pelt::asset {

namespace {

std::size_t element_size(const GltfAccessor& accessor) {
  return byte_size(accessor.component) * component_count(accessor.type);
}

/// Whether `count` elements of `size` bytes, `stride` apart, fit into `length` bytes when they
/// start at `offset`.
bool fits(std::uint64_t offset, std::uint64_t count, std::uint64_t size, std::uint64_t stride,
          std::uint64_t length) {
  if (count == 0) return true;
  if (offset > length || size > length - offset) return false;
  return count - 1 <= (length - offset - size) / stride;
}

template <typename T>
float fraction(std::byte const* bytes) {
  const float value = static_cast<float>(load<T>(bytes));
  return std::max(value / static_cast<float>(std::numeric_limits<T>::max()), -1.0f);
}

float to_float(const std::byte* bytes, ComponentType type, bool normalised) {
  switch (type) {
    case ComponentType::i8:
      return normalised ? fraction<std::int8_t>(bytes) : load<std::int8_t>(bytes);
    case ComponentType::u8:
      return normalised ? fraction<std::uint8_t>(bytes) : load<std::uint8_t>(bytes);
    case ComponentType::i16:
      return normalised ? fraction<std::int16_t>(bytes) : load<std::int16_t>(bytes);
    case ComponentType::u16:
      return normalised ? fraction<std::uint16_t>(bytes) : load<std::uint16_t>(bytes);
    default:
      return load<float>(bytes);
  }
}

std::uint32_t to_integer(const std::byte* bytes, ComponentType type) {
  switch (type) {
    case ComponentType::u8:
      return load<std::uint8_t>(bytes);
    case ComponentType::u16:
      return load<std::uint16_t>(bytes);
    default:
      return load<std::uint32_t>(bytes);
  }
}

bool is_unsigned_up_to(ComponentType type, ComponentType largest) {
  const bool is_unsigned =
      type == ComponentType::u8 || type == ComponentType::u16 || type == ComponentType::u32;
  return is_unsigned && byte_size(type) <= byte_size(largest);
}

bool may_be_stored(const GltfAccessor& accessor, Storage storage) {
  if (accessor.component == ComponentType::f32) return !accessor.normalised;
  if (accessor.component == ComponentType::u32 || storage == Storage::floats) return false;
  return accessor.normalised || storage == Storage::floats_or_integers;
}

Result<void> require_finite(const std::vector<float>& values, std::size_t components,
                            const std::string& what) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isfinite(values[i])) continue;
    return text::malformed(what + ": element " + std::to_string(i / components) +
                           (std::isnan(values[i]) ? " is NaN" : " is infinite"));
  }
  return {};
}

Result<void> require_type(const GltfAccessor& accessor, ElementType type, const std::string& what) {
  if (accessor.type == type) return {};
  return text::malformed(what + ": its type is " + name(accessor.type) + ", must be " + name(type));
}

}  // namespace

std::string accessor_label(std::uint32_t accessor, const std::string& use) {
  return text::label("accessor", accessor) + " (" + use + ")";
}

AccessorReader::AccessorReader(const GltfDocument& document, Buffers& buffers, Budget& budget)
    : document_(document), buffers_(buffers), budget_(budget) {}

Result<std::vector<float>> AccessorReader::floats(std::uint32_t index, ElementType type,
                                                  Storage storage, const std::string& use) {
  const GltfAccessor& accessor = document_.accessors[index];
  const std::string what = accessor_label(index, use);
  if (!may_be_stored(accessor, storage)) {
    return text::malformed(what + ": this component type is not allowed here");
  }
  const Result<void> right_type = require_type(accessor, type, what);
  if (!right_type) return right_type.error();
  const Result<Bytes> bytes = elements(index, what);
  if (!bytes) return bytes.error();
  std::vector<float> values(accessor.count * component_count(type));
  const std::size_t size = byte_size(accessor.component);
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = to_float(&(*bytes)[i * size], accessor.component, accessor.normalised);
  }
  const Result<void> finite = require_finite(values, component_count(type), what);
  if (!finite) return finite.error();
  return values;
}

Result<std::vector<std::uint32_t>> AccessorReader::integers(std::uint32_t index, ElementType type,
                                                            ComponentType largest,
                                                            const std::string& use) {
  const GltfAccessor& accessor = document_.accessors[index];
  const std::string what = accessor_label(index, use);
  if (!is_unsigned_up_to(accessor.component, largest) || accessor.normalised) {
    return text::malformed(what + ": must have unsigned integers of at most " +
                           std::to_string(8 * byte_size(largest)) + " bits, not normalised");
  }
  const Result<void> right_type = require_type(accessor, type, what);
  if (!right_type) return right_type.error();
  const Result<Bytes> bytes = elements(index, what);
  if (!bytes) return bytes.error();
  std::vector<std::uint32_t> values(accessor.count * component_count(type));
  const std::size_t size = byte_size(accessor.component);
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = to_integer(&(*bytes)[i * size], accessor.component);
  }
  return values;
}

/// Returns the accessor's elements without gaps, with sparse values applied.
Result<AccessorReader::Bytes> AccessorReader::elements(std::uint32_t index,
                                                       const std::string& what) {
  const GltfAccessor& accessor = document_.accessors[index];
  // Components of one byte become four bytes.
  const Result<void> taken = budget_.take(accessor.count, 4 * component_count(accessor.type), what);
  if (!taken) return taken.error();
  Bytes out;
  const Result<void> base = copy_view(accessor, out, what);
  if (!base) return base.error();
  const Result<void> sparse = copy_sparse(accessor, out, what);
  if (!sparse) return sparse.error();
  return out;
}

Result<void> AccessorReader::copy_view(const GltfAccessor& accessor, Bytes& out,
                                       const std::string& what) {
  const std::size_t size = element_size(accessor);
  if (!accessor.view) {
    out.resize(accessor.count * size);
    return {};
  }
  const Result<std::span<const std::byte>> bytes = buffers_.view(*accessor.view, what);
  if (!bytes) return bytes.error();
  const GltfView& view = document_.views[*accessor.view];
  const std::uint64_t stride = view.stride == 0 ? size : view.stride;
  if (stride < size)
    return text::malformed(what + ": byteStride of its view is less than an element");
  if (!fits(accessor.offset, accessor.count, size, stride, bytes->size())) {
    return text::malformed(what + ": " + std::to_string(accessor.count) +
                           " elements reach beyond " + text::label("bufferView", *accessor.view));
  }
  out.resize(accessor.count * size);
  for (std::uint64_t i = 0; i < accessor.count; ++i) {
    std::memcpy(&out[i * size], &(*bytes)[accessor.offset + i * stride], size);
  }
  return {};
}

Result<void> AccessorReader::copy_sparse(const GltfAccessor& accessor, Bytes& out,
                                         const std::string& what) {
  if (!accessor.sparse) return {};
  const GltfSparse& sparse = *accessor.sparse;
  const std::size_t size = element_size(accessor);
  const std::size_t index_size = byte_size(sparse.index_type);
  if (!is_unsigned_up_to(sparse.index_type, ComponentType::u32)) {
    return text::malformed(what + ": sparse indices must be unsigned integers");
  }
  const auto indices = packed(sparse.index_view, sparse.index_offset, sparse.count, index_size,
                              what + ", sparse indices");
  if (!indices) return indices.error();
  const auto values =
      packed(sparse.value_view, sparse.value_offset, sparse.count, size, what + ", sparse values");
  if (!values) return values.error();
  std::uint64_t least = 0;
  for (std::uint64_t i = 0; i < sparse.count; ++i) {
    const std::uint32_t element = to_integer(&(*indices)[i * index_size], sparse.index_type);
    if (element < least || element >= accessor.count) {
      return text::malformed(what + ": sparse index " + std::to_string(element) + " at " +
                             std::to_string(i) + " is out of order or out of range");
    }
    least = std::uint64_t{element} + 1;
    std::memcpy(&out[element * size], &(*values)[i * size], size);
  }
  return {};
}

/// Returns `count` elements of `size` bytes of a view without gaps.
Result<std::span<const std::byte>> AccessorReader::packed(std::uint32_t view, std::uint64_t offset,
                                                          std::uint64_t count, std::size_t size,
                                                          const std::string& what) {
  const Result<std::span<const std::byte>> bytes = buffers_.view(view, what);
  if (!bytes) return bytes.error();
  if (!fits(offset, count, size, size, bytes->size())) {
    return text::malformed(what + ": " + std::to_string(count) + " elements reach beyond " +
                           text::label("bufferView", view));
  }
  return bytes->subspan(count == 0 ? 0 : offset, count * size);
}

}  // namespace pelt::asset
