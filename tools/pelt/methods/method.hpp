#pragma once

/// The ways to answer a query, behind one interface: what --method and `pelt bench` choose from.
/// All give the same contacts; they differ in the work that they do.

#include <pelt/collide.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pelt::methods {

/// Posed bodies that can be asked for their contacts. Bodies are numbered in the order of `add`.
class Method {
 public:
  virtual ~Method() = default;

  /// Adds a body. What depends on the model alone is prepared here, once for each model.
  virtual void add(const SkinnedModel& model) = 0;

  /// The weights of a body's morph targets, as Pose::set_morph_weights takes them, for the joint
  /// palette that is set next: nothing is updated before that. Methods that know no morph targets
  /// refuse weights other than zero.
  virtual Result<void> set_morph_weights(std::uint32_t body, std::span<const float> weights) = 0;

  /// Gives body `body` its joint palette, and does what the method does before it can answer.
  virtual Result<void> set_palette(std::uint32_t body, std::span<const Matrix4> palette) = 0;

  /// Whether set_palette is part of what the method costs. Not of those that stand for rigid
  /// bodies, which have no palettes.
  virtual bool update_counts() const { return true; }

  /// Appends the contacts of two bodies, ascending; see pelt::collide.
  virtual QueryStats collide(std::uint32_t a, std::uint32_t b, std::vector<Contact>& contacts,
                             const CollideOptions& options) = 0;

  /// The work done in set_palette so far; the work of queries is what collide returns.
  virtual QueryStats update_work() const = 0;
};

/// When a method skins.
enum class Skins {
  first,          ///< all vertices, before anything else is done with a palette
  with_boxes,     ///< all vertices, node by node as the boxes around them are taken
  where_queried,  ///< those that a query comes to
};

/// A method that can be chosen by its name.
struct MethodKind {
  std::string_view name;  ///< as the command line has it
  Skins skins;
  std::unique_ptr<Method> (*make)();

  constexpr bool operator==(const MethodKind& other) const { return name == other.name; }
};

/// The methods that a program offers. Names are unique.
using MethodKinds = std::span<const MethodKind>;

/// The method with this name; nullopt if `kinds` has none.
std::optional<MethodKind> find_method(MethodKinds kinds, std::string_view name);

/// In the order of `kinds`.
std::vector<std::string_view> names_of(MethodKinds kinds);

/// The names with commas between them, for --help.
std::string listed(MethodKinds kinds);

}  // namespace pelt::methods
