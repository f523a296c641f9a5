#pragma once

/// Poses with all nodes open and with exact boxes (eager), as in methods without refitting on
/// demand, and their contacts. Cost: the functions compute no bound.

#include <pelt/motion.hpp>
#include <pelt/query.hpp>

#include "pose/pose.hpp"
#include "query/scratch.hpp"

#include <optional>
#include <span>
#include <vector>

namespace pelt::detail {

class EagerPose {
 public:
  /// The rest pose, with no node open yet. `tree` must outlive this.
  explicit EagerPose(const Tree& tree);

  /// Copies what poses the vertices of an instance of the same tree, and closes all nodes. Borrows
  /// its given vertices.
  void copy(const Instance& posed);

  /// Copies the morph weights for the next palette, or returns an error if they are invalid.
  Result<void> set_morph_weights(std::span<const float> weights);

  /// Copies the joint palette and closes all nodes. If it is invalid, returns an error and changes
  /// nothing.
  Result<void> set_palette(std::span<const Matrix4> palette);

  /// Skins all vertices and computes all exact boxes bottom-up, including that of the root, so that
  /// queries compute no bound.
  QueryStats open_all();

  /// Returns the view that queries use. Precondition: all nodes are open.
  PosedTree posed_tree();

 private:
  void close_all();

  const Tree& tree_;
  NodeBounds no_bounds_;
  Instance instance_;
  Arena arena_;
};

/// Appends the contacts of two poses, ascending; see pelt::collide. Precondition: all nodes are
/// open in both.
QueryStats collide(EagerPose& a, EagerPose& b, Scratch& scratch, std::vector<Contact>& contacts,
                   const Limits& limits);

/// A step between two poses of one model. Precondition of queries: all nodes are open in both.
struct EagerMotion {
  EagerPose &from, &to;
};

/// Appends the contacts of two steps, ascending; see pelt::collide.
MovingStats collide(const EagerMotion& a, const EagerMotion& b, Scratch& scratch,
                    std::vector<MovingContact>& contacts, const MovingOptions& options);

/// See pelt::first_contact.
MovingStats first_contact(const EagerMotion& a, const EagerMotion& b, Scratch& scratch,
                          std::optional<MovingContact>& first);

}  // namespace pelt::detail
