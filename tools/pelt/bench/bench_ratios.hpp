#pragma once

/// What carries over from machine to machine: how an engine stands to the paper's method, to eager
/// and to rigid.

#include "tools/pelt/bench/bench_report.hpp"

#include <optional>

namespace pelt::tools {

/// Nothing where the yardstick was not measured.
struct Ratios {
  std::optional<double> vs_paper, vs_eager;  ///< how many times faster
  std::optional<double> of_rigid;            ///< how many times the cost
};

bool is_same(const Variant& a, const Variant& b);

/// An engine in a variant, or null.
const Figures* find_figures(const SceneFigures& scene, const std::string& engine,
                            std::uint32_t threads, const Variant& variant);

/// Whether `engine` was measured in any variant.
bool has_engine(const SceneFigures& scene, const std::string& engine);

/// The mean time of an engine on one thread in a variant, or null.
const double* mean_of(const SceneFigures& scene, const std::string& engine, const Variant& variant);

/// Nothing where either is null.
std::optional<double> ratio(const double* dividend, const double* divisor);

/// `figures` is one of the scene's.
Ratios ratios_of(const SceneFigures& scene, const Figures& figures);

/// With two decimals; "-" stands for nothing.
std::string in_words(const std::optional<double>& ratio);

}  // namespace pelt::tools
