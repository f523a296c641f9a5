#include "evaluation/reproduce/files.hpp"

#include "evaluation/bench/csv.hpp"
#include "evaluation/reproduce/drawing.hpp"
#include "evaluation/reproduce/html.hpp"
#include "tools/pelt/output/output_file.hpp"
#include "tools/pelt/output/progress.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <ostream>
#include <set>
#include <sstream>

namespace pelt::reproduce {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

constexpr const char* kSubfolders[] = {"csv", "charts", "pictures"};

ordered_json json_cell(const Cell& cell) {
  if (cell.figure) return *cell.figure;
  return cell.name.empty() ? ordered_json() : ordered_json(cell.name);
}

/// The values of a row, by the keys of their columns.
tools::bench::Row named(const Table& table, const std::vector<Cell>& cells) {
  tools::bench::Row row;
  for (std::size_t c = 0; c < cells.size(); ++c) row[table.columns[c].key] = json_cell(cells[c]);
  return row;
}

ordered_json json_table(const Table& table) {
  ordered_json rows = ordered_json::array();
  for (const std::vector<Cell>& cells : table.rows) rows.push_back(named(table, cells));
  return {{"id", table.id}, {"title", table.title}, {"rows", std::move(rows)}};
}

const Table& table_of(const Section& section, const Chart& chart) {
  return *std::find_if(section.tables.begin(), section.tables.end(),
                       [&](const Table& table) { return table.id == chart.table; });
}

Result<void> write_text(const fs::path& path, const std::string& text) {
  return tools::output::write_file(path, std::as_bytes(std::span(text)));
}

std::string read_all(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::size_t image_count(const Report& report) {
  std::size_t count = 0;
  for (const Section& section : report.sections)
    count += section.charts.size() + section.pictures.size();
  return count;
}

/// The images of all sections by id. Reports each problem once.
class Images {
 public:
  Images(const Report& report, const fs::path& folder, std::ostream& messages)
      : folder_(folder), messages_(messages), progress_(image_count(report)) {}

  void draw(const Section& section) {
    for (const Chart& chart : section.charts) {
      const fs::path file = folder_ / "charts" / (chart.id + ".svg");
      take(chart.id, file, draw_chart(chart, table_of(section, chart), file));
    }
    for (const Picture& picture : section.pictures) {
      const fs::path file = folder_ / "pictures" / (picture.id + ".png");
      take(picture.id, file, render(picture, file));
    }
  }

  const std::map<std::string, std::string>& bytes() const { return bytes_; }

 private:
  void take(const std::string& id, const fs::path& file, const Result<void>& drawn) {
    if (drawn)
      bytes_[id] = read_all(file);
    else if (told_.insert(drawn.error().message).second)
      messages_ << drawn.error().message << '\n';
    progress_.advance();
  }

  fs::path folder_;
  std::ostream& messages_;
  std::map<std::string, std::string> bytes_;
  std::set<std::string> told_;
  tools::output::Progress progress_;
};

}  // namespace

Result<void> make_folders(const fs::path& folder) {
  for (const char* name : kSubfolders) {
    std::error_code error;
    fs::create_directories(folder / name, error);
    if (error)
      return Error{ErrorCode::unreadable_file,
                   folder.string() +
                       ": is not a folder and cannot be created: choose another folder with -o"};
  }
  return {};
}

std::vector<fs::path> replaced_files(const fs::path& folder) {
  std::vector<fs::path> files = {folder / "report.html", folder / "results.json"};
  for (const char* name : kSubfolders) {
    std::error_code error;  // a folder that does not exist has no files
    for (const auto& entry : fs::directory_iterator(folder / name, error))
      files.push_back(entry.path());
  }
  return files;
}

std::string csv_of(const Table& table) {
  std::ostringstream text;
  text.precision(10);
  lab::CsvWriter csv(text);
  for (const std::vector<Cell>& cells : table.rows) csv.write(named(table, cells));
  return text.str();
}

std::string json_of(const Report& report) {
  ordered_json sections = ordered_json::array();
  for (const Section& section : report.sections) {
    ordered_json tables = ordered_json::array();
    for (const Table& table : section.tables) tables.push_back(json_table(table));
    sections.push_back({{"id", section.id},
                        {"title", section.title},
                        {"seconds", section.seconds},
                        {"text", section.text},
                        {"tables", std::move(tables)}});
  }
  const ordered_json all = {{"format", "pelt-reproduce"},
                            {"version", 1},
                            {"provenance", report.provenance},
                            {"sections", std::move(sections)}};
  return all.dump(2) + "\n";
}

Result<void> write_report(const Report& report, const fs::path& folder, std::ostream& messages) {
  Images images(report, folder, messages);
  for (const Section& section : report.sections) {
    for (const Table& table : section.tables)
      if (const auto written = write_text(folder / "csv" / (table.id + ".csv"), csv_of(table));
          !written)
        return written.error();
    images.draw(section);
  }
  if (const auto written = write_text(folder / "results.json", json_of(report)); !written)
    return written.error();
  return write_text(folder / "report.html",
                    html_page(report.sections, report.provenance, images.bytes()));
}

}  // namespace pelt::reproduce
