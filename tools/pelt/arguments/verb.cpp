#include "tools/pelt/arguments/verb.hpp"

#include <CLI/CLI.hpp>

#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace pelt::tools::arguments {
namespace {

template <typename T>
constexpr bool kIsSingle = std::is_arithmetic_v<T> || std::is_same_v<T, std::string>;

template <typename T>
constexpr bool kIsList = false;
template <typename T>
constexpr bool kIsList<std::vector<T>> = true;

/// Quotes a word for a shell.
std::string shell_word(const std::string& word) {
  constexpr const char* kPlain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-./,:=+@%";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::string quoted(1, '\'');
  for (const char c : word) quoted.append(c == '\'' ? "'\\''" : std::string(1, c));
  return quoted.append(1, '\'');
}

std::string words_of(const CLI::App& verb) {
  std::vector<std::string> arguments, options;
  for (const CLI::Option* option : verb.get_options()) {
    const bool is_flag = option->get_items_expected_max() == 0;
    for (const std::string& result : option->results()) {
      if (option->nonpositional()) options.push_back(option->get_name());
      if (!is_flag) (option->nonpositional() ? options : arguments).push_back(shell_word(result));
    }
  }
  std::string words = verb.get_parent()->get_name() + " " + verb.get_name();
  for (const auto* list : {&arguments, &options}) {
    for (const std::string& word : *list) words.append(" ").append(word);
  }
  return words;
}

}  // namespace

Verb::Verb(CLI::App& app, const char* name, const char* description, const char* footer)
    : verb_(*app.add_subcommand(name, description)) {
  verb_.footer(footer);
}

std::string Verb::program() const { return verb_.get_parent()->get_name(); }

template <typename T>
void Verb::option(const char* name, T& value, const std::string& help, const OptionSyntax& syntax) {
  CLI::Option* const option = verb_.add_option(name, value, help);
  option->required(syntax.is_required);
  if (syntax.type) option->type_name(syntax.type);
  if (syntax.most > 0) option->check(CLI::Range(0, syntax.most));
  if (syntax.excludes) option->excludes(verb_.get_option(syntax.excludes));
  if (syntax.group) option->group(syntax.group);
  if (kIsList<T> && option->nonpositional()) option->allow_extra_args(false);
  if (kIsSingle<T> && !syntax.is_required) option->capture_default_str();
}

template void Verb::option(const char*, std::string&, const std::string&, const OptionSyntax&);
template void Verb::option(const char*, std::uint32_t&, const std::string&, const OptionSyntax&);
template void Verb::option(const char*, std::optional<std::uint32_t>&, const std::string&,
                           const OptionSyntax&);
template void Verb::option(const char*, std::optional<double>&, const std::string&,
                           const OptionSyntax&);
template void Verb::option(const char*, std::vector<std::string>&, const std::string&,
                           const OptionSyntax&);
template void Verb::option(const char*, std::vector<double>&, const std::string&,
                           const OptionSyntax&);

void Verb::choice(const char* name, std::string& value, const char* choices, const char* help) {
  verb_.add_option(name, value, help)->type_name(choices)->expected(0, 1);
}

void Verb::flag(const char* name, bool& value, const char* help) {
  verb_.add_flag(name, value, help);
}

void Verb::runs(Command command, Command& chosen) {
  verb_.callback([command = std::move(command), &chosen, &verb = verb_, words = words_] {
    if (words) *words = words_of(verb);
    chosen = command;
  });
}

}  // namespace pelt::tools::arguments
