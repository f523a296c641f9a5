#include "model/check_tree.hpp"

#include "meshes.hpp"
#include "model/clusters.hpp"
#include "model/tree_build.hpp"
#include "model/unpack.hpp"

#include <algorithm>
#include <limits>

namespace pelt::detail {
namespace {

using test::Random;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// A few hundred triangles in several nodes, and an unused vertex.
Tree sound_tree() {
  auto shape = test::make_morphing_limb(30, 16, 4);
  test::split_vertex(shape, 5);
  shape.rest_positions.back() = {1, 2, 3};
  const SkinnedMesh mesh = test::mesh_of(shape);
  return build_tree(mesh, test::rest_only(mesh));
}

/// The first vertex with more than one influence.
std::uint32_t blended(const Tree& tree) {
  std::uint32_t p = 0;
  while (tree.influence_begin[p + 1] - tree.influence_begin[p] < 2) ++p;
  return p;
}

struct Breach {
  const char* words;  ///< of the message
  void (*commit)(Tree&);
};

const Breach kBreaches[] = {
    {"nodes or triangle_ids is empty", [](Tree& t) { t = {}; }},
    {"influence_begin has", [](Tree& t) { t.rest_positions.pop_back(); }},
    {"weights has", [](Tree& t) { t.weights.push_back(1); }},
    {"corners has", [](Tree& t) { t.corners.pop_back(); }},
    {"joint_count is 0", [](Tree& t) { t.joint_count = 0; }},
    {"joint_count is 65536", [](Tree& t) { t.joint_count = 65536; }},

    {"influence_begin[0] is 1", [](Tree& t) { t.influence_begin[0] = 1; }},
    {"rest_positions[3] has no influences",
     [](Tree& t) { t.influence_begin[4] = t.influence_begin[3]; }},
    {"has no influences", [](Tree& t) { t.influence_begin[4] = 0xFFFFFFFF; }},
    {"influence_begin ends", [](Tree& t) { t.joints.push_back(0), t.weights.push_back(1); }},

    {"rest_positions[2] has the coordinate nan", [](Tree& t) { t.rest_positions[2].y = kNan; }},
    {"rest_positions[2] has the coordinate inf",
     [](Tree& t) { t.rest_positions[2].z = std::numeric_limits<float>::infinity(); }},
    {"rest_extent is", [](Tree& t) { t.rest_extent *= 0.5f; }},
    {"rest_extent is nan", [](Tree& t) { t.rest_extent = kNan; }},
    {"rest_extent is inf", [](Tree& t) { t.rest_extent = std::numeric_limits<float>::infinity(); }},
    {"joints[0] is 4, but joint_count is 4", [](Tree& t) { t.joints[0] = 4; }},
    {"does not ascend",
     [](Tree& t) {
       const std::uint32_t i = t.influence_begin[blended(t)];
       std::swap(t.joints[i], t.joints[i + 1]);
     }},
    {"does not ascend",
     [](Tree& t) {
       const std::uint32_t i = t.influence_begin[blended(t)];
       t.joints[i + 1] = t.joints[i];
     }},
    {"weights[0] is 0", [](Tree& t) { t.weights[0] = 0; }},
    {"weights[0] is -", [](Tree& t) { t.weights[0] = -t.weights[0]; }},
    {"weights[0] is nan", [](Tree& t) { t.weights[0] = kNan; }},
    {"weights of vertex", [](Tree& t) { t.weights[0] += 0x1p-10f; }},

    {"nodes[0] has 0 slots",
     [](Tree& t) { t.nodes[0].cluster_count = t.nodes[0].child_count = 0; }},
    {"nodes[0] has 9 slots",
     [](Tree& t) { t.nodes[0].cluster_count = 9, t.nodes[0].child_count = 0; }},
    {"nodes[0].first_child is 0, expected 1", [](Tree& t) { t.nodes[0].first_child = 0; }},
    {"nodes[1].first_child is", [](Tree& t) { t.nodes[1].first_child = 1; }},
    {"nodes[1].first_cluster is", [](Tree& t) { ++t.nodes[1].first_cluster; }},
    {"nodes[1].first_vertex is", [](Tree& t) { --t.nodes[1].first_vertex; }},
    {"has no parent",
     [](Tree& t) {
       Node lost = t.nodes.back();
       lost.first_vertex += lost.vertex_count, lost.vertex_count = 0;
       lost.first_cluster += lost.cluster_count;
       lost.first_child = static_cast<std::uint32_t>(t.nodes.size());
       t.nodes.push_back(lost);
     }},
    {"children beyond the last node", [](Tree& t) { t.nodes.pop_back(); }},
    {"children beyond the last node", [](Tree& t) { ++t.nodes.back().child_count; }},
    {"is too deep",
     [](Tree& t) {  // one child below the other
       const std::size_t length = kMaxClusterTreeDepth + 1;
       t.nodes.assign(length, {.child_count = 1});
       for (std::uint32_t n = 0; n < length; ++n) t.nodes[n].first_child = n + 1;
     }},
    {"nodes have", [](Tree& t) { t.clusters.push_back(t.clusters.back()); }},
    {"pools have", [](Tree& t) { t.nodes.back().vertex_count = 0xFFFF; }},

    {"clusters[0] has 0 triangles", [](Tree& t) { t.clusters[0].triangle_count = 0; }},
    {"clusters[0] has 17 triangles", [](Tree& t) { t.clusters[0].triangle_count = 17; }},
    {"clusters[1].first_triangle is", [](Tree& t) { ++t.clusters[1].first_triangle; }},
    {"clusters[1].first_vertex is", [](Tree& t) { --t.clusters[1].first_vertex; }},
    {"clusters have",
     [](Tree& t) {
       t.corners.push_back(t.corners.back());
       t.triangle_ids.push_back(0);
     }},
    {"clusters have", [](Tree& t) { t.cluster_vertices.push_back(0); }},

    {"corners[0] has 65535", [](Tree& t) { t.corners[0][1] = 65535; }},
    {"not one of its cluster_vertices",
     [](Tree& t) {  // a vertex of another cluster
       const Node& node = *std::find_if(t.nodes.begin(), t.nodes.end(),
                                        [](const Node& n) { return n.cluster_count > 1; });
       const Cluster* cluster = &t.clusters[node.first_cluster];
       const auto begin = t.cluster_vertices.begin() + cluster[0].first_vertex;
       const auto end = begin + cluster[0].vertex_count;
       const auto foreign = std::find_if(end, end + cluster[1].vertex_count, [&](std::uint16_t v) {
         return std::find(begin, end, v) == end;
       });
       t.corners[cluster[0].first_triangle][0] = *foreign;
     }},
    {"cluster_vertices[1] is", [](Tree& t) { t.cluster_vertices[1] = t.cluster_vertices[0]; }},
    {"cluster_vertices[0] is 65535", [](Tree& t) { t.cluster_vertices[0] = 65535; }},
    {"clusters[0] has",
     [](Tree& t) {  // a vertex that no triangle uses any more
       const std::uint16_t gone = t.cluster_vertices[0];
       const std::uint16_t other = t.cluster_vertices[1];
       for (std::uint32_t i = 0; i < t.clusters[0].triangle_count; ++i)
         std::replace(t.corners[i].begin(), t.corners[i].end(), gone, other);
     }},
    {"has no triangle",
     [](Tree& t) {  // the last pool has the unused vertex
       ++t.nodes.back().vertex_count;
     }},
    {"has fewer influences than the one before it",
     [](Tree& t) {
       // Vertex `p` has one influence, and the vertices before it have two.
       const Node& node = t.nodes.back();
       const std::uint32_t p = node.first_vertex + node.vertex_count - 1;
       const std::uint32_t begin = t.influence_begin[p], end = t.influence_begin[p + 1];
       t.weights[begin] = 1;
       t.joints.erase(t.joints.begin() + begin + 1, t.joints.begin() + end);
       t.weights.erase(t.weights.begin() + begin + 1, t.weights.begin() + end);
       for (std::size_t q = p + 1; q < t.influence_begin.size(); ++q)
         t.influence_begin[q] -= end - begin - 1;
     }},

    {"triangle_ids[0] is 4000000000", [](Tree& t) { t.triangle_ids[0] = 4000000000; }},
    {"a repetition", [](Tree& t) { t.triangle_ids[7] = t.triangle_ids[8]; }},
    {"vertex_places[5] is", [](Tree& t) { t.vertex_places[5] = 0xFFFFFFFF; }},

    {"is twice in the pool of nodes[",
     [](Tree& t) {
       const Node& node = *std::find_if(t.nodes.begin(), t.nodes.end(),
                                        [](const Node& n) { return n.vertex_count > 1; });
       t.place_vertices[node.first_vertex + 1] = t.place_vertices[node.first_vertex];
     }},
    {"outside the pools is a duplicate",
     [](Tree& t) {
       t.rest_positions.push_back(Vec3(t.rest_positions.back()));
       const std::uint32_t begin = *(t.influence_begin.end() - 2), end = t.influence_begin.back();
       for (std::uint32_t i = begin; i < end; ++i) {
         t.joints.push_back(std::uint16_t{t.joints[i]});
         t.weights.push_back(float{t.weights[i]});
       }
       t.influence_begin.push_back(2 * end - begin);
       t.place_vertices.push_back(std::uint32_t{t.place_vertices.back()});
     }},
    {"place_vertices has", [](Tree& t) { t.place_vertices.pop_back(); }},
    {"place_vertices[3] is 4000000000", [](Tree& t) { t.place_vertices[3] = 4000000000; }},
    {"offset_caps has 1 elements", [](Tree& t) { t.offset_caps = {1}; }},
    {"offset_caps[2] is nan",
     [](Tree& t) {
       t.offset_caps.resize(t.rest_positions.size());
       t.offset_caps[2] = kNan;
     }},
    {"offset_caps[0] is -1", [](Tree& t) { t.offset_caps.assign(t.rest_positions.size(), -1.0f); }},
    {"is not that of vertex", [](Tree& t) { std::swap(t.place_vertices[0], t.place_vertices[1]); }},
    {"morphs.extents has 65536", [](Tree& t) { t.morphs.extents.resize(65536); }},
    {"node_begin has", [](Tree& t) { t.morphs.node_begin.pop_back(); }},
    {"but extents has none", [](Tree& t) { t.morphs.extents = {}, t.morphs.node_begin = {}; }},
    {"node_begin goes from 1", [](Tree& t) { t.morphs.node_begin[0] = 1; }},
    {"node_begin goes from 0", [](Tree& t) { t.morphs.targets.push_back({}); }},
    {"node_begin[2] is less", [](Tree& t) { t.morphs.node_begin[1] = 99; }},
    {"targets[1] does not ascend", [](Tree& t) { t.morphs.targets[0].target = 2; }},
    {"is of target 9 of 3", [](Tree& t) { t.morphs.targets.back().target = 9; }},
    {"targets[0] has", [](Tree& t) { t.morphs.targets[0].first_displacement = 1; }},
    {"targets[0] has 0 displacements", [](Tree& t) { t.morphs.targets[0].displacement_count = 0; }},
    {"expected some from", [](Tree& t) { t.morphs.targets[1].displacement_count = 0xFFFFFFFF; }},
    {"targets have",
     [](Tree& t) {
       t.morphs.displacements.push_back({{1, 0, 0}, 0});
     }},
    {"out of the pool", [](Tree& t) { t.morphs.displacements.back().place = 0; }},
    {"out of the pool", [](Tree& t) { t.morphs.displacements[0].place = 0xFFFFFFFF; }},
    {"displacements[1].place is",
     [](Tree& t) { t.morphs.displacements[1].place = t.morphs.displacements[0].place; }},
    {"displacements[2] has the coordinate nan",
     [](Tree& t) { t.morphs.displacements[2].by.z = kNan; }},
    {"displacements[2] is zero", [](Tree& t) { t.morphs.displacements[2].by = {}; }},
    {"extents[1] is", [](Tree& t) { t.morphs.extents[1] *= 0.5f; }},
    {"extents[1] is nan", [](Tree& t) { t.morphs.extents[1] = kNan; }},
    {"is not that of vertex", [](Tree& t) { t.vertex_places.back() = 0; }},
    {"but there are 0 vertex_places", [](Tree& t) { t.vertex_places.clear(); }},
};

TEST(CheckTree, FindsNothingInASoundTree) {
  const Tree tree = sound_tree();
  EXPECT_GT(tree.nodes.size(), 5u);
  EXPECT_EQ(check_tree(tree), "");
}

TEST(CheckTree, FindsEveryBreach) {
  for (const Breach& breach : kBreaches) {
    Tree tree = sound_tree();
    breach.commit(tree);
    EXPECT_NE(check_tree(tree).find(breach.words), std::string::npos)
        << "expected: " << breach.words << "\nfound:    " << check_tree(tree);
  }
}

template <typename T>
void damage(std::vector<T>& array, Random& random) {
  if (array.empty()) return;
  auto* bytes = reinterpret_cast<unsigned char*>(array.data());
  const std::size_t at = random.index(static_cast<std::uint32_t>(array.size() * sizeof(T)));
  bytes[at] = static_cast<unsigned char>(random.bits());
}

template <typename T>
void change_length(std::vector<T>& array, Random& random) {
  array.resize(random.index(static_cast<std::uint32_t>(2 * array.size() + 1)));
}

template <typename Change>
void change_one_array(Tree& tree, Random& random, Change change) {
  switch (random.index(11)) {
    case 0:
      return change(tree.rest_positions);
    case 1:
      return change(tree.influence_begin);
    case 2:
      return change(tree.joints);
    case 3:
      return change(tree.weights);
    case 4:
      return change(tree.corners);
    case 5:
      return change(tree.triangle_ids);
    case 6:
      return change(tree.cluster_vertices);
    case 7:
      return change(tree.clusters);
    case 8:
      return change(tree.nodes);
    case 9:
      return change(tree.place_vertices);
    default:
      return change(tree.vertex_places);
  }
}

/// For the sanitizers: nothing is read out of bounds, and whatever passes can be unpacked.
TEST(CheckTree, IsNotLedAstrayByDamage) {
  Random random(84);
  const Tree sound = sound_tree();
  int passed = 0, found = 0;
  for (int round = 0; round < 3000; ++round) {
    Tree tree = sound;
    const std::uint32_t changes = 1 + random.index(3);
    for (std::uint32_t i = 0; i < changes; ++i) {
      if (random.chance(0.9))
        change_one_array(tree, random, [&](auto& array) { damage(array, random); });
      else
        change_one_array(tree, random, [&](auto& array) { change_length(array, random); });
    }
    if (!check_tree(tree).empty()) {
      ++found;
      continue;
    }
    ++passed;
    EXPECT_EQ(unpack_mesh(tree).triangle_count(), sound.triangle_count());
  }
  EXPECT_GT(found, 1500);
  EXPECT_GT(passed, 50) << "a bit of a position, most often";
}

}  // namespace
}  // namespace pelt::detail
