#pragma once

/// The command line of `pelt bench`: options, and the settings of each mode.

#include "tools/pelt/arguments/model_arguments.hpp"
#include "tools/pelt/bench/bench_anytime.hpp"
#include "tools/pelt/bench/bench_methods.hpp"
#include "tools/pelt/bench/bench_moving.hpp"
#include "tools/pelt/bench/bench_scene.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pelt::tools::arguments {
class Verb;
}

namespace pelt::tools::bench {

inline constexpr const char *kAllQueries = "all,first", *kAllCaches = "hot,cold";

struct BenchArguments {
  std::string program;
  std::vector<std::string> inputs, clips;
  bool is_self = false, is_moving = false, is_anytime = false;
  std::optional<double> fps;
  BenchMethods known;
  std::string methods;
  std::string queries = kAllQueries, caches = kAllCaches;
  std::string threads, json, svg, against, frames, simd;
  std::optional<std::uint32_t> margin;
  std::uint32_t repetitions = kEnoughRepetitions;
  arguments::ModelArguments models;
};

void add_bench_options(arguments::Verb& verb, BenchArguments& arguments);

// Settings of a run without a mode, with --moving and with --anytime, or an error for a value, or
// for options that cannot be combined.
Result<BenchSettings> choose_scene_settings(const BenchArguments& arguments);
Result<MovingSettings> choose_moving_settings(const BenchArguments& arguments);
Result<AnytimeSettings> choose_anytime_settings(const BenchArguments& arguments);

}  // namespace pelt::tools::bench
