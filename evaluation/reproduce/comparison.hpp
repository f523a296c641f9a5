#pragma once

/// The tables of the open comparison, and what they share.

#include "evaluation/methods/lab_methods.hpp"
#include "evaluation/reproduce/report.hpp"
#include "evaluation/reproduce/scene_figures.hpp"
#include "scenes/scene.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace pelt::reproduce {

inline constexpr std::array kCompared = {
    methods::kOnDemand, methods::kEager, methods::kPaper,   lab::kPaperEager, lab::kBdTree,
    lab::kHybrid,       lab::kAabbRefit, lab::kAabbRebuild, lab::kHash,       lab::kHashOverlap};

/// The distances, from middle to middle, that texts and notes refer to by name.
inline constexpr double kApart = 1.2, kTouching = 0.7, kDeep = 0.3;

/// Number of phases of the walk over which a distance is averaged.
inline constexpr std::uint32_t kPhases = 4;

/// "hash_us", "hash [us]".
std::string time_key(methods::MethodKind method);
Column time_column(methods::MethodKind method);

/// A table with the columns `first`, a time for each method, and the fastest of them.
Table times_table(const std::string& id, const std::string& title, std::vector<Column> first,
                  std::span<const methods::MethodKind> methods, const std::string& note);

/// Adds the times and the fastest method to a row. Leaves methods empty that were not measured.
void append_times(const tools::bench::SceneFigures& figures, tools::bench::Question question,
                  std::span<const methods::MethodKind> methods, std::vector<Cell>& row);

/// "Medians of 9 repetitions, one thread, hot caches.", preceded by what a row is the mean of.
std::string how_measured(const std::string& mean_of, const Conditions& conditions);

/// Adds the table with two charts, so that their lines can be distinguished: trees on demand, and
/// methods that skin everything. Pelt is in both charts.
void add_with_charts(Table table, const std::string& x, Axes axes, std::optional<double> x_end,
                     Section& section);

/// Two creatures from apart to the same position: "separation" and "separation_first", with charts.
Result<void> add_separation(const scenes::Character& creature, const Conditions& conditions,
                            Section& section);

/// Over the number of triangles: "resolution", with charts.
Result<void> add_resolution(const Conditions& conditions, Section& section);

/// How the time of a deep contact splits: "time_split".
Result<Table> time_split(const scenes::Character& creature, const Conditions& conditions);

/// Many creatures that walk about: "instances", with a chart.
Result<void> add_instances(const scenes::Character& creature, const Conditions& conditions,
                           Section& section);

/// Hot and cold caches, slow frames and memory, over a clip: "clip".
Result<Table> clip_table(const Conditions& conditions);

/// The parameters of hashing and of trees: "cell_size", "leaf_size".
Result<Table> cell_sizes(const scenes::Character& creature, const Conditions& conditions);
Result<Table> leaf_sizes(const scenes::Character& creature, const Conditions& conditions);

/// Differences between the contacts of each method and those of brute force: "agreement".
Result<Table> agreement(const scenes::Character& creature, const Conditions& conditions);

/// The conclusions from the tables, one paragraph per family of methods. Every number is a figure
/// of a table or a ratio of two.
std::vector<std::string> answers_of(const Section& section);

/// Layered depth images, which only answer whether two bodies touch, beside exact methods:
/// "image_space" by resolution, with charts of time and misses, and "image_space_rivals".
Result<void> add_image_space(const scenes::Character& character, const Conditions& conditions,
                             Section& section);

/// Bytes that the program has allocated and not freed; nullopt if the C library does not provide
/// it. O(number of the allocator's arenas).
std::optional<std::size_t> heap_bytes();

}  // namespace pelt::reproduce
