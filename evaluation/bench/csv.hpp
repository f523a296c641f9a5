#pragma once

#include "tools/pelt/bench/figures.hpp"

#include <cstdint>
#include <ostream>
#include <string>

namespace pelt::lab {

/// Writes rows with the same columns as CSV (RFC 4180), and the names of the columns before the
/// first row. Null becomes an empty field. Numbers have the precision of the stream.
class CsvWriter {
 public:
  explicit CsvWriter(std::ostream& out) : out_(out) {}

  void write(const tools::bench::Row& row) {
    if (is_first_) write_line(row, [&](const auto& column) { out_ << quoted(column.key()); });
    is_first_ = false;
    write_line(row, [&](const auto& column) { write_value(column.value()); });
  }

 private:
  template <typename Write>
  void write_line(const tools::bench::Row& row, const Write& write) {
    const char* separator = "";
    for (const auto& column : row.items()) {
      out_ << separator;
      write(column);
      separator = ",";
    }
    out_ << '\n';
  }

  void write_value(const tools::bench::Row& value) {
    if (value.is_string())
      out_ << quoted(value.get<std::string>());
    else if (value.is_number_integer())
      out_ << value.get<std::int64_t>();
    else if (value.is_number())
      out_ << value.get<double>();
  }

  /// A field with a comma, a quote or a line end is quoted.
  static std::string quoted(const std::string& text) {
    if (text.find_first_of(",\"\n") == text.npos) return text;
    std::string field = "\"";
    for (const char c : text) field += c == '"' ? "\"\"" : std::string(1, c);
    return field + "\"";
  }

  std::ostream& out_;
  bool is_first_ = true;
};

}  // namespace pelt::lab
