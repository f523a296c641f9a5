#pragma once

/// Answers of characters checked against themselves.

#include "support/gltf_builder.hpp"
#include "tools/answer.hpp"

namespace pelt::test {

/// The contacts of instance `a` with instance `b` in a frame's line.
inline json triangles_of(const json& line, std::uint32_t a, std::uint32_t b) {
  for (const json& pair : line["pairs"])
    if (pair["a"] == a && pair["b"] == b) return pair["triangles"];
  return json::array();
}

inline const Words kKeepAll = {"--self-at-rest", "keep", "--self-near-joints", "keep"};

}  // namespace pelt::test
