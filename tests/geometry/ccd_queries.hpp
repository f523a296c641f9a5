#pragma once

/// Collections of moving vertex-face and edge-edge pairs with known answers: CSV files with eight
/// rows a query, each x, y and z as numerator and denominator. The answers are in a seventh column,
/// or in an array of a JSON file beside the CSV file.

#include "geometry/moving_polynomials.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace pelt::test {

/// numerator / 2^exponent
struct BinaryFraction {
  detail::BigInteger<1'200> numerator;
  unsigned exponent = 0;
};

enum class CcdKind : std::uint8_t { vertex_face, edge_edge };

struct CcdQuery {
  std::string origin;  ///< the file and the number of the query, for messages
  CcdKind kind = CcdKind::vertex_face;
  /// Four points at time 0, then at time 1: the vertex and the corners of the face, or the ends of
  /// both edges.
  std::array<std::array<BinaryFraction, 3>, 8> points;
  bool meets = false;
};

/// A file that cannot be read, or that this program cannot ask.
struct CcdProblem : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Reads all queries of a CSV file. Throws CcdProblem.
std::vector<CcdQuery> read_ccd_queries(const std::filesystem::path& csv);

/// The query as collapsed triangles: {v, v, v} and the face, or {a, b, b} and {c, d, d}. Throws
/// CcdProblem if coordinates differ by too many powers of two.
detail::MovingPoints collapsed_triangles(const CcdQuery& query);

/// The same if all coordinates are float32; otherwise returns false.
bool collapsed_triangles(const CcdQuery& query, detail::MovingTriangle& a,
                         detail::MovingTriangle& b);

}  // namespace pelt::test
