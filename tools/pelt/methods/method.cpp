#include "tools/pelt/methods/method.hpp"

#include <algorithm>

namespace pelt::methods {

std::optional<MethodKind> find_method(MethodKinds kinds, std::string_view name) {
  const auto found = std::find_if(kinds.begin(), kinds.end(),
                                  [&](const MethodKind& kind) { return kind.name == name; });
  return found == kinds.end() ? std::nullopt : std::optional(*found);
}

std::vector<std::string_view> names_of(MethodKinds kinds) {
  std::vector<std::string_view> names;
  for (const MethodKind& kind : kinds) names.push_back(kind.name);
  return names;
}

std::string listed(MethodKinds kinds) {
  std::string list;
  for (const MethodKind& kind : kinds) list.append(list.empty() ? "" : ", ").append(kind.name);
  return list;
}

}  // namespace pelt::methods
