/// The program `pelt-lab`: compares Pelt with methods from other papers. It is not installed.

#include "evaluation/methods/lab_methods.hpp"
#include "evaluation/methods/lab_moving_methods.hpp"
#include "evaluation/methods/lab_self_methods.hpp"
#include "evaluation/reproduce/command.hpp"
#include "tools/pelt/arguments/command_line.hpp"
#include "tools/pelt/methods/anytime_methods.hpp"
#include "tools/pelt/verbs/commands.hpp"

namespace {

constexpr const char* kFooter = R"(
`pelt-lab VERB --help` explains each verb with examples. `check` and `bench` are those of the command
`pelt`, with all methods. Exit codes: 0 success (check: nothing that --fail-on selects), 1 what
--fail-on selects (check only; by default any contact), 2 bad input or arguments, 3 internal error.)";

constexpr const char* kBenchNotes = R"(

rigid and paper_rigid show the cost of the same query between rigid bodies: building their trees is
not timed. The column "of rigid" is the cost over that of rigid.

With --self, eager queries the tree of boxes against itself as if it were two characters, and decides
neighbours one by one.

With --moving, united prunes by one box over the whole step instead of by the boxes of both ends, and
finds no first contact.)";

void add_verbs(CLI::App& app, pelt::tools::arguments::Command& chosen) {
  using namespace pelt::tools::verbs;
  add_bench(app, chosen,
            {{pelt::lab::kLabMethods, "paper,paper_eager,eager,on_demand,rigid"},
             {pelt::lab::kLabSelfMethods, "boxes,self,eager"},
             {pelt::lab::kLabMovingMethods, "eager,united,on_demand"},
             {pelt::methods::kCommandAnytimeMethods, "contacts,resolution,first_contact,paper"},
             kBenchNotes});
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
