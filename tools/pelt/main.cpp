#include "tools/pelt/verbs/commands.hpp"

int main(int argc, char** argv) {
  return pelt::tools::arguments::run_process(pelt::tools::verbs::kPelt, argc, argv);
}
