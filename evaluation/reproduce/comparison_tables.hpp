#pragma once

/// The tables of the open comparison. Each is in a file of its own or with similar ones.

#include "evaluation/reproduce/experiment.hpp"
#include "scenes/scene.hpp"

#include <string>
#include <vector>

namespace pelt::reproduce {

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

}  // namespace pelt::reproduce
