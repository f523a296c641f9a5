#pragma once

#include "evaluation/bench/against.hpp"
#include "evaluation/methods/lab_methods.hpp"
#include "tools/pelt/arguments/verb.hpp"
#include "tools/pelt/bench/measure.hpp"

#include <functional>
#include <memory>
#include <string>

namespace CLI {
class App;
}

namespace pelt::lab {

/// The figures that --against compares: without a mode, and with --moving.
extern const ComparedFigures kComparedFrames, kComparedSteps;

/// Before each measurement, reads 64 MB on each thread of the method. At most 30 frames are
/// measured.
tools::bench::Cache cold_cache();

/// Makes a method that starts from posed vertices.
using MakeRival = std::function<std::unique_ptr<rivals::PosedMeshMethod>()>;

/// A rival that is not a method of the command, for pairs of instances, or for each instance
/// against itself.
tools::bench::BenchMethod rival_method(const std::string& name, const MakeRival& make);
tools::bench::BenchMethod self_rival_method(const std::string& name, const MakeRival& make);

/// Adds the verb `bench` of `pelt-lab`: that of `pelt`, with more methods and modes.
void add_bench(CLI::App& app, tools::arguments::Command& chosen);

}  // namespace pelt::lab
