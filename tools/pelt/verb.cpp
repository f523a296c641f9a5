#include "tools/pelt/verb.hpp"

#include <CLI/CLI.hpp>

#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace pelt::tools {
namespace {

template <typename T>
constexpr bool kIsSingle = std::is_arithmetic_v<T> || std::is_same_v<T, std::string>;

template <typename T>
constexpr bool kIsList = false;
template <typename T>
constexpr bool kIsList<std::vector<T>> = true;

}  // namespace

Verb::Verb(CLI::App& app, const char* name, const char* description, const char* footer)
    : verb_(*app.add_subcommand(name, description)) {
  verb_.footer(footer);
}

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

void Verb::flag(const char* name, bool& value, const char* help) {
  verb_.add_flag(name, value, help);
}

void Verb::runs(Command command, Command& chosen) {
  verb_.callback([command = std::move(command), &chosen] { chosen = command; });
}

}  // namespace pelt::tools
