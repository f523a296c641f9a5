#pragma once

/// The methods of `pelt-lab bench --anytime`, behind one interface: searches that can be stopped
/// after any amount of work, and resumed. All find the same contacts in the end.

#include <pelt/collide.hpp>

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

namespace pelt::lab {

/// The knowledge of a search about two bodies.
struct Known {
  std::uint64_t contacts = 0;         ///< found so far
  std::uint64_t undecided_pairs = 0;  ///< of triangles
  double resolution = 0;              ///< longest side of the boxes that can contain other contacts
};

/// Posed bodies, and a search for the contacts of two of them. Bodies are numbered in the order of
/// `add`.
class AnytimeMethod {
 public:
  virtual ~AnytimeMethod() = default;

  virtual void add(const SkinnedModel& model) = 0;

  /// Sets the weights of a body's morph targets for the next joint palette.
  virtual Result<void> set_morph_weights(std::uint32_t body, std::span<const float> weights) = 0;

  virtual Result<void> set_palette(std::uint32_t body, std::span<const Matrix4> palette) = 0;

  /// Selects the bodies of the next searches. Allocates what depends on the selection.
  virtual void select(std::uint32_t a, std::uint32_t b) = 0;

  /// Starts a search of the selected bodies with their current palettes.
  virtual void restart() = 0;

  /// Searches until `work` units (`work_of`) are done since the search was started, or nothing is
  /// undecided.
  virtual void advance_to(std::uint64_t work) = 0;

  virtual bool is_complete() const = 0;
  virtual std::uint64_t work_done() const = 0;

  /// Units of the longest step, which cannot be stopped.
  virtual std::uint64_t longest_step() const = 0;

  virtual Known known() const = 0;

  /// The contacts found so far, in any order.
  virtual std::span<const Contact> contacts() const = 0;
};

/// A method that can be selected by name.
struct AnytimeMethodKind {
  std::string_view name;   ///< on the command line
  std::string_view title;  ///< in a chart
  std::unique_ptr<AnytimeMethod> (*make)();

  constexpr bool operator==(const AnytimeMethodKind& other) const { return name == other.name; }
};

std::unique_ptr<AnytimeMethod> make_anytime_contacts();
std::unique_ptr<AnytimeMethod> make_anytime_resolution();
std::unique_ptr<AnytimeMethod> make_anytime_first_contact();
std::unique_ptr<AnytimeMethod> make_anytime_paper();

/// The orders of a CollisionSearch.
inline constexpr AnytimeMethodKind kAnytimeContacts = {"contacts", "order contacts",
                                                       make_anytime_contacts};
inline constexpr AnytimeMethodKind kAnytimeResolution = {"resolution", "order resolution",
                                                         make_anytime_resolution};
inline constexpr AnytimeMethodKind kAnytimeFirstContact = {"first_contact", "order first_contact",
                                                           make_anytime_first_contact};

/// The paper's sphere tree, refitted on demand, one level after the other.
inline constexpr AnytimeMethodKind kAnytimePaper = {
    "paper", "sphere tree of the paper, breadth first", make_anytime_paper};

inline constexpr std::array kAnytimeMethods = {kAnytimeContacts, kAnytimeResolution,
                                               kAnytimeFirstContact, kAnytimePaper};

}  // namespace pelt::lab
