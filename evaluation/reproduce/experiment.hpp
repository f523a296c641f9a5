#pragma once

/// The experiments of Kavan & Zara 2005, section 5, and additional ones, each in a file of its own.

#include <pelt/result.hpp>

#include "evaluation/reproduce/report.hpp"

#include <filesystem>
#include <functional>
#include <span>

namespace pelt::reproduce {

struct Conditions {
  bool is_quick = false;         ///< fewer frames, repetitions and sizes
  std::filesystem::path models;  ///< a folder with real characters; empty: generated ones only
};

struct Experiment {
  const char* id;
  const char* title;
  Result<Section> (*run)(const Conditions& conditions);
};

/// In the order of the report.
std::span<const Experiment> experiments();

/// The comparison with other libraries, which follows them. Null in a build without the adapters
/// (PELT_BENCH_PEERS).
const Experiment* peers_experiment();

Result<Section> characters(const Conditions& conditions);      // characters.cpp
Result<Section> sphere_trees(const Conditions& conditions);    // sphere_trees.cpp
Result<Section> tightness(const Conditions& conditions);       // tightness.cpp
Result<Section> refit_cost(const Conditions& conditions);      // refit_cost.cpp
Result<Section> two_men(const Conditions& conditions);         // walking.cpp
Result<Section> worst_case(const Conditions& conditions);      // walking.cpp
Result<Section> subdivision(const Conditions& conditions);     // subdivision.cpp
Result<Section> crowd_of_fifty(const Conditions& conditions);  // walking.cpp
Result<Section> real_pairs(const Conditions& conditions);      // real_pairs.cpp
Result<Section> growth(const Conditions& conditions);          // growth.cpp
Result<Section> self_collision(const Conditions& conditions);  // self_collision.cpp
Result<Section> between_frames(const Conditions& conditions);  // between_frames.cpp
Result<Section> comparison(const Conditions& conditions);      // comparison.cpp
Result<Section> peers(const Conditions& conditions);           // peers.cpp

}  // namespace pelt::reproduce
