#pragma once

/// The experiments of `pelt-lab reproduce`: those of Kavan & Zara 2005, section 5, and additional
/// ones. Their results, before they are written as a page, tables and pictures.

#include <pelt/result.hpp>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace pelt::reproduce {

/// A figure, a name, or empty.
struct Cell {
  Cell() = default;
  Cell(double f) : figure(f) {}
  Cell(std::string n) : name(std::move(n)) {}
  Cell(const char* n) : name(n) {}

  std::optional<double> figure;
  std::string name;  ///< empty if there is no name
};

struct Column {
  std::string key;    ///< in CSV and JSON, with its unit: "refit_ns"
  std::string title;  ///< for display, with its unit
};

struct Table {
  std::string id;  ///< also the name of its CSV file
  std::string title;
  std::vector<Column> columns;
  std::vector<std::vector<Cell>> rows;  ///< each with a cell for every column
  std::string note;
};

enum class Better { lower, higher, neither };
enum class Axes { linear, logarithmic, logarithmic_x, logarithmic_y };

/// Columns of a table of the same section, drawn over another column of the table.
struct Chart {
  std::string id, title;
  std::string table;           ///< id
  std::string x;               ///< key of a column
  std::vector<std::string> y;  ///< keys of columns
  std::string y_title;         ///< with its unit
  Axes axes = Axes::logarithmic;
  Better better = Better::lower;
  double least_y = 0;                ///< start of a linear axis of heights
  std::optional<double> x_end = {};  ///< larger x are in the table only
};

/// A scene for POV-Ray.
struct Picture {
  std::string id, caption;
  std::string description;
  std::uint32_t width = 960, height = 540;
};

/// The result of one experiment. Every figure in `text` is also in a table.
struct Section {
  std::string id, title;
  std::vector<std::string> text;  ///< paragraphs
  std::vector<Table> tables;
  std::vector<Chart> charts;
  std::vector<Picture> pictures;
  double seconds = 0;  ///< duration of the experiment
};

/// The index of the column with the key `key`. Precondition: the column exists.
std::size_t column_of(const Table& table, const std::string& key);

/// The figure of a row and a column. Precondition: the cell has a figure.
double figure_at(const Table& table, std::size_t row, const std::string& key);

/// The least and the greatest figure of a column: "27.7 to 38.2". Precondition: all rows have one.
std::string range_of(const Table& table, const std::string& key);

/// A figure for display: "26,756", "4.913", "0.0182".
std::string shown(double figure);
std::string shown(const Cell& cell);

/// `text` for a page, with the Greek letter (UTF-8) in the unit "us": "query [us]", "12.5 us".
std::string with_micro_signs(const std::string& text);

struct Conditions {
  bool is_quick = false;         ///< fewer frames, repetitions and sizes
  std::filesystem::path models;  ///< a folder with real characters; empty: generated ones only
};

struct Experiment {
  const char* id;
  const char* title;
  Result<Section> (*run)(const Conditions& conditions);
};

/// In the order of the report.
std::span<const Experiment> experiments();

/// The comparison with other libraries, which follows them. Null in a build without the adapters
/// (PELT_BENCH_PEERS).
const Experiment* peers_experiment();

Result<Section> characters(const Conditions& conditions);      // characters.cpp
Result<Section> sphere_trees(const Conditions& conditions);    // sphere_trees.cpp
Result<Section> tightness(const Conditions& conditions);       // tightness.cpp
Result<Section> refit_cost(const Conditions& conditions);      // refit_cost.cpp
Result<Section> two_men(const Conditions& conditions);         // walking.cpp
Result<Section> worst_case(const Conditions& conditions);      // walking.cpp
Result<Section> subdivision(const Conditions& conditions);     // subdivision.cpp
Result<Section> crowd_of_fifty(const Conditions& conditions);  // walking.cpp
Result<Section> real_pairs(const Conditions& conditions);      // characters.cpp
Result<Section> growth(const Conditions& conditions);          // growth.cpp
Result<Section> self_collision(const Conditions& conditions);  // self_collision.cpp
Result<Section> between_frames(const Conditions& conditions);  // between_frames.cpp
Result<Section> comparison(const Conditions& conditions);      // comparison.cpp
Result<Section> peers(const Conditions& conditions);           // peers.cpp

}  // namespace pelt::reproduce
