#pragma once

#include <pelt/collide.hpp>

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace pelt::rivals {

/// Bodies are numbered in the order of `add`.
class PosedMeshMethod {
 public:
  virtual ~PosedMeshMethod() = default;

  /// Adds a body at its rest positions. `triangles` must outlive this object; `rest` is read during
  /// the call only.
  virtual void add(std::span<const Triangle> triangles, std::span<const Vec3> rest) = 0;

  /// Sets the posed vertices of a body. The first call must precede any query of the body.
  /// `positions` must stay unchanged until the next update of the body.
  virtual void update(std::uint32_t body, std::span<const Vec3> positions) = 0;

  /// Appends all contacts of two bodies, or `max_contacts` of them, in no particular order. Returns
  /// the work without skinning and updates.
  virtual QueryStats collide(std::uint32_t a, std::uint32_t b, std::vector<Contact>& contacts,
                             std::uint32_t max_contacts) = 0;
};

// --- methods of other papers, each described in the file that defines it

struct TreeOptions {
  std::uint32_t leaf_triangles = 16;  ///< at most; 1 to 32
};

/// Trees of boxes over posed vertices: aabb.cpp.
std::unique_ptr<PosedMeshMethod> make_aabb_refit(const TreeOptions& options = {});
std::unique_ptr<PosedMeshMethod> make_aabb_rebuild(const TreeOptions& options = {});

/// A tree of boxes whose lower half is refitted on demand: aabb.cpp.
std::unique_ptr<PosedMeshMethod> make_hybrid(const TreeOptions& options = {});

struct HashOptions {
  /// Edge of a cell over the mean edge of the mesh at rest.
  float cell_edges = 3;
};

/// Triangles hashed into cells: hash.cpp.
std::unique_ptr<PosedMeshMethod> make_hash(const HashOptions& options = {});

/// The same, only where the boxes of the bodies overlap: hash_overlap.cpp.
std::unique_ptr<PosedMeshMethod> make_hash_overlap(const HashOptions& options = {});

/// All bodies hashed into one grid, which answers the queries of all pairs: hash.cpp.
/// Precondition of a query: all bodies have been updated.
std::unique_ptr<PosedMeshMethod> make_hash_crowd(const HashOptions& options = {});

}  // namespace pelt::rivals
