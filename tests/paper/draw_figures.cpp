/// Writes figure2.svg and figure3.svg into the folder named on the command line: docs/figures.

#include "figure_drawings.hpp"

#include <cstdio>
#include <fstream>

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: draw_figures FOLDER\n");
    return 2;
  }
  const std::string folder = argv[1];
  std::ofstream figure2(folder + "/figure2.svg"), figure3(folder + "/figure3.svg");
  figure2 << pelt::test::draw_figure2();
  figure3 << pelt::test::draw_figure3();
  return figure2.flush() && figure3.flush() ? 0 : 1;
}
