#pragma once

#include "asset/buffers.hpp"

namespace pelt::asset {

/// Component types that an accessor may have, depending on its use.
enum class Storage : std::uint8_t {
  floats,                ///< float32 only
  floats_or_normalised,  ///< or normalised integers, which represent fractions
  floats_or_integers,    ///< or any integers of 8 or 16 bits (KHR_mesh_quantization)
};

/// Reads whole accessors: strided, sparse, of any component type. Validates sizes against the
/// available bytes before it allocates anything.
class AccessorReader {
 public:
  /// Borrows all its arguments.
  AccessorReader(const GltfDocument& document, Buffers& buffers, Budget& budget);

  /// Returns [count][components] finite numbers, with normalised integers as fractions. `use` names
  /// the purpose in messages: "POSITION of mesh 3".
  Result<std::vector<float>> floats(std::uint32_t accessor, ElementType type, Storage storage,
                                    const std::string& use);

  /// Returns [count][components] unsigned integers of at most `largest` type.
  Result<std::vector<std::uint32_t>> integers(std::uint32_t accessor, ElementType type,
                                              ComponentType largest, const std::string& use);

  std::uint64_t count(std::uint32_t accessor) const { return document_.accessors[accessor].count; }

 private:
  using Bytes = std::vector<std::byte>;

  Result<Bytes> elements(std::uint32_t accessor, const std::string& what);
  Result<void> copy_view(const GltfAccessor& accessor, Bytes& out, const std::string& what);
  Result<void> copy_sparse(const GltfAccessor& accessor, Bytes& out, const std::string& what);
  Result<std::span<const std::byte>> packed(std::uint32_t view, std::uint64_t offset,
                                            std::uint64_t count, std::size_t size,
                                            const std::string& what);

  const GltfDocument& document_;
  Buffers& buffers_;
  Budget& budget_;
};

/// Returns the name of an accessor in messages: "accessor 12 (POSITION of mesh 3)".
std::string accessor_label(std::uint32_t accessor, const std::string& use);

}  // namespace pelt::asset
