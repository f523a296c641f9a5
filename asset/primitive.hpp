#pragma once

/// Reads the accessors of a primitive, and validates each list by itself and against the others.

#include "asset/accessor.hpp"

namespace pelt::asset {

/// A primitive of a mesh, with its names for messages.
struct PrimitivePlace {
  std::uint32_t mesh = 0, primitive = 0;
};

struct Influence {
  std::uint16_t joint = 0;
  float weight = 0;
};

/// Influences of each vertex in the order of the file, without zero weights.
struct Influences {
  std::vector<std::uint64_t> first = {0};  ///< [V + 1] vertex v has first[v] to first[v + 1]
  std::vector<Influence> list;
};

class PrimitiveReader {
 public:
  /// Borrows all its arguments.
  PrimitiveReader(const GltfDocument& document, AccessorReader& reader, Budget& budget);

  Result<std::vector<Vec3>> positions(PrimitivePlace place);

  /// Returns the displacement of each of `vertex_count` vertices by the morph target; empty if it
  /// displaces none.
  Result<std::vector<Vec3>> displacements(PrimitivePlace place, std::uint32_t target,
                                          std::uint64_t vertex_count);

  /// Returns the influences of all sets. `joints` maps joints of the skin to joints of the palette;
  /// `skin` names the skin in messages.
  Result<Influences> influences(PrimitivePlace place, const std::vector<std::uint16_t>& joints,
                                const std::string& skin);

  /// Returns the triangles of a list, strip or fan, with or without indices, over `vertex_count`
  /// vertices.
  Result<std::vector<Triangle>> triangles(PrimitivePlace place, std::uint64_t vertex_count);

 private:
  const GltfPrimitive& at(PrimitivePlace place) const;
  std::string label_of(PrimitivePlace place) const;
  Result<std::vector<std::uint32_t>> joint_set(PrimitivePlace place, std::uint32_t set,
                                               std::size_t joint_count, const std::string& skin);
  Result<std::vector<float>> weight_set(PrimitivePlace place, std::uint32_t set);
  Result<void> require_count(std::uint32_t accessor, std::uint64_t vertex_count,
                             const std::string& use) const;
  Result<std::vector<std::uint32_t>> corners(PrimitivePlace place, std::uint64_t vertex_count);

  const GltfDocument& document_;
  AccessorReader& reader_;
  Budget& budget_;
};

/// `mesh 2 "Body", primitive 0`.
std::string primitive_label(const GltfDocument& document, PrimitivePlace place);

}  // namespace pelt::asset
