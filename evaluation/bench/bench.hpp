#pragma once

#include "evaluation/bench/against.hpp"
#include "tools/pelt/arguments/verb.hpp"
#include "tools/pelt/bench/measure.hpp"

namespace CLI {
class App;
}

namespace pelt::lab {

/// What --against compares without a mode, and with --moving.
extern const ComparedFigures kComparedFrames, kComparedSteps;

/// Before each measurement, reads 64 MB on each thread of the method. At most 30 frames are
/// measured.
tools::bench::Cache cold_cache();

/// Adds the verb `bench` of `pelt-lab`: that of `pelt`, with more methods and modes.
void add_bench(CLI::App& app, tools::arguments::Command& chosen);

}  // namespace pelt::lab
