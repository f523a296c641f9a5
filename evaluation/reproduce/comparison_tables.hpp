#pragma once

/// The tables of the open comparison, each in a file of its own or with its like.

#include "evaluation/reproduce/experiment.hpp"
#include "scenes/scene.hpp"

#include <string>
#include <vector>

namespace pelt::reproduce {

/// Two creatures from apart to one place: "separation" and "separation_first", with charts.
Result<void> add_separation(const scenes::Character& creature, const Conditions& conditions,
                            Section& section);

/// Over the number of triangles: "resolution", with charts.
Result<void> add_resolution(const Conditions& conditions, Section& section);

/// Where the time of a deep contact goes: "time_split".
Result<Table> time_split(const scenes::Character& creature, const Conditions& conditions);

/// Many who walk about: "instances", with a chart.
Result<void> add_instances(const scenes::Character& creature, const Conditions& conditions,
                           Section& section);

/// Hot and cold caches, slow frames and memory, over a clip: "clip".
Result<Table> clip_table(const Conditions& conditions);

/// What people who hash or build trees have to choose: "cell_size", "leaf_size".
Result<Table> cell_sizes(const scenes::Character& creature, const Conditions& conditions);
Result<Table> leaf_sizes(const scenes::Character& creature, const Conditions& conditions);

/// How the contacts of every method differ from those of brute force: "agreement".
Result<Table> agreement(const scenes::Character& creature, const Conditions& conditions);

/// What the tables say, family by family; every number is one of theirs or a ratio of two.
std::vector<std::string> answers_of(const Section& section);

}  // namespace pelt::reproduce
