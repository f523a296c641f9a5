#include "tools/pelt/arguments/verb.hpp"

#include "text/format.hpp"
#include "text/message.hpp"
#include "tools/pelt/output/process.hpp"

#include <CLI/CLI.hpp>

#include <cstdint>
#include <limits>
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

template <typename T>
constexpr bool kIsWhole =
    std::is_same_v<T, std::uint32_t> || std::is_same_v<T, std::optional<std::uint32_t>>;

template <typename T>
constexpr bool kIsDecimal =
    std::is_same_v<T, std::optional<double>> || std::is_same_v<T, std::vector<double>>;

/// Rejects what is not a whole number of the range. CLI11 itself would only print "Could not
/// convert".
CLI::Validator whole_number(const OptionSyntax& syntax) {
  constexpr std::uint32_t kMost = std::numeric_limits<std::uint32_t>::max();
  const std::uint32_t least = syntax.least, most = syntax.most > 0 ? syntax.most : kMost;
  const std::string range = std::to_string(least) + " to " + std::to_string(most);
  const auto check = [least, most, range](const std::string& text) {
    std::uint32_t number = 0;
    if (CLI::detail::lexical_cast(text, number) && number >= least && number <= most)
      return std::string();
    return text::quoted(text) + " is not allowed: give a whole number from " + range;
  };
  return CLI::Validator(check, syntax.most > 0 ? range : "");
}

CLI::Validator decimal_number() {
  const auto check = [](const std::string& text) {
    double number = 0;
    if (CLI::detail::lexical_cast(text, number)) return std::string();
    return text::quoted(text) + " is not a number: give a number such as 0.5";
  };
  return CLI::Validator(check, "");
}

std::string words_of(const CLI::App& verb) {
  std::vector<std::string> arguments, options;
  for (const CLI::Option* option : verb.get_options()) {
    const bool is_flag = option->get_items_expected_max() == 0;
    for (const std::string& result : option->results()) {
      if (option->nonpositional()) options.push_back(option->get_name());
      if (!is_flag)
        (option->nonpositional() ? options : arguments).push_back(text::shell_word(result));
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
  if constexpr (kIsWhole<T>) option->check(whole_number(syntax));
  if constexpr (kIsDecimal<T>) option->check(decimal_number());
  if (syntax.excludes)
    if (CLI::Option* const other = verb_.get_option_no_throw(syntax.excludes))
      option->excludes(other);
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
