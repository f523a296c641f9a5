#pragma once

/// Shared code of the tables of the open comparison.

#include "evaluation/methods/lab_methods.hpp"
#include "evaluation/reproduce/experiment.hpp"
#include "evaluation/reproduce/scene_figures.hpp"
#include "evaluation/rivals/posed_mesh_method.hpp"

#include <array>
#include <functional>
#include <memory>
#include <span>

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

using MakeRival = std::function<std::unique_ptr<rivals::PosedMeshMethod>()>;

/// A rival that is not a method of the command.
tools::bench::BenchMethod rival_method(const std::string& name, const MakeRival& make);

/// The figure of a row and a column. Precondition: the cell has a figure.
double figure_at(const Table& table, std::size_t row, const std::string& key);

}  // namespace pelt::reproduce
