#pragma once

/// How the time of a query grows, and with what. Each table has a row for each size, and a column
/// for each method.

#include "evaluation/methods/lab_methods.hpp"
#include "evaluation/reproduce/experiment.hpp"

#include <array>

namespace pelt::reproduce {

/// Those that are asked pair by pair.
inline constexpr std::array kPairMethods = {methods::kPaper, methods::kPaperEager, methods::kEager,
                                            methods::kOnDemand};

/// A method as the tables of growth have it.
struct GrowingMethod {
  const char *key, *name;

  Column column() const { return {std::string(key) + "_us", std::string(name) + " [us]"}; }
};

/// In the order of kPairMethods, and the crowd, which stands in one table only.
inline constexpr std::array kGrowingMethods = {
    GrowingMethod{"paper", "paper on demand"}, GrowingMethod{"paper_eager", "paper bottom-up"},
    GrowingMethod{"eager", "Pelt eager"}, GrowingMethod{"on_demand", "Pelt"},
    GrowingMethod{"crowd", "Pelt's crowd"}};

/// Two creatures in each other, of so many triangles each. Column "triangles".
Result<Table> growth_by_triangles(std::span<const std::uint32_t> triangles,
                                  const Conditions& conditions);

/// Of so many joints each. Column "joints".
Result<Table> growth_by_joints(std::span<const std::uint32_t> joints, const Conditions& conditions);

/// Two creatures of so many triangles at distances from each other. Columns "distance", "contacts".
Result<Table> growth_by_depth(std::uint32_t triangles, std::span<const double> distances,
                              const Conditions& conditions);

/// Frames of walking crowds of so many creatures. Methods that are asked pair by pair are left out
/// beyond `most_by_pairs`. Column "instances". Fails where they find other contacts than the crowd.
Result<Table> growth_by_instances(std::span<const std::uint32_t> instances,
                                  std::uint32_t most_by_pairs, const Conditions& conditions);

/// A table of growth, the column that grows, and the one that its chart is drawn over.
struct Growth {
  std::string size;  ///< key
  Table table;
  std::string chart_over = {};  ///< key; empty: what grows
};

/// What power of the size the contacts and each method's time go with.
Table exponents_of(std::span<const Growth> growths);

}  // namespace pelt::reproduce
