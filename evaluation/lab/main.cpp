/// The program `pelt-lab`: compares Pelt with methods from other papers. It is not installed.

#include "evaluation/bench/bench.hpp"
#include "evaluation/methods/lab_methods.hpp"
#include "evaluation/reproduce/command.hpp"
#include "tools/pelt/verbs/commands.hpp"

namespace {

constexpr const char* kFooter = R"(
`pelt-lab VERB --help` explains each verb with examples. `check` is that of the command `pelt`, with all
methods; `bench` also has more modes. Exit codes: 0 success (check: nothing that --fail-on selects), 1 what
--fail-on selects (check only; by default any contact), 2 bad input or arguments, 3 internal error.)";

void add_verbs(CLI::App& app, pelt::tools::arguments::Command& chosen) {
  using namespace pelt::tools::verbs;
  pelt::lab::add_bench(app, chosen);
  add_check(app, chosen, pelt::lab::kLabMethods);
  add_merge(app, chosen, pelt::lab::kLabMethods);
  add_reproduce(app, chosen);
}

}  // namespace

int main(int argc, char** argv) {
  return pelt::tools::arguments::run_process(
      {"pelt-lab", "Compares Pelt with methods from other papers.", kFooter, add_verbs}, argc,
      argv);
}
