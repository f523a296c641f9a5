/// The command `pelt`: reads the command line, runs the verb, and turns what happened into words
/// and an exit code.

#include <pelt/version.hpp>

#include "asset/message.hpp"
#include "asset/printable.hpp"
#include "scenes/nearest_name.hpp"
#include "tools/pelt/output/output.hpp"
#include "tools/pelt/verbs/commands.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <iostream>
#include <new>

namespace {

using pelt::tools::arguments::ExitCode;

constexpr const char* kFooter = R"(
`pelt VERB --help` explains each verb with examples. Exit codes: 0 success (check: no contact),
1 contact (check only), 2 bad input or arguments, 3 internal error.)";

int code(ExitCode exit) { return static_cast<int>(exit); }

int refuse(const std::string& message) {
  std::cerr << "pelt: error: " << pelt::asset::printable(message) << '\n';
  return code(ExitCode::bad_input);
}

/// No exit code of success where what was to be printed is lost.
int finish(ExitCode exit) {
  const pelt::Result<void> printed = pelt::tools::output::flush_standard_output();
  return printed ? code(exit) : refuse(printed.error().message);
}

/// The option of the verb that was meant by one that it has not, or "".
std::string meant_option(const CLI::App& verb, std::string_view option) {
  option.remove_prefix(std::min(option.find_first_not_of('-'), option.size()));
  std::vector<std::string_view> known;
  for (const CLI::Option* one : verb.get_options())
    known.insert(known.end(), one->get_lnames().begin(), one->get_lnames().end());
  const auto nearest = pelt::scenes::nearest_name(option, known);
  return nearest ? "--" + std::string(*nearest) : "";
}

/// CLI11 says of what a verb does not know only that it "was not expected".
std::string words_for_unread(const CLI::App& verb, const std::string& argument) {
  if (!argument.starts_with('-'))
    return pelt::asset::quoted(argument) + " is an unexpected argument";
  const std::string option = argument.substr(0, argument.find('='));
  const std::string problem = "there is no option " + pelt::asset::quoted(option);
  const std::string meant = meant_option(verb, option);
  return meant.empty() ? problem : problem + ", did you mean " + pelt::asset::quoted(meant) + "?";
}

/// CLI11 says of a missing or unknown verb only that some "subcommand" is required.
std::string words_for(const CLI::App& app, const CLI::ParseError& error) {
  if (!app.get_subcommands().empty()) {
    const CLI::App& verb = *app.get_subcommands()[0];
    const std::vector<std::string> unread = verb.remaining();
    return unread.empty() ? error.what() : words_for_unread(verb, unread[0]);
  }
  const std::vector<std::string> unread = app.remaining();
  const std::vector<const CLI::App*> verbs =
      app.get_subcommands([](const CLI::App*) { return true; });
  std::vector<std::string> names;
  for (const CLI::App* verb : verbs) names.push_back(verb->get_name());
  const std::vector<std::string_view> known(names.begin(), names.end());
  if (unread.empty()) return "no verb is given" + pelt::scenes::suggestion("", known);
  return pelt::asset::quoted(unread[0]) + " is not a verb" +
         pelt::scenes::suggestion(unread[0], known);
}

/// Returns the command that shows help for the arguments.
std::string help_for(const CLI::App& app) {
  const std::vector<CLI::App*> verbs = app.get_subcommands();
  return "pelt " + (verbs.empty() ? "" : verbs[0]->get_name() + " ") + "--help";
}

/// --help and --version end the parse as "errors" with code 0.
int end_of_parse(const CLI::App& app, const CLI::ParseError& error) {
  if (error.get_exit_code() != 0) return refuse(words_for(app, error) + ": see " + help_for(app));
  app.exit(error);
  return finish(ExitCode::success);
}

int run(int argc, char** argv) {
  CLI::App app("Exact collision detection for animated, skinned characters.", "pelt");
  app.set_version_flag("--version", "pelt " PELT_VERSION);
  app.set_help_all_flag("--help-all", "Print the help of all verbs");
  app.require_subcommand(1);
  app.footer(kFooter);
  pelt::tools::arguments::Command command;
  pelt::tools::verbs::add_check(app, command);
  pelt::tools::verbs::add_view(app, command);
  pelt::tools::verbs::add_bounds(app, command);
  pelt::tools::verbs::add_distance(app, command);
  pelt::tools::verbs::add_ray(app, command);
  pelt::tools::verbs::add_region(app, command);
  pelt::tools::verbs::add_info(app, command);
  pelt::tools::verbs::add_prepare(app, command);
  pelt::tools::verbs::add_pose(app, command);
  pelt::tools::verbs::add_demo(app, command);
  pelt::tools::verbs::add_bench(app, command);
  pelt::tools::verbs::add_reproduce(app, command);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return end_of_parse(app, error);
  }
  const pelt::Result<ExitCode> exit = command();
  return exit ? finish(*exit) : refuse(exit.error().message);
}

}  // namespace

int main(int argc, char** argv) {
  pelt::tools::output::reserve_standard_streams();
  try {
    return run(argc, argv);
  } catch (const std::bad_alloc&) {
    std::cerr << "pelt: there is not enough memory: use fewer or smaller characters\n";
    return code(ExitCode::bad_input);
  } catch (const std::exception& error) {
    std::cerr << "pelt: internal error: " << pelt::asset::printable(error.what()) << '\n';
  } catch (...) {
    std::cerr << "pelt: internal error\n";
  }
  return code(ExitCode::internal);
}
