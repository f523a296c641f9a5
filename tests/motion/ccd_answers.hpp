#pragma once

/// The kinds of CSV files with queries, by their names, and their answers in JSON files.

#include "ccd_queries.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace pelt::test {

/// Decides by words in the name of the file and then of its folders, the nearest first: edge-edge
/// or ee, vertex-face or vf. If none has such a word, by the last letters of the file's name.
/// Throws CcdProblem.
CcdKind ccd_kind_of(const std::filesystem::path& csv);

/// 0, 1, false or true; otherwise nullopt.
std::optional<bool> ccd_answer(const std::string& text);

/// Reads the answers to NAME.csv, a JSON array of Boolean values, from NAME.json or
/// NAME_mma_bool.json. The file is in the same folder, in a folder mma_bool there or beside it, or
/// in another folder beside it. A folder `queries` above may also have a copy `mma_bool` of its
/// folders. Skips files with anything else than such an array. Throws CcdProblem if there is none.
std::vector<bool> ccd_answers_of(const std::filesystem::path& csv);

}  // namespace pelt::test
