#include "pose/open_node.hpp"
#include "model/node_box.hpp"
#include "pose/pool_vertices.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {
namespace {

Vec3 vector_at(const float* v) { return {v[0], v[1], v[2]}; }

/// Poses the run of vertices with kCount influences that starts at `place`, and returns the end of
/// the run. A loop over influences of known length needs no branch.
template <std::uint32_t kCount, typename RestAt>
std::uint32_t pose_run(const VertexArrays& arrays, const RestAt& rest_at, const Matrix4* palette,
                       std::uint32_t place, std::uint32_t end, float*& out) {
  for (; place < end && arrays.influence_count(place) == kCount; ++place, out += kFloatsPerVertex)
    store4(out, arrays.pose(vector_at(rest_at(place, out)), place, kCount, palette));
  return place;
}

/// Poses a pool, which is sorted by number of influences. `rest_at(place, out)` returns the three
/// coordinates of the rest position of a vertex, where `out` is the destination of the posed
/// vertex.
template <typename RestAt>
void pose_linear_pool(const Tree& tree, const RestAt& rest_at, const Matrix4* palette,
                      std::uint32_t place, std::uint32_t end, float* out) {
  const VertexArrays arrays(tree);
  place = pose_run<1>(arrays, rest_at, palette, place, end, out);
  place = pose_run<2>(arrays, rest_at, palette, place, end, out);
  place = pose_run<3>(arrays, rest_at, palette, place, end, out);
  place = pose_run<4>(arrays, rest_at, palette, place, end, out);
  for (; place < end; ++place, out += kFloatsPerVertex)
    store4(out, arrays.pose(vector_at(rest_at(place, out)), place, arrays.influence_count(place),
                            palette));
}

template <typename RestAt>
void pose_pool(const PosedTree& posed, const Node& node, const RestAt& rest_at, float* out) {
  const std::uint32_t begin = node.first_vertex, end = begin + node.vertex_count;
  if (posed.palette.is_dual())
    pose_dual_pool(posed.tree, rest_at, posed.palette, begin, end, out);
  else
    pose_linear_pool(posed.tree, rest_at, posed.palette.joints().data(), begin, end, out);
}

void pose_node(const PosedTree& posed, const Node& node, float* out) {
  const Vec3* rest = posed.tree.rest_positions.data();
  pose_pool(
      posed, node, [=](std::size_t place, const float*) { return &rest[place].x; }, out);
}

/// Poses a pool from the displaced rest positions that `morph_pool` has written to `out`.
void pose_morphed_node(const PosedTree& posed, const Node& node, float* out) {
  pose_pool(
      posed, node, [](std::size_t, const float* rest) { return rest; }, out);
}

/// Adds offsets to a posed pool. Returns how many of them were clamped.
[[gnu::noinline]] std::uint64_t offset_pool(const PosedTree& posed, const Node& node,
                                            float* positions) {
  const std::uint32_t* const vertices = posed.tree.place_vertices.data() + node.first_vertex;
  const float* const caps = posed.tree.offset_caps.data() + node.first_vertex;
  const Vec3* const offsets = posed.palette.offsets().data();
  std::uint64_t clamped = 0;
  for (std::uint32_t v = 0; v < node.vertex_count; ++v) {
    float* const p = positions + std::size_t{kFloatsPerVertex} * v;
    store4(p, offset_vertex4(load4(p), offsets[vertices[v]], caps[v]));
    clamped += is_clamped(offsets[vertices[v]], caps[v]);
  }
  return clamped;
}

/// Poses a pool and counts the work.
const float* pose_pool_of(const PosedTree& posed, std::uint32_t index, QueryStats& work) {
  const Node& node = posed.tree.nodes[index];
  auto* positions = reinterpret_cast<float*>(
      posed.arena.allocate(std::size_t{node.vertex_count} * kFloatsPerVertex * sizeof(float)));
  const MorphWeights& morphs = posed.palette.morphs();
  const std::uint64_t displaced =
      morphs.any() ? morph_pool(posed.tree, index, morphs, positions) : 0;
  displaced > 0 ? pose_morphed_node(posed, node, positions) : pose_node(posed, node, positions);
  if (!posed.palette.offsets().empty()) work.clamped_offsets += offset_pool(posed, node, positions);
  work.posed_vertices += node.vertex_count;
  work.displacements += displaced;
  return positions;
}

/// Creates an unpublished node, poses its pool and counts the work.
OpenedNode* begin_node(const PosedTree& posed, std::uint32_t index, QueryStats& work) {
  const Node& node = posed.tree.nodes[index];
  OpenedNode* opened = posed.arena.allocate<OpenedNode>();
  opened->positions =
      posed.given ? posed.given.at(node.first_vertex) : pose_pool_of(posed, index, work);
  work.refits += node.cluster_count + node.child_count;
  return opened;
}

Box4 cluster_box(const Tree& tree, const Cluster& cluster, const float* positions) {
  const std::uint16_t* vertex = tree.cluster_vertices.data() + cluster.first_vertex;
  const std::uint16_t* end = vertex + cluster.listed_vertex_count();
  const auto position = [&](int i) { return load4(positions + vertex[i]); };
  Box4 box = {position(0), position(0)};
  for (; vertex != end; vertex += kVertexPadding) {
    const Float4 a = position(0), b = position(1), c = position(2), d = position(3);
    box = unite(box, {min(min(a, b), min(c, d)), max(max(a, b), max(c, d))});
  }
  return box;
}

/// Writes eight boxes in structure-of-arrays order, starting at lane `first`.
template <std::size_t kCount>
void store_boxes(const Box4 (&box)[8], float (&low)[3][kCount], float (&high)[3][kCount],
                 std::uint32_t first) {
  const auto store = [first](const Points8& lanes, float(&rows)[3][kCount]) {
    lanes.x.store(rows[0] + first);
    lanes.y.store(rows[1] + first);
    lanes.z.store(rows[2] + first);
  };
  store(transpose8(box[0].low, box[1].low, box[2].low, box[3].low, box[4].low, box[5].low,
                   box[6].low, box[7].low),
        low);
  store(transpose8(box[0].high, box[1].high, box[2].high, box[3].high, box[4].high, box[5].high,
                   box[6].high, box[7].high),
        high);
}

/// Computes the slot boxes: exact boxes of clusters, and `child_box` of children.
template <typename ChildBox>
void box_slots(const Tree& tree, const Node& node, OpenedNode& opened, const ChildBox& child_box) {
  Box4 box[kMaxSlots], all = empty_box();
  std::uint32_t slot = 0;
  for (; slot < node.cluster_count; ++slot)
    box[slot] = cluster_box(tree, tree.clusters[node.first_cluster + slot], opened.positions);
  for (std::uint32_t child = 0; child < node.child_count; ++child, ++slot)
    box[slot] = child_box(node.first_child + child);
  for (std::uint32_t i = 0; i < slot; ++i) all = unite(all, box[i]);
  for (; slot < kMaxSlots; ++slot) box[slot] = empty_box();
  store4(opened.all_low, all.low);
  store4(opened.all_high, all.high);
  store_boxes(box, opened.low, opened.high, 0);
}

/// Returns the box of all vertices below a node.
Box4 box_below(const PosedTree& posed, std::uint32_t node) {
  if (!posed.given) return node_box(posed.bounds, node, posed.palette);
  const GivenBox& box = posed.given.boxes[node];
  return {load4(box.low), load4(box.high)};
}

Box4 triangle_box(const float* positions, const std::uint16_t* corners) {
  const Float4 a = load4(positions + corners[0]), b = load4(positions + corners[1]);
  const Float4 c = load4(positions + corners[2]);
  return {min(min(a, b), c), max(max(a, b), c)};
}

/// Calls `visit` with the posed vertices at these positions in the pools. Returns the number of
/// displacements by morph targets.
template <typename Visit>
std::uint64_t each_posed(const Tree& tree, const Palette& palette,
                         std::span<const std::uint32_t> at, const Visit& visit) {
  const VertexArrays arrays(tree);
  const Vec3* offsets = palette.offsets().data();
  const auto each = [&](auto&& rest_at) {
    for (const std::uint32_t place : at) {
      const Float4 p = arrays.pose(rest_at(place), place, palette);
      visit(offsets
                ? offset_vertex4(p, offsets[tree.place_vertices[place]], tree.offset_caps[place])
                : p);
    }
  };
  if (palette.morphs().any()) {
    MorphedRest morphed(tree, palette.morphs());
    each(morphed);
    return morphed.displacement_count();
  }
  const Vec3* rest = tree.rest_positions.data();
  each([=](std::uint32_t place) { return rest[place]; });
  return 0;
}

}  // namespace

const RootBox& root_box(const PosedTree& posed, QueryStats& work) {
  RootBox& root = posed.root_box;
  if (root.known) return root;
  ++work.refits;
  return root = box_root(posed.bounds, posed.palette, posed.given);
}

const OpenedNode& open_closed_node(const PosedTree& posed, std::uint32_t index, QueryStats& work) {
  const Node& node = posed.tree.nodes[index];
  QueryStats done;
  OpenedNode* opened = begin_node(posed, index, done);
  box_slots(posed.tree, node, *opened,
            [&](std::uint32_t child) { return box_below(posed, child); });
  const OpenedNode* first = posed.opened.publish(index, opened);
  if (first == opened) work += done;
  return *first;
}

void compute_triangle_boxes(const Tree& tree, const Cluster& cluster, const float* positions,
                            TriangleBoxes& boxes) {
  const std::uint16_t* corners = tree.corners[cluster.first_triangle].data();
  const std::uint32_t last = cluster.triangle_count - 1u;
  for (std::uint32_t first = 0; first < kMaxClusterTriangles; first += 8) {
    Box4 box[8];
    for (std::uint32_t i = 0; i < 8; ++i) {
      const std::size_t triangle = first + i < last ? first + i : last;
      box[i] = triangle_box(positions, corners + 3 * triangle);
    }
    store_boxes(box, boxes.low, boxes.high, first);
  }
}

const TriangleBoxes& box_triangles(const PosedTree& posed, const Node& node,
                                   const OpenedNode& opened, std::uint32_t slot) {
  auto* boxes = posed.arena.allocate<TriangleBoxes>();
  compute_triangle_boxes(posed.tree, posed.tree.clusters[node.first_cluster + slot],
                         opened.positions, *boxes);
  TriangleBoxes* first = nullptr;
  return opened.triangles[slot].compare_exchange_strong(first, boxes, std::memory_order_acq_rel)
             ? *boxes
             : *first;
}

QueryStats open_all(const PosedTree& posed) {
  QueryStats work;
  for (auto index = static_cast<std::uint32_t>(posed.tree.nodes.size()); index-- > 0;) {
    if (posed.opened[index]) continue;
    const Node& node = posed.tree.nodes[index];
    OpenedNode* opened = begin_node(posed, index, work);
    box_slots(posed.tree, node, *opened, [&](std::uint32_t child) {
      const OpenedNode& below = *posed.opened[child];
      return Box4{load4(below.all_low), load4(below.all_high)};
    });
    posed.opened.publish(index, opened);
  }
  if (posed.root_box.known) return work;
  const OpenedNode& root = *posed.opened[0];
  posed.root_box.known = true;
  store4(posed.root_box.low, load4(root.all_low));
  store4(posed.root_box.high, load4(root.all_high));
  return work;
}

void pose_vertices(const Tree& tree, const Palette& palette, std::span<Vec3> out) {
  std::size_t v = 0;
  each_posed(tree, palette, tree.vertex_places, [&](const Float4& p) {
    out[v++] = {p[0], p[1], p[2]};
  });
}

Box4 box_vertices(const Tree& tree, const Palette& palette, std::span<const std::uint32_t> at,
                  std::uint64_t& displacements) {
  Box4 box = empty_box();
  displacements += each_posed(tree, palette, at, [&](const Float4& p) {
    box = unite(box, {p, p});
  });
  return box;
}

QueryStats compute_all_bounds(const PosedTree& posed) {
  QueryStats work;
  root_box(posed, work);
  for (std::uint32_t index = 0; index < posed.tree.nodes.size(); ++index) {
    const OpenedNode& opened = open_node(posed, index, work);
    const Node& node = posed.tree.nodes[index];
    for (std::uint32_t slot = 0; slot < node.cluster_count; ++slot)
      triangle_boxes(posed, node, opened, slot);
  }
  return work;
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
