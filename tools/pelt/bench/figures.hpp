#pragma once

/// The figures of `pelt bench`, as text and as JSON: tables with named columns. A row is printed,
/// and written as JSON, by the names of its values.

#include "tools/pelt/bench/measure.hpp"

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

/// Figures of one query to one method, with one state of the caches.
struct Figures {
  std::string method;
  Asked asked = Asked::pairs;
  std::uint32_t threads = 1;
  Question question = Question::all;
  std::string cache = "hot";
  Answer answer;
  Times times;
};

/// The models of a scene, each once.
struct ModelFigures {
  std::uint64_t triangles = 0, bytes = 0;
  double build_seconds = 0;
};

struct SceneFigures {
  std::string scene;
  std::uint64_t triangles = 0;  ///< of all instances
  std::uint64_t frames = 0;
  std::uint32_t repetitions = 0;
  Time time = Time::thread;
  ModelFigures models;
  Skinning skinning;
  std::optional<SelfFigures> self;  ///< if instances are queried against themselves
  std::vector<Figures> figures;     ///< not empty; grouped by question and cache
};

/// A method that others are compared with, on one thread.
struct Yardstick {
  const char* column;  ///< in a row
  const char* title;   ///< in print
  const char* method;
  bool is_cost = false;         ///< the ratio is the cost over the method, not the speed-up
  bool is_for_pairs = false;    ///< shown for pairs even if the method was not measured
  const char* query = nullptr;  ///< of the method; null: that of the row
};

using Yardsticks = std::span<const Yardstick>;

inline constexpr Yardstick kYardsticks[] = {{"vs_paper", "vs paper", "paper", false, true},
                                            {"vs_eager", "vs eager", "eager", false, true},
                                            {"of_boxes", "of boxes", "boxes", true}};

/// The ratio of the mean times of one of the rows and of a yardstick; null if it is not among the
/// rows.
Row ratio_to(const Yardstick& yardstick, std::span<const Row> rows, const Row& row);

/// Prints a warning if there are few repetitions of each `unit`.
void print_repetitions(std::uint32_t repetitions, const char* unit, std::ostream& out);

void print_figures(const SceneFigures& scene, Yardsticks yardsticks, std::ostream& out);

/// A scene of --json.
Row scene_json(const SceneFigures& scene);

}  // namespace pelt::tools::bench
