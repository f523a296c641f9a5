#pragma once

/// What `pelt-lab reproduce` finds out, before it becomes a page, tables and pictures on disk.

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pelt::reproduce {

/// A figure, a name, or nothing where there is none to tell.
struct Cell {
  Cell() = default;
  Cell(double f) : figure(f) {}
  Cell(std::string n) : name(std::move(n)) {}
  Cell(const char* n) : name(n) {}

  std::optional<double> figure;
  std::string name;  ///< empty if there is none
};

struct Column {
  std::string key;    ///< in CSV and JSON, with its unit: "refit_ns"
  std::string title;  ///< as people read it, with its unit
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

/// Columns of a table of the same section, drawn over another of its columns.
struct Chart {
  std::string id, title;
  std::string table;           ///< id
  std::string x;               ///< key of a column
  std::vector<std::string> y;  ///< keys of columns
  std::string y_title;         ///< with its unit
  Axes axes = Axes::logarithmic;
  Better better = Better::lower;
  double least_y = 0;                ///< where a linear axis of heights begins
  std::optional<double> x_end = {};  ///< rows beyond are left to the table
};

/// A scene for POV-Ray.
struct Picture {
  std::string id, caption;
  std::string description;
  std::uint32_t width = 960, height = 540;
};

/// What one experiment found. Every figure that `text` states is in a table.
struct Section {
  std::string id, title;
  std::vector<std::string> text;  ///< paragraphs
  std::vector<Table> tables;
  std::vector<Chart> charts;
  std::vector<Picture> pictures;
  double seconds = 0;  ///< that the experiment took
};

/// The index of the column with that key. Precondition: there is one.
std::size_t column_of(const Table& table, const std::string& key);

/// A figure for people: "26,756", "4.913", "0.0182".
std::string shown(double figure);
std::string shown(const Cell& cell);

}  // namespace pelt::reproduce
