#pragma once

/// The results of `pelt-lab reproduce`, before they are written as a page, tables and pictures.

#include <cstdint>
#include <optional>
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

/// A figure for display: "26,756", "4.913", "0.0182".
std::string shown(double figure);
std::string shown(const Cell& cell);

}  // namespace pelt::reproduce
