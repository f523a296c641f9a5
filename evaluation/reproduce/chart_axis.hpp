#pragma once

/// Ranges and tics of a chart's axes as gnuplot commands.

#include <span>
#include <string>

namespace pelt::reproduce {

/// An axis ("x" or "y") that covers its figures, with a margin so that no mark is cut off.
std::string linear_axis(const std::string& axis, std::span<const double> figures);

/// The same, starting at `from`, so that heights can be compared.
std::string axis_from(const std::string& axis, double from);

/// A logarithmic axis over the positive figures. Labels are at powers of ten, and on a short axis
/// also at twice and five times these. Figures of 0 and less are not shown.
std::string logarithmic_axis(const std::string& axis, std::span<const double> figures);

}  // namespace pelt::reproduce
