#pragma once

/// Ratios, which can be compared between machines: of a method to the paper's method, to eager, to
/// rigid and to boxes.

#include "tools/pelt/bench/bench_report.hpp"

#include <optional>

namespace pelt::tools::bench {

/// Nullopt if the other method was not measured.
struct Ratios {
  std::optional<double> vs_paper, vs_eager;  ///< speed-ups
  std::optional<double> of_rigid, of_boxes;  ///< costs over these methods
};

bool is_same(const Variant& a, const Variant& b);

/// The figures of a method in a variant, or null.
const Figures* find_figures(const SceneFigures& scene, const std::string& method,
                            std::uint32_t threads, const Variant& variant);

/// Whether `method` was measured in any variant.
bool has_method(const SceneFigures& scene, const std::string& method);

/// The mean time of a method on one thread in a variant, or null.
const double* mean_of(const SceneFigures& scene, const std::string& method, const Variant& variant);

/// Nullopt if either is null.
std::optional<double> ratio(const double* dividend, const double* divisor);

/// Precondition: `figures` belongs to the scene.
Ratios ratios_of(const SceneFigures& scene, const Figures& figures);

/// With two decimals; "-" for nullopt.
std::string in_words(const std::optional<double>& ratio);

}  // namespace pelt::tools::bench
