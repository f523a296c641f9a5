#include "volume/self_pairs.hpp"

#include "query/find_triangle.hpp"
#include "query/sort_contacts.hpp"
#include "self/self_tree.hpp"

#include <algorithm>
#include <limits>
#include <span>

namespace pelt::detail {
namespace {

/// Self-collision leaves out pairs of triangles that touch only at surface vertices that they
/// share. If a surface vertex is split into vertices that can move apart, triangles with different
/// ones of these share it only because they are in the same position now.
class PairsAtCracks {
 public:
  PairsAtCracks(const PosedTree& posed, const Surface& surface, const Fans& fans,
                Stack<Contact>& pairs, QueryStats& work)
      : ids_(posed.tree.triangle_ids.data()),
        surface_(surface),
        fans_(fans),
        reader_s_(posed),
        reader_t_(posed),
        pairs_(pairs),
        work_(work) {}

  void add_all() {
    for (const FanRun& run : fans_.runs)
      for (std::uint32_t fan = run.first_fan; run.kind == FanKind::cracked && fan < run.end; ++fan)
        add(fans_[fan]);
  }

 private:
  void add(std::span<const FanTriangle> fan) {
    for (const FanTriangle& s : fan)
      for (const FanTriangle& t : fan)
        if (ids_[s.place()] < ids_[t.place()] && share_by_position(s.place(), t.place()))
          pairs_.push({ids_[s.place()], ids_[t.place()]});
  }

  /// Whether two triangles have different vertices of one surface vertex in the same position.
  bool share_by_position(std::uint32_t s, std::uint32_t t) {
    const TriangleCorners corners_s = reader_s_.corners(ids_[s], work_);
    const TriangleCorners corners_t = reader_t_.corners(ids_[t], work_);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k)
        if (corners_s[i] == corners_t[k] && fans_.corners[s][i] == fans_.corners[t][k] &&
            surface_.corners[ids_[s]][i] != surface_.corners[ids_[t]][k])
          return true;
    return false;
  }

  const std::uint32_t* ids_;
  const Surface& surface_;
  const Fans& fans_;
  TriangleReader reader_s_, reader_t_;
  Stack<Contact>& pairs_;
  QueryStats& work_;
};

}  // namespace

QueryStats find_self_pairs(const PosedTree& posed, const Surface& surface,
                           const SelfFilter& neighbours, Scratch& scratch) {
  QueryStats work = self_collide_tree(posed, neighbours, nullptr, scratch,
                                      std::numeric_limits<std::uint32_t>::max());
  PairsAtCracks(posed, surface, neighbours.fans, scratch.found, work).add_all();
  sort_contacts(scratch.found, scratch.sorting);
  const Contact* const end = std::unique(scratch.found.begin(), scratch.found.end());
  scratch.found.shrink(static_cast<std::size_t>(end - scratch.found.begin()));
  return work;
}

}  // namespace pelt::detail
