#pragma once

/// How the time of a query grows with various sizes. Each table has a row for each size and a
/// column for each method.

#include "evaluation/methods/lab_methods.hpp"
#include "evaluation/reproduce/report.hpp"

#include <array>
#include <span>

namespace pelt::reproduce {

/// A point of a curve.
struct Measured {
  double size = 0, value = 0;
};

/// The exponent b of the law value = a size^b that fits best (least squares of the logarithms).
/// Ignores points with a size or value of 0. Precondition: the other points have at least two
/// sizes.
double fitted_exponent(std::span<const Measured> points);

/// The methods that are queried pair by pair.
inline constexpr std::array kPairMethods = {methods::kPaper, lab::kPaperEager, methods::kEager,
                                            methods::kOnDemand};

/// A method in the tables of growth.
struct GrowingMethod {
  const char *key, *name;

  Column column() const { return {std::string(key) + "_us", std::string(name) + " [us]"}; }
};

/// The methods of kPairMethods in the same order, then the crowd, which is in one table only.
inline constexpr std::array kGrowingMethods = {
    GrowingMethod{"paper", "paper on demand"}, GrowingMethod{"paper_eager", "paper bottom-up"},
    GrowingMethod{"eager", "Pelt eager"}, GrowingMethod{"on_demand", "Pelt"},
    GrowingMethod{"crowd", "Pelt's crowd"}};

/// Two intersecting creatures with these numbers of triangles each. Column "triangles".
Result<Table> growth_by_triangles(std::span<const std::uint32_t> triangles,
                                  const Conditions& conditions);

/// The same with these numbers of joints. Column "joints".
Result<Table> growth_by_joints(std::span<const std::uint32_t> joints, const Conditions& conditions);

/// Two creatures at these distances from each other. Columns "distance", "contacts".
Result<Table> growth_by_depth(std::uint32_t triangles, std::span<const double> distances,
                              const Conditions& conditions);

/// Frames of walking crowds of these sizes. Leaves out methods that are queried pair by pair beyond
/// `most_by_pairs`. Column "instances". Fails if they find other contacts than the crowd.
Result<Table> growth_by_instances(std::span<const std::uint32_t> instances,
                                  std::uint32_t most_by_pairs, const Conditions& conditions);

/// A table of growth, the column that grows, and the column that is the x axis of its chart.
struct Growth {
  std::string size;  ///< key
  Table table;
  std::string chart_over = {};  ///< key; empty: what grows
};

/// The exponents with which the contacts and each method's time grow over the size.
Table exponents_of(std::span<const Growth> growths);

}  // namespace pelt::reproduce
