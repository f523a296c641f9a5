#pragma once

/// What the tables of the open comparison have in common.

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
    methods::kOnDemand, methods::kEager,      methods::kPaper,     methods::kPaperEager,
    methods::kBdTree,   methods::kHybrid,     methods::kAabbRefit, methods::kAabbRebuild,
    methods::kHash,     methods::kHashOverlap};

/// The distances, from middle to middle, that texts and notes call by a name.
inline constexpr double kApart = 1.2, kTouching = 0.7, kDeep = 0.3;

/// Over how many phases of the walk a distance is averaged.
inline constexpr std::uint32_t kPhases = 4;

/// "hash_us", "hash [us]".
std::string time_key(methods::MethodKind method);
Column time_column(methods::MethodKind method);

/// A table with the columns `first`, a time for each method, and the fastest of them.
Table times_table(const std::string& id, const std::string& title, std::vector<Column> first,
                  std::span<const methods::MethodKind> methods, const std::string& note);

/// Adds the times and the fastest method to a row. Those that were not measured stay empty.
void append_times(const tools::SceneFigures& figures, tools::Question question,
                  std::span<const methods::MethodKind> methods, std::vector<Cell>& row);

/// "Medians of 9 repetitions, one thread, hot caches.", with what a row is the mean of before it.
std::string how_measured(const std::string& mean_of, const Conditions& conditions);

/// Adds the table with two charts, that their lines can be told apart: trees on demand, and
/// everything that skins all; Pelt is in both.
void add_with_charts(Table table, const std::string& x, Axes axes, std::optional<double> x_end,
                     Section& section);

using MakeRival = std::function<std::unique_ptr<rivals::PosedMeshMethod>()>;

/// A rival that is no method of the command.
tools::Engine rival_engine(const std::string& name, const MakeRival& make);

/// The figure of a row and a column. Precondition: there is one.
double figure_at(const Table& table, std::size_t row, const std::string& key);

}  // namespace pelt::reproduce
