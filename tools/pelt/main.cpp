#include "tools/pelt/program.hpp"

int main(int argc, char** argv) {
  return pelt::tools::arguments::run_process(pelt::tools::kPelt, argc, argv);
}
