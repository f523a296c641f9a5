#include "tools/pelt/arguments/command_line.hpp"

#include <pelt/version.hpp>

#include "text/format.hpp"
#include "text/message.hpp"
#include "text/printable.hpp"
#include "tools/pelt/output/output_file.hpp"
#include "tools/pelt/output/process.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <iostream>
#include <new>

namespace pelt::tools::arguments {
namespace {

int code(ExitCode exit) { return static_cast<int>(exit); }

int refuse(const Program& program, const std::string& message) {
  std::cerr << program.name << ": error: " << text::printable(message) << '\n';
  return code(ExitCode::bad_input);
}

/// Lost output must not end in an exit code of success.
int finish(const Program& program, ExitCode exit) {
  const Result<void> printed = output::flush_standard_output();
  return printed ? code(exit) : refuse(program, printed.error().message);
}

/// The option of the verb that was probably meant by an unknown one, or "".
std::string meant_option(const CLI::App& verb, std::string_view option) {
  option.remove_prefix(std::min(option.find_first_not_of('-'), option.size()));
  std::vector<std::string_view> known;
  for (const CLI::Option* one : verb.get_options())
    known.insert(known.end(), one->get_lnames().begin(), one->get_lnames().end());
  const auto closest = text::closest_name(option, known);
  return closest ? "--" + std::string(*closest) : "";
}

/// For an argument that the verb does not know, CLI11 only says that it "was not expected".
std::string words_for_unread(const CLI::App& verb, const std::string& argument) {
  if (!argument.starts_with('-')) return text::quoted(argument) + " is an unexpected argument";
  const std::string option = argument.substr(0, argument.find('='));
  const std::string problem = "there is no option " + text::quoted(option);
  const std::string meant = meant_option(verb, option);
  return meant.empty() ? problem : problem + ", did you mean " + text::quoted(meant) + "?";
}

/// For a missing or unknown verb, CLI11 only says that some "subcommand" is required.
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
  names.reserve(verbs.size());
  for (const CLI::App* verb : verbs) names.push_back(verb->get_name());
  const std::vector<std::string_view> known(names.begin(), names.end());
  if (unread.empty()) return "no verb is given" + text::suggestion("", known);
  return text::quoted(unread[0]) + " is not a verb" + text::suggestion(unread[0], known);
}

/// Returns the command that shows help for the arguments.
std::string help_for(const CLI::App& app) {
  const std::vector<CLI::App*> verbs = app.get_subcommands();
  return app.get_name() + " " + (verbs.empty() ? "" : verbs[0]->get_name() + " ") + "--help";
}

/// --help and --version end the parse as "errors" with code 0.
int end_of_parse(const Program& program, const CLI::App& app, const CLI::ParseError& error) {
  if (error.get_exit_code() != 0)
    return refuse(program, words_for(app, error) + ": see " + help_for(app));
  app.exit(error);
  return finish(program, ExitCode::success);
}

/// The files that the verb was given, at most three of them: "a.glb, b.glb: "; or "".
std::string names_of_inputs(const CLI::App& verb) {
  constexpr std::size_t kShown = 3;
  std::vector<std::string> inputs;
  for (const CLI::Option* option : verb.get_options()) {
    if (!option->nonpositional())
      inputs.insert(inputs.end(), option->results().begin(), option->results().end());
  }
  std::string names;
  for (std::size_t i = 0; i < std::min(inputs.size(), kShown); ++i)
    names += (i > 0 ? ", " : "") + inputs[i];
  if (inputs.size() > kShown) names += ", ...";
  return names.empty() ? "" : names + ": ";
}

std::string out_of_memory(const CLI::App& app) {
  const CLI::App& verb = *app.get_subcommands()[0];
  return names_of_inputs(verb) + app.get_name() + " " + verb.get_name() +
         " needs more memory than there is: free some, or use fewer or smaller characters";
}

/// Memory that is freed when an allocation fails for the first time, because destructors of JSON
/// values and error messages allocate.
std::atomic<void*> reserve = nullptr;

void free_reserve_and_throw() {
  std::free(reserve.exchange(nullptr));
  std::set_new_handler(nullptr);
  throw std::bad_alloc();
}

/// Returns false if there is too little memory, even for exceptions.
bool reserve_memory_for_errors() {
  constexpr std::size_t kReserve = std::size_t{1} << 20;
  reserve = std::malloc(kReserve);
  std::set_new_handler(free_reserve_and_throw);
  return reserve != nullptr;
}

int refuse_to_start(const Program& program) {
  std::cerr << program.name << ": error: there is too little memory to start: free some\n";
  return code(ExitCode::bad_input);
}

int run_verb(const Program& program, const CLI::App& app, const Command& command) {
  try {
    const Result<ExitCode> exit = command();
    return exit ? finish(program, *exit) : refuse(program, exit.error().message);
  } catch (const std::bad_alloc&) {
    return refuse(program, out_of_memory(app));
  }
}

/// The choices of an option that may be given without a value (see Verb::choice), or none.
std::vector<std::string> choices_of(const CLI::App* verb, const std::string& argument) {
  const CLI::Option* option = verb == nullptr ? nullptr : verb->get_option_no_throw(argument);
  if (option == nullptr || option->get_expected_min() != 0 || option->get_expected_max() != 1)
    return {};
  const std::string names = option->get_type_name();
  const std::vector<std::string_view> choices = text::split(names, '|');
  return {choices.begin(), choices.end()};
}

/// Returns the arguments in reverse order, as CLI11 expects them, and with "--self only" and
/// "--self" as "--self=only" and "--self=yes". Otherwise, CLI11 reads any argument after "--self"
/// as its value.
std::vector<std::string> arguments_of(const CLI::App& app, int argc, char** argv) {
  const std::vector<std::string> given(argv + 1, argv + argc);
  const auto verbs = app.get_subcommands(
      [&](const CLI::App* one) { return !given.empty() && one->get_name() == given[0]; });
  const CLI::App* const verb = verbs.empty() ? nullptr : verbs[0];
  std::vector<std::string> arguments;
  for (std::size_t i = 0; i < given.size(); ++i) {
    arguments.push_back(given[i]);
    const std::vector<std::string> choices = choices_of(verb, given[i]);
    if (choices.empty()) continue;
    const bool has_value = i + 1 < given.size() &&
                           std::find(choices.begin(), choices.end(), given[i + 1]) != choices.end();
    arguments.back().append("=").append(has_value ? given[++i] : choices[0]);
  }
  std::reverse(arguments.begin(), arguments.end());
  return arguments;
}

int run(const Program& program, int argc, char** argv) {
  CLI::App app(program.description, program.name);
  app.set_version_flag("--version", std::string(program.name) + " " PELT_VERSION);
  app.set_help_all_flag("--help-all", "Print the help of all verbs");
  app.require_subcommand(1);
  app.footer(program.footer);
  Command command;
  program.add_verbs(app, command);
  try {
    app.parse(arguments_of(app, argc, argv));
  } catch (const CLI::ParseError& error) {
    return end_of_parse(program, app, error);
  }
  return run_verb(program, app, command);
}

}  // namespace

int run_command_line(const Program& program, int argc, char** argv) {
  try {
    return run(program, argc, argv);
  } catch (const std::bad_alloc&) {
    return refuse_to_start(program);
  } catch (const std::exception& error) {
    std::cerr << program.name << ": internal error: " << text::printable(error.what()) << '\n';
  } catch (...) {
    std::cerr << program.name << ": internal error\n";
  }
  return code(ExitCode::internal);
}

int run_process(const Program& program, int argc, char** argv) {
  output::reserve_standard_streams();
  output::remove_unfinished_files_on_signals();
  output::limit_memory();
  if (!reserve_memory_for_errors()) return refuse_to_start(program);
  return run_command_line(program, argc, argv);
}

}  // namespace pelt::tools::arguments
