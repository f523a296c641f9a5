#pragma once

/// Ranges and tics of a chart's axes, as commands for gnuplot.

#include <span>
#include <string>

namespace pelt::reproduce {

/// An axis ("x" or "y") as long as its figures ask for, and a little more, so that no mark is cut.
std::string linear_axis(const std::string& axis, std::span<const double> figures);

/// The same, but it begins at `from`: heights that compare.
std::string axis_from(const std::string& axis, double from);

/// A logarithmic axis over the positive figures: labels at powers of ten, and at twice and five
/// times these where the axis is short. Figures of 0 and less are not shown.
std::string logarithmic_axis(const std::string& axis, std::span<const double> figures);

}  // namespace pelt::reproduce
