#include "tools/pelt/bench/table.hpp"

#include <pelt/version.hpp>

#include "text/format.hpp"
#include "text/json_text.hpp"
#include "tools/pelt/bench/machine.hpp"

#include <algorithm>
#include <iomanip>

namespace pelt::tools::bench {
namespace {

std::string text_of(const Row& value, int decimals) {
  if (value.is_null()) return "-";
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_integer()) return text::with_commas(value.get<std::uint64_t>());
  return text::fixed(value.get<double>(), decimals);
}

Row machine_json() {
  const Machine machine = this_machine();
  return {{"cpu", machine.cpu},
          {"cores", machine.cores},
          {"instruction_set", machine.instruction_set},
          {"compiler", machine.compiler},
          {"build", machine.build},
          {"flags", machine.flags},
          {"pelt", PELT_VERSION}};
}

}  // namespace

void print_table(std::span<const Column> columns, std::span<const Row> rows, std::ostream& out,
                 const Widths& widths) {
  const auto print_line = [&](const auto& text_in) {
    bool is_first = true;
    for (const Column& column : columns) {
      if (!rows[0].contains(column.name)) continue;
      out << (is_first ? std::left : std::right)
          << std::setw(is_first ? widths.first : widths.others) << text_in(column);
      is_first = false;
    }
    out << std::right << '\n';
  };
  print_line([](const Column& column) { return std::string(column.title); });
  for (const Row& row : rows)
    print_line([&](const Column& column) { return text_of(row.at(column.name), column.decimals); });
}

const Row* find_row(std::span<const Row> rows, const Row& like) {
  const auto has_values = [&](const Row& row) {
    for (const auto& [name, value] : like.items())
      if (!row.contains(name) || row[name] != value) return false;
    return true;
  };
  const auto found = std::find_if(rows.begin(), rows.end(), has_values);
  return found == rows.end() ? nullptr : &*found;
}

std::string figures_json(const char* format, const std::vector<Row>& scenes) {
  const Row file = {
      {"format", format}, {"version", 1}, {"machine", machine_json()}, {"scenes", scenes}};
  return text::json_text(file, 2) + "\n";
}

}  // namespace pelt::tools::bench
