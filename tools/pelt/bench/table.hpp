#pragma once

/// Tables with named columns. A row is printed, and written as JSON, by the names of its values.

#include <nlohmann/json.hpp>

#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <vector>

namespace pelt::tools::bench {

/// Values by the names of their columns.
using Row = nlohmann::ordered_json;

struct Column {
  const char* name;
  const char* title;  ///< in print
  int decimals = 1;   ///< of a number that is not whole
};

/// Widths of the first column, which is to the left, and of the others.
struct Widths {
  int first = 12, others = 12;
};

/// Prints the titles and the rows. Null is printed as "-". Columns that the first row does not name
/// are left out. Precondition: `rows` is not empty.
void print_table(std::span<const Column> columns, std::span<const Row> rows, std::ostream& out,
                 const Widths& widths = {});

/// A value, or null.
template <typename T>
Row value_or_null(const std::optional<T>& value) {
  return value ? Row(*value) : Row();
}

/// Precondition: the value is a number.
inline double number_in(const Row& row, const char* name) { return row.at(name).get<double>(); }

/// The first row with all values of `like`, or null.
const Row* find_row(std::span<const Row> rows, const Row& like);

/// The file of --json: the format, this machine, and the scenes.
std::string figures_json(const char* format, const std::vector<Row>& scenes);

}  // namespace pelt::tools::bench
