#pragma once

/// The ways to answer a query, behind one face: what the command's --method and the benchmark
/// choose from. All give the same contacts; they differ in the work that they do.

#include <pelt/collide.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace pelt::bench {

enum class MethodKind {
  on_demand,     ///< the public functions: wide tree, nodes opened on demand
  eager,         ///< the same tree and query; all vertices skinned, all boxes exact, bottom-up
  rigid,         ///< the same built afresh over the posed mesh: what a rigid body would cost
  paper,         ///< Kavan & Zara 2005: sphere tree refitted on demand
  paper_eq2,     ///< the same with the un-optimised bound of their eq. 2
  paper_eager,   ///< the paper's rival: all vertices skinned, the same tree refitted bottom-up
  paper_rigid,   ///< a sphere tree built afresh over the posed mesh
  aabb_refit,    ///< van den Bergen 1997: all vertices skinned, a tree of boxes refitted
  aabb_rebuild,  ///< the same tree built afresh
  hybrid,  ///< Larsson & Akenine-Moller 2001: that tree, upper half refitted, the rest on demand
  hash,    ///< Teschner et al. 2003: all triangles hashed into cells
  hash_overlap,  ///< the same where the bodies' boxes overlap, cells sorted
  bd_tree,       ///< James & Pai 2004: spheres from the entries of the joint matrices, on demand
  brute,         ///< every triangle of one against every triangle of the other
};

/// Names as the command line has them, in the order of MethodKind.
std::span<const std::string_view> method_names();
std::string_view name_of(MethodKind kind);
std::optional<MethodKind> find_method(std::string_view name);

/// When a method skins.
enum class Skins {
  first,          ///< all vertices, before anything else is done with a palette
  with_boxes,     ///< all vertices, node by node as the boxes around them are taken
  where_queried,  ///< those that a query comes to
};

Skins skinning_of(MethodKind kind);

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

std::unique_ptr<Method> make_method(MethodKind kind);

}  // namespace pelt::bench
