#pragma once

/// The methods of --method and `pelt bench`, behind one interface. All find the same contacts; they
/// differ in their work.

#include <pelt/collide.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pelt::methods {

/// Posed bodies, and queries for their contacts. Bodies are numbered in the order of `add`.
class Method {
 public:
  virtual ~Method() = default;

  /// Adds a body. Prepares data that depends only on the model once per model.
  virtual void add(const SkinnedModel& model) = 0;

  /// Sets the weights of a body's morph targets, as Pose::set_morph_weights does, for the next
  /// joint palette; nothing is updated before that. Methods without support for morph targets
  /// reject weights other than zero.
  virtual Result<void> set_morph_weights(std::uint32_t body, std::span<const float> weights) = 0;

  /// Sets the joint palette of a body, and does the work that the method does before queries.
  virtual Result<void> set_palette(std::uint32_t body, std::span<const Matrix4> palette) = 0;

  /// Whether set_palette is part of the method's cost. False for methods that represent rigid
  /// bodies, which have no palettes.
  virtual bool update_counts() const { return true; }

  /// Appends the contacts of two bodies, ascending; see pelt::collide.
  virtual QueryStats collide(std::uint32_t a, std::uint32_t b, std::vector<Contact>& contacts,
                             const Limits& limits) = 0;

  /// The work of set_palette so far; `collide` returns the work of queries.
  virtual QueryStats update_work() const = 0;
};

/// When a method skins vertices.
enum class Skins {
  first,          ///< all vertices, first of all
  with_boxes,     ///< all vertices, node by node with their boxes
  where_queried,  ///< vertices that a query visits
};

/// A method that can be selected by name.
struct MethodKind {
  std::string_view name;  ///< on the command line
  Skins skins;
  std::unique_ptr<Method> (*make)();

  constexpr bool operator==(const MethodKind& other) const { return name == other.name; }
};

/// The methods of a program. Names are unique.
using MethodKinds = std::span<const MethodKind>;

/// The method with this name; nullopt if `kinds` has none.
std::optional<MethodKind> find_method(MethodKinds kinds, std::string_view name);

/// In the order of `kinds`.
std::vector<std::string_view> names_of(MethodKinds kinds);

/// The names, separated by commas, for --help.
std::string listed(MethodKinds kinds);

}  // namespace pelt::methods
