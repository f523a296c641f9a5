#pragma once

/// Draws charts as SVG, by gnuplot, and pictures as PNG, by POV-Ray.

#include <pelt/result.hpp>

#include "evaluation/reproduce/report.hpp"

#include <filesystem>
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

/// The gnuplot commands that draw `chart` into the file `svg`.
std::string gnuplot_script(const Chart& chart, const Table& table,
                           const std::filesystem::path& svg);

/// Draws the chart. If gnuplot is missing, the error message says what to do.
Result<void> draw_chart(const Chart& chart, const Table& table, const std::filesystem::path& svg);

/// Renders the picture into the file `png`. If POV-Ray is missing, the error message says what to
/// do.
Result<void> render(const Picture& picture, const std::filesystem::path& png);

}  // namespace pelt::reproduce
