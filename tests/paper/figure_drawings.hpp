#pragma once

#include <string>

namespace pelt::test {

/// The SVG files docs/figures/figure2.svg and figure3.svg.
std::string draw_figure2();
std::string draw_figure3();

}  // namespace pelt::test
