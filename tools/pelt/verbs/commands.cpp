#include "tools/pelt/verbs/commands.hpp"

#include "tools/pelt/methods/command_methods.hpp"

namespace pelt::tools::verbs {
namespace {

constexpr const char* kFooter = R"(
`pelt VERB --help` explains each verb with examples. Exit codes: 0 success (check, merge: nothing
that --fail-on selects), 1 what --fail-on selects (check and merge only; by default any contact),
2 bad input or arguments, 3 internal error.)";

void add_verbs(CLI::App& app, arguments::Command& chosen) {
  add_check(app, chosen, methods::kCommandMethods);
  add_merge(app, chosen, methods::kCommandMethods);
  add_view(app, chosen);
  add_bounds(app, chosen);
  add_distance(app, chosen);
  add_ray(app, chosen);
  add_region(app, chosen);
  add_info(app, chosen);
  add_prepare(app, chosen);
  add_pose(app, chosen);
  add_demo(app, chosen);
  add_bench(app, chosen);
}

}  // namespace

const arguments::Program kPelt = {
    "pelt", "Exact collision detection for animated, skinned characters.", kFooter, add_verbs};

}  // namespace pelt::tools::verbs
