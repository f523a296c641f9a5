#pragma once

/// Collections of moving vertex-face and edge-edge pairs with known answers, in CSV files with
/// eight rows a query. A row is a point: x, y and z, each as numerator and denominator (six
/// columns) or as a number (three columns). The answer is in one more column, 0 or 1, or in a JSON
/// file. Empty lines and lines that start with # are skipped.

#include "geometry/rational_distance.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace pelt::test {

enum class CcdKind : std::uint8_t { vertex_face, edge_edge };

struct CcdQuery {
  std::string origin;  ///< the file and the number of the query, for messages
  CcdKind kind = CcdKind::vertex_face;
  /// Four points at time 0, then at time 1: the vertex and the corners of the face, or the ends of
  /// both edges.
  std::array<RationalPoint, 8> points;
  bool meets = false;
};

/// A file that cannot be read. The text names the file, and the line if that is what is wrong.
struct CcdProblem : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Reads all queries of a CSV file. Throws CcdProblem.
std::vector<CcdQuery> read_ccd_queries(const std::filesystem::path& csv);

/// The kind of the queries in a file. Decides by words in the name of the file and then of its
/// folders, the nearest first: edge-edge or ee, vertex-face or vf. If none has such a word, by the
/// last letters of the file's name. Throws CcdProblem.
CcdKind ccd_kind_of(const std::filesystem::path& csv);

/// 0, 1, false or true; otherwise nullopt.
std::optional<bool> ccd_answer(const std::string& text);

/// Reads the answers to NAME.csv, a JSON array of Boolean values, from NAME.json or
/// NAME_mma_bool.json. The file is in the same folder, in a folder mma_bool there or beside it, or
/// in another folder beside it. A folder `queries` above may also have a copy `mma_bool` of its
/// folders. Skips files with anything else than such an array. Throws CcdProblem if there is none.
std::vector<bool> ccd_answers_of(const std::filesystem::path& csv);

}  // namespace pelt::test
