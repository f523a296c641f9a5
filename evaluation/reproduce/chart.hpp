#pragma once

/// Charts as SVG, drawn by gnuplot.

#include <pelt/result.hpp>

#include "evaluation/reproduce/report.hpp"

#include <filesystem>

namespace pelt::reproduce {

/// The commands that make gnuplot draw `chart` into the file `svg`.
std::string gnuplot_script(const Chart& chart, const Table& table,
                           const std::filesystem::path& svg);

/// Draws it. The message of an error says what to do where gnuplot is missing.
Result<void> draw_chart(const Chart& chart, const Table& table, const std::filesystem::path& svg);

}  // namespace pelt::reproduce
