#include "tools/pelt/bench/figures.hpp"

#include <pelt/version.hpp>

#include "text/format.hpp"
#include "text/json_text.hpp"
#include "text/printable.hpp"
#include "tools/pelt/bench/machine.hpp"
#include "tools/pelt/scene/json_lines.hpp"

#include <algorithm>
#include <iomanip>
#include <set>

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

Row method_json(const Figures& figures) {
  const Times& times = figures.times;
  return {{"method", figures.method},
          {"query", name_of(figures.question)},
          {"cache", figures.cache},
          {"asked", name_of(figures.asked)},
          {"threads", figures.threads},
          {"frames", times.frames},
          {"mean_us", times.mean_us},
          {"mean_contact_us", times.frames_in_contact > 0 ? Row(times.mean_contact_us) : Row()},
          {"p95_us", times.p95_us},
          {"mean_update_us", times.mean_update_us},
          {"hash", text::hex16(figures.answer.hash)},
          {"counters", scene::counters_json(figures.answer.work)}};
}

std::vector<Row> method_rows(const SceneFigures& scene) {
  std::vector<Row> rows;
  for (const Figures& figures : scene.figures) rows.push_back(method_json(figures));
  return rows;
}

/// The speed-up over another row; null without one.
Row speed_up(const Row& row, const Row* over) {
  return over ? Row(number_in(*over, "mean_us") / number_in(row, "mean_us")) : Row();
}

/// The columns of the table of times.
std::vector<Column> columns_of(Yardsticks yardsticks) {
  std::vector<Column> columns = {{"method", "method"},   {"threads", "threads"},
                                 {"mean_us", "mean us"}, {"mean_contact_us", "in contact"},
                                 {"p95_us", "95 %"},     {"mean_update_us", "update"},
                                 {"query_us", "query"}};
  for (const Yardstick& yardstick : yardsticks)
    columns.push_back({yardstick.column, yardstick.title, 2});
  columns.push_back({"vs_all", "vs all", 2});
  columns.push_back({"vs_1_thread", "vs 1 thread", 2});
  return columns;
}

/// Appends what is printed in addition to the values of --json.
void add_printed(const SceneFigures& scene, Yardsticks yardsticks, std::span<const Row> all,
                 Row& row) {
  row["query_us"] = number_in(row, "mean_us") - number_in(row, "mean_update_us");
  for (const Yardstick& yardstick : yardsticks)
    if ((yardstick.is_for_pairs && !scene.self) || find_row(all, {{"method", yardstick.method}}))
      row[yardstick.column] = ratio_to(yardstick, all, row);
  const Row own = {{"method", row["method"]}, {"cache", row["cache"]}, {"threads", 1}};
  const auto of_query = [&](const Row& query) {
    Row like = own;
    like["query"] = query;
    return find_row(all, like);
  };
  const bool is_crowd = row["asked"] == name_of(Asked::crowd);
  if (!scene.self)
    row["vs_1_thread"] = speed_up(row, is_crowd ? of_query(row["query"]) : nullptr);
  else if (row["query"] == name_of(Question::first))
    row["vs_all"] = speed_up(row, of_query(name_of(Question::all)));
}

void print_scene(const SceneFigures& scene, std::ostream& out) {
  const auto triangles = static_cast<double>(scene.models.triangles);
  const auto per_triangle = [&](std::uint64_t bytes) {
    return text::fixed(static_cast<double>(bytes) / triangles, 1) + " bytes per triangle\n";
  };
  out << text::printable(scene.scene) << ": " << text::with_commas(scene.triangles)
      << " triangles, " << text::counted(scene.frames, "frame") << " of which "
      << text::with_commas(scene.figures[0].answer.frames_in_contact) << " in contact\n"
      << "models: " << text::with_commas(scene.models.triangles) << " triangles, built in "
      << text::fixed(scene.models.build_seconds, 3) << " s, " << per_triangle(scene.models.bytes);
  if (scene.self)
    out << "self filters: built in " << text::fixed(scene.self->filter_build_seconds, 3) << " s, "
        << per_triangle(scene.self->filter_bytes);
  print_repetitions(scene.repetitions, "frame", out);
}

/// Prints the cost of skinning, which is the unit of comparison, and the methods close to it.
void print_skinning(const SceneFigures& scene, std::span<const Row> rows, std::ostream& out) {
  const Skinning& skinning = scene.skinning;
  out << "all " << text::with_commas(skinning.vertices)
      << " vertices skinned: " << text::fixed(skinning.mean_us, 1) << " us per frame, "
      << text::fixed(skinning.ns_per_vertex(), 2) << " ns per vertex";
  for (const char* method : {"paper", "eager"})
    if (const Row* row = find_row(rows, {{"method", method}, {"query", rows[0]["query"]}}))
      out << "; " << method << " " << text::fixed(number_in(*row, "mean_us") / skinning.mean_us, 2)
          << " times that";
  out << "\n\n";
}

void print_head(const SceneFigures& scene, const Figures& figures, std::ostream& out) {
  out << "query " << name_of(figures.question) << ", cache " << figures.cache << ", "
      << name_of(scene.time) << " time, median of " << scene.repetitions;
  if (figures.times.frames < scene.frames)
    out << ", " << text::counted(figures.times.frames, "frame") << " of "
        << text::with_commas(scene.frames);
  out << "; hash " << text::hex16(figures.answer.hash) << " by every method\n";
}

/// Prints a table for each query and state of the caches.
void print_times(const SceneFigures& scene, Yardsticks yardsticks, std::span<const Row> rows,
                 std::ostream& out) {
  const std::vector<Column> columns = columns_of(yardsticks);
  for (std::size_t begin = 0, end = 0; begin < rows.size(); begin = end) {
    std::vector<Row> group;
    for (; end < rows.size() && rows[end]["query"] == rows[begin]["query"] &&
           rows[end]["cache"] == rows[begin]["cache"];
         ++end) {
      group.push_back(rows[end]);
      add_printed(scene, yardsticks, rows, group.back());
    }
    print_head(scene, scene.figures[begin], out);
    print_table(columns, group, out);
    out << '\n';
  }
}

void print_sequence(const SceneFigures& scene, std::ostream& out) {
  if (!scene.self) return;
  const SelfFigures& self = *scene.self;
  out << "frames in order, all contacts: self " << text::fixed(self.self_us, 1)
      << " us per frame, with SelfTracker " << text::fixed(self.tracked_us, 1)
      << " us: " << text::fixed(self.self_us / self.tracked_us, 2) << " times as fast\n\n";
}

/// Prints a table of work. It does not depend on caches and threads, so each method is shown once
/// per query.
void print_work(const SceneFigures& scene, std::ostream& out) {
  constexpr Column kColumns[] = {
      {"method", "work per frame"},         {"query", "query"},
      {"node_pairs", "node pairs"},         {"refits", "refits"},
      {"posed_vertices", "posed vertices"}, {"triangle_pairs", "triangle pairs"}};
  std::vector<Row> rows;
  std::set<std::pair<Question, std::string>> shown;
  for (const Figures& figures : scene.figures) {
    if (!shown.emplace(figures.question, figures.method).second) continue;
    rows.push_back({{"method", figures.method}, {"query", name_of(figures.question)}});
    const Row counters = scene::counters_json(figures.answer.work);
    for (const auto& [name, count] : counters.items())
      rows.back()[name] = count.get<double>() / static_cast<double>(scene.frames);
  }
  print_table(kColumns, rows, out, {14, 16});
  out << '\n';
}

Row models_json(const SceneFigures& scene) {
  Row json = {{"triangles", scene.models.triangles},
              {"bytes", scene.models.bytes},
              {"build_seconds", scene.models.build_seconds}};
  if (scene.self) {
    json["self_filter_bytes"] = scene.self->filter_bytes;
    json["self_filter_build_seconds"] = scene.self->filter_build_seconds;
  }
  return json;
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

Row ratio_to(const Yardstick& yardstick, std::span<const Row> rows, const Row& row) {
  Row like = {{"method", yardstick.method},
              {"query", yardstick.query ? Row(yardstick.query) : row["query"]}};
  if (row.contains("cache")) like["cache"] = row["cache"];
  if (row.contains("threads")) like["threads"] = 1;
  const Row* other = find_row(rows, like);
  if (!other) return {};
  const double own = number_in(row, "mean_us"), theirs = number_in(*other, "mean_us");
  return yardstick.is_cost ? own / theirs : theirs / own;
}

void print_repetitions(std::uint32_t repetitions, const char* unit, std::ostream& out) {
  if (repetitions < kEnoughRepetitions)
    out << "rough measurement: " << text::counted(repetitions, "repetition") << " per " << unit
        << "; use " << kEnoughRepetitions << " or more to reduce noise\n";
}

void print_figures(const SceneFigures& scene, Yardsticks yardsticks, std::ostream& out) {
  const std::vector<Row> rows = method_rows(scene);
  print_scene(scene, out);
  print_skinning(scene, rows, out);
  print_times(scene, yardsticks, rows, out);
  print_sequence(scene, out);
  print_work(scene, out);
}

Row scene_json(const SceneFigures& scene) {
  Row json = {{"scene", scene.scene},
              {"frames", scene.frames},
              {"frames_in_contact", scene.figures[0].answer.frames_in_contact},
              {"repetitions", scene.repetitions},
              {"time", name_of(scene.time)},
              {"models", models_json(scene)},
              {"skinning",
               {{"vertices", scene.skinning.vertices},
                {"mean_us", scene.skinning.mean_us},
                {"ns_per_vertex", scene.skinning.ns_per_vertex()}}},
              {"methods", method_rows(scene)}};
  if (scene.self)
    json["sequence"] = {{"self_us", scene.self->self_us}, {"tracked_us", scene.self->tracked_us}};
  return json;
}

}  // namespace pelt::tools::bench
