#pragma once

/// Charts as SVG, drawn by gnuplot.

#include <pelt/result.hpp>

#include "evaluation/reproduce/report.hpp"

#include <filesystem>

namespace pelt::reproduce {

/// The gnuplot commands that draw `chart` into the file `svg`.
std::string gnuplot_script(const Chart& chart, const Table& table,
                           const std::filesystem::path& svg);

/// Draws the chart. If gnuplot is missing, the error message says what to do.
Result<void> draw_chart(const Chart& chart, const Table& table, const std::filesystem::path& svg);

}  // namespace pelt::reproduce
